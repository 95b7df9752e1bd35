# The processor level that everything is compiled for, LAPILLI_MARCH: with AVX2, unless the processor
# that builds has none or is of another kind.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceRuns)
include(CheckLinkerFlag)

if(LAPILLI_KERNEL_SETS)
  list(GET LAPILLI_KERNEL_SETS 0 LAPILLI_MARCH)  # of all but kernels
  return()
endif()

if(NOT DEFINED LAPILLI_MARCH)
  check_cxx_source_runs(
    "int main() {
       __builtin_cpu_init();
       const bool is_v3 = __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") &&
                          __builtin_cpu_supports(\"bmi2\");
       return is_v3 ? 0 : 1;
     }"
    LAPILLI_BUILDS_ON_V3)
  if(LAPILLI_BUILDS_ON_V3)
    set(level x86-64-v3)
  endif()
endif()
set(LAPILLI_MARCH "${level}" CACHE STRING "Processor level to compile for; empty for the compiler's default")
if(LAPILLI_MARCH)
  check_cxx_compiler_flag(-march=${LAPILLI_MARCH} LAPILLI_MARCH_WORKS)
  if(NOT LAPILLI_MARCH_WORKS)
    set(LAPILLI_MARCH "")
  endif()
endif()

# The loader of the C library refuses, in words, what asks for a level that the processor lacks.
if(LAPILLI_MARCH MATCHES "^x86-64-v[234]$")
  check_linker_flag(CXX -Wl,-z,${LAPILLI_MARCH} LAPILLI_LEVEL_CAN_BE_MARKED)
  if(LAPILLI_LEVEL_CAN_BE_MARKED)
    set(lapilli_level_mark -Wl,-z,${LAPILLI_MARCH})
  endif()
endif()
