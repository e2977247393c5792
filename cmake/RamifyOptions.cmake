# What every target of ramify is compiled with.
#   ramify_language  goes to users too: the standard, and the flags that decide what a double is
#   ramify_warnings  stays inside the build

add_library(ramify_language INTERFACE)
target_compile_features(ramify_language INTERFACE cxx_std_20)
# Same bytes on every machine that computes IEEE doubles: no fused multiply-add behind our back.
target_compile_options(ramify_language INTERFACE -ffp-contract=off)
set_target_properties(ramify_language PROPERTIES EXPORT_NAME language)
install(TARGETS ramify_language EXPORT ramifyTargets)

add_library(ramify_warnings INTERFACE)
# GCC 12 sees copies that overlap in its own std::string (PR 105651); Clang sees its std::stable_sort call what is deprecated.
target_compile_options(ramify_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations> $<$<BOOL:${RAMIFY_WERROR}>:-Werror>)

# The headers of the standard library and of Boost cost more than our code: read once for eight sources, the whole is compiled
# in a third of the time. An error names its own file and line as ever. Off (preset dev) every source is compiled by itself, and
# a small change is built fastest.
option(RAMIFY_UNITY "Compile sources of a target as one" OFF)
function(ramify_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${RAMIFY_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# For what is not measured (the command line, readers of configs, tables, constants, the tests): compiled in two thirds of the time,
# with the same bytes. At -O1 GCC 12 sees copies that run over in its own std::string and std::vector (PR 105329); the library, at -O3,
# is watched for them.
add_library(ramify_unhurried INTERFACE)
if(NOT RAMIFY_SANITIZE)
  target_compile_options(ramify_unhurried INTERFACE
    $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>)
endif()

if(RAMIFY_CONTRACTS)
  target_compile_definitions(ramify_language INTERFACE $<BUILD_INTERFACE:RAMIFY_CONTRACTS=1>)
endif()

if(RAMIFY_SANITIZE)
  # -O1 and line numbers alone: instrumented templates take half the time to compile, and the build is most of it.
  add_compile_options(-fsanitize=${RAMIFY_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -O1 -g1)
  add_link_options(-fsanitize=${RAMIFY_SANITIZE})
  # Of what is undefined, three checks that stand at every pointer: the address sanitizer sees a null and the end of an object itself,
  # and without them sources full of templates compile in two thirds of the time.
  if(RAMIFY_SANITIZE MATCHES "address" AND RAMIFY_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=null,object-size,vptr)
  endif()
endif()

find_program(RAMIFY_CCACHE ccache)
if(RAMIFY_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${RAMIFY_CCACHE})
endif()
