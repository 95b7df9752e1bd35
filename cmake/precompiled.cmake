# Headers that most sources of a target read (PRIVATE ...), parsed once for it, or those of another one
# (REUSE_FROM ...). Each level of optimisation has its own: those of another level change the code. Not
# without batches, so that every source still says what it includes.
function(lapilli_precompiled_headers target)
  if(NOT LAPILLI_UNITY OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  target_precompile_headers(${target} ${ARGN})
  if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    # It knows precompiled headers only where it may pass over times of files and unused macros.
    set_target_properties(
      ${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CMAKE_CXX_COMPILER_LAUNCHER}")
  endif()
endfunction()
