# What `cmake --install` puts beside the program, for find_package(sluice): the libraries, their headers and this
# project's own description of them.
include(CMakePackageConfigHelpers)
set(to ${CMAKE_INSTALL_LIBDIR}/cmake/sluice)
file(GLOB headers CONFIGURE_DEPENDS sluice/*.hpp)
install(FILES ${headers} DESTINATION include/sluice)
install(EXPORT sluice NAMESPACE sluice:: DESTINATION ${to} FILE sluice-targets.cmake)
configure_package_config_file(cmake/sluice-config.cmake.in ${PROJECT_BINARY_DIR}/sluice-config.cmake
  INSTALL_DESTINATION ${to} PATH_VARS CMAKE_INSTALL_DATADIR)
# Before version 1 a new minor version may break what was built on the one before.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sluice-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sluice-config.cmake ${PROJECT_BINARY_DIR}/sluice-config-version.cmake DESTINATION ${to})
