# Headers that most sources of a target read, parsed once for it. Each level of optimisation has its
# own: those of another level change the code. Not with sanitizers and not without batches, so that
# every source still says what it includes.
function(lapilli_precompiled_headers target)
  if(NOT LAPILLI_UNITY OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${ARGN})
  lapilli_precompiled_in_cache(${target})
endfunction()

# ccache knows precompiled headers only where it may pass over times of files and unused macros.
function(lapilli_precompiled_in_cache target)
  if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    set_target_properties(
      ${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CMAKE_CXX_COMPILER_LAUNCHER}")
  endif()
endfunction()
