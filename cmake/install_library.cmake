# What find_package(lapilli) needs: library, headers, and a file that finds what they stand on.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lapilli)
install(TARGETS lapilli EXPORT lapilliTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cpp/lapilli DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" PATTERN "hdf5_*.hpp" EXCLUDE)
install(EXPORT lapilliTargets NAMESPACE lapilli:: DESTINATION ${config_folder})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lapilliConfig.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/lapilliConfig.cmake
                              INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/lapilliConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lapilliConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/lapilliConfigVersion.cmake DESTINATION ${config_folder})
