# Headers of others that most sources read, compiled once for all targets of a group: by the first of
# them, with its flags. Levels -O1 to -O3 may share them, -Os may not.
set(lapilli_headers <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <algorithm> <array> <cmath> <filesystem>
                    <functional> <map> <memory> <optional> <span> <sstream> <string> <variant> <vector>)

function(lapilli_precompiled_headers target group)
  if(NOT LAPILLI_UNITY OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  get_property(owner GLOBAL PROPERTY LAPILLI_HEADERS_OF_${group})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY LAPILLI_HEADERS_OF_${group} ${target})
  endif()
  if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    # It knows precompiled headers only where it may pass over times of files and unused macros.
    set_target_properties(
      ${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CMAKE_CXX_COMPILER_LAUNCHER}")
  endif()
endfunction()
