# One static library per folder of src/ramify, named ramify::<folder>. Its links are the ladder of
# docs/design.md: a module can include only what it links (tests/headers checks it).
#   ramify_module(tree SOURCES a.cpp b.cpp LINKS ramify::random PRIVATE_LINKS fmt::fmt)
# APART: every source by itself even in a unity build, for those whose templates take longer than their headers.
# UNHURRIED: what takes no time that anybody measures (ramify_unhurried).

# Private links that leave nothing to link: users of an installed ramify need not have them.
set(RAMIFY_HEADER_ONLY Boost::headers Eigen3::Eigen nlohmann_json::nlohmann_json)

function(ramify_module name)
  cmake_parse_arguments(ARG "APART;UNHURRIED" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target ramify_${name})
  set(private_links)
  foreach(link IN LISTS ARG_PRIVATE_LINKS)
    if(link IN_LIST RAMIFY_HEADER_ONLY)
      set(link $<BUILD_INTERFACE:${link}>)
    endif()
    list(APPEND private_links ${link})
  endforeach()
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    if(NOT ARG_APART)
      ramify_together(${target})
    endif()
    target_link_libraries(${target} PUBLIC ramify_language ${ARG_LINKS}
      PRIVATE $<BUILD_INTERFACE:ramify_warnings> $<$<BOOL:${ARG_UNHURRIED}>:$<BUILD_INTERFACE:ramify_unhurried>> ${private_links})
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
  set_property(GLOBAL PROPERTY RAMIFY_LINKS_${name} ${ARG_LINKS} ${ARG_PRIVATE_LINKS})
endfunction()
