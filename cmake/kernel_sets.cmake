# The library as shared objects, its kernels once for every level of LAPILLI_KERNEL_SETS, under one
# name: the loader of the C library takes that of the highest level that the processor has, from
# glibc-hwcaps/<level>, or the first one, beside the rest. Module and executable share them.
set(least_level ${LAPILLI_MARCH})
set(CMAKE_CXX_VISIBILITY_PRESET default)  # what is shown is said by exports.map
string(APPEND CMAKE_CXX_FLAGS " -fno-semantic-interposition -ffunction-sections -fdata-sections")
set(exports ${PROJECT_SOURCE_DIR}/cmake/exports.map)
set(share_options -Wl,-Bsymbolic-functions -Wl,--gc-sections -Wl,-O1
                  -Wl,--version-script=${exports})

foreach(level IN LISTS LAPILLI_KERNEL_SETS)
  set(LAPILLI_MARCH ${level})
  lapilli_kernels(lapilli_kernels_${level})
  add_library(kernels_${level} SHARED $<TARGET_OBJECTS:lapilli_kernels_${level}_fused>
                                      $<TARGET_OBJECTS:lapilli_kernels_${level}>)
  target_link_libraries(kernels_${level} PRIVATE OpenMP::OpenMP_CXX)
  target_link_options(kernels_${level} PRIVATE ${share_options})
  if(level STREQUAL least_level)
    # For processors that are rare by now: small rather than fast.
    foreach(part lapilli_kernels_${level}_fused lapilli_kernels_${level})
      target_compile_options(${part} PRIVATE $<$<CONFIG:Release>:-Os>)
    endforeach()
    set(folder "")
  else()
    set(folder /glibc-hwcaps/${level})
  endif()
  set_target_properties(kernels_${level} PROPERTIES OUTPUT_NAME lapilli_kernels LINKER_LANGUAGE CXX
                        LINK_DEPENDS ${exports}
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/lib${folder})
  install(TARGETS kernels_${level} LIBRARY DESTINATION lapilli${folder})
endforeach()

set(LAPILLI_MARCH ${least_level})
lapilli_rest()
add_library(lapilli SHARED ${rest_objects})
lapilli_library_settings(lapilli)
target_link_libraries(lapilli PUBLIC kernels_${least_level})
target_link_options(lapilli PRIVATE ${share_options})
if(TARGET lapilli_archives)
  lapilli_hide_archives(lapilli)
endif()
set_target_properties(lapilli PROPERTIES INSTALL_RPATH "$ORIGIN" LINK_DEPENDS ${exports}
                      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/lib)
install(TARGETS lapilli LIBRARY DESTINATION lapilli)
