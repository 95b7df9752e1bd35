# Flags of every target.
function(lapilli_compiler_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                           -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Eigen 3.4.0's matrix-vector product trips it from inside, at sizes that cannot occur.
    target_compile_options(${target} PRIVATE -Wno-aggressive-loop-optimizations)
    # It collects its garbage later: a tenth of the time, and nothing else changes.
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-heapsize=400000")
  endif()
  target_compile_options(${target} PRIVATE -fno-math-errno -ffp-contract=off)
  if(LAPILLI_MARCH)
    target_compile_options(${target} PRIVATE -march=${LAPILLI_MARCH})
  endif()
  if(NOT LAPILLI_MARCH MATCHES "-v[34]$")
    # Without AVX four numbers at once are handed over in memory; both sides are of one level.
    target_compile_options(${target} PRIVATE -Wno-psabi)
  endif()
  if(LAPILLI_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LAPILLI_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${LAPILLI_SANITIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Instrumented code trips the analysis of variants that are never read while empty.
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
endfunction()
