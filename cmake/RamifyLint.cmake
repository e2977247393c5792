# What scripts/lint reads (preset lint): the sources of several folders as one, for most of clang-tidy's time goes to other people's
# headers. Names in unnamed namespaces differ within a group; a folder that is in none is an error. Included last.
set(groups
  "core optimise text random tree format"
  "model estimate statistic law"
  "large sample theory accumulate compare shape"
  "config io page report draw measure run"
  "family tabulate gallery design fit horton dossier ranks"
  "experiments"
  "cli")

get_property(left GLOBAL PROPERTY RAMIFY_MODULES)
foreach(group IN LISTS groups)
  string(REPLACE " " "_" name "ramify_lint_${group}")
  string(REPLACE " " ";" folders "${group}")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  foreach(folder IN LISTS folders)
    list(REMOVE_ITEM left ${folder})
    set(target ramify_${folder})
    if(folder STREQUAL "cli")
      set(target ramify)
    endif()
    get_target_property(place ${target} SOURCE_DIR)
    get_target_property(sources ${target} SOURCES)
    list(TRANSFORM sources PREPEND ${place}/)
    target_sources(${name} PRIVATE ${sources})
    foreach(kind LINK_LIBRARIES COMPILE_DEFINITIONS INCLUDE_DIRECTORIES)
      get_target_property(of_target ${target} ${kind})
      if(of_target)
        set_property(TARGET ${name} APPEND PROPERTY ${kind} ${of_target})
      endif()
    endforeach()
  endforeach()
endforeach()
if(left)
  message(FATAL_ERROR "no group of cmake/RamifyLint.cmake has ${left}")
endif()
