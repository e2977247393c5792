# find_package(ramify) for users; tests/consumer proves it.
include(CMakePackageConfigHelpers)
set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/ramify)
install(EXPORT ramifyTargets NAMESPACE ramify:: DESTINATION ${destination})

get_property(RAMIFY_MODULES GLOBAL PROPERTY RAMIFY_MODULES)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ramifyConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ramifyConfig.cmake INSTALL_DESTINATION ${destination})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ramifyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ramifyConfig.cmake ${PROJECT_BINARY_DIR}/ramifyConfigVersion.cmake
  DESTINATION ${destination})
