# HDF5 and libpng linked as archives, for wheels: of HDF5 only what is called comes along, not curl
# and OpenSSL, on which the shared library of Debian stands. Without archives the shared ones serve.
foreach(archive hdf5 sz aec png)
  find_library(LAPILLI_${archive}_ARCHIVE lib${archive}.a PATH_SUFFIXES hdf5/serial)
  if(NOT LAPILLI_${archive}_ARCHIVE)
    message(STATUS "HDF5 and libpng are linked as shared libraries: there is no lib${archive}.a")
    return()
  endif()
endforeach()

add_library(lapilli_archives INTERFACE)
target_include_directories(lapilli_archives SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS} ${PNG_INCLUDE_DIRS})
target_link_libraries(lapilli_archives INTERFACE ${LAPILLI_hdf5_ARCHIVE} ${LAPILLI_sz_ARCHIVE}
                      ${LAPILLI_aec_ARCHIVE} ${LAPILLI_png_ARCHIVE} ZLIB::ZLIB ${CMAKE_DL_LIBS} m)
set(lapilli_hdf5 lapilli_archives)
set(lapilli_png lapilli_archives)

# A shared module that holds the archives and shows none of their names: h5py brings another HDF5.
# Debian compiles them for executables, where the address of the standard streams is fixed when
# linking; in a module those names go to two pointers of its own.
function(lapilli_hide_archives target)
  target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/standard_streams.c)
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL -Wl,--gc-sections
                                        -Wl,--wrap=stderr -Wl,--wrap=stdout)
endfunction()
