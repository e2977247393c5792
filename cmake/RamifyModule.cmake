# One static library per folder of src/ramify, named ramify::<folder>. Its links are the ladder of
# docs/design.md: a module can include only what it links.
#   ramify_module(tree SOURCES a.cpp b.cpp LINKS ramify::random PRIVATE_LINKS fmt::fmt)
function(ramify_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target ramify_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} PUBLIC ramify_language ${ARG_LINKS}
      PRIVATE $<BUILD_INTERFACE:ramify_warnings> ${ARG_PRIVATE_LINKS})
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} INTERFACE ramify_language ${ARG_LINKS})
  endif()
  add_library(ramify::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT ramifyTargets)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ramify/${name} FILES_MATCHING PATTERN "*.hpp")
  set_property(GLOBAL APPEND PROPERTY RAMIFY_MODULES ${name})
endfunction()
