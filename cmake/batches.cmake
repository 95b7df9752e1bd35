# Batches of sources that the compiler reads at once: most of the time of a small file goes into
# headers that its neighbours include too. A batch keeps to one folder, so that a new file moves
# files of its own folder only. What is named after `size` stays by itself.
function(lapilli_batch target size)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source IN_LIST ARGN)
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(REPLACE "/" "_" folder ${folder})
    if(NOT DEFINED count_${folder})
      set(count_${folder} 0)
    endif()
    math(EXPR batch "${count_${folder}} / ${size}")
    math(EXPR count_${folder} "${count_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${batch})
  endforeach()
  if(LAPILLI_UNITY)
    # Among neighbours both would speak of what is right: names without linkage of other files. Builds
    # without batches, as those with sanitizers, keep them.
    target_compile_options(${target} PRIVATE -Wno-shadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${LAPILLI_UNITY} UNITY_BUILD_MODE GROUP)
endfunction()
