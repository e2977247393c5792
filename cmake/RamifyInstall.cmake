# find_package(ramify) for users; tests/consumer proves it.
include(CMakePackageConfigHelpers)
install(EXPORT ramifyTargets NAMESPACE ramify:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ramify)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ramifyConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ramifyConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ramify)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ramifyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ramifyConfig.cmake ${PROJECT_BINARY_DIR}/ramifyConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ramify)
