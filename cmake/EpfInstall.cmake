# Installs the library, its CMake package (find_package(epf CONFIG)) and its pkg-config file.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/epf)

install(TARGETS epf EXPORT epf-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/epf
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT epf-targets NAMESPACE epf:: FILE epf-config.cmake DESTINATION ${package_dir})

# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/epf-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epf-config-version.cmake DESTINATION ${package_dir})

# From the folder of epf.pc to the prefix, however deep the libraries lie
file(RELATIVE_PATH pc_to_prefix
    ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${PROJECT_SOURCE_DIR}/cmake/epf.pc.in epf.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
