# Called by CTest: install, configure, build, run, compare. Every step starts from an empty folder.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${SCRATCH}/build -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  -DRAMIFY_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)

# A package that still leans on the build tree would work here and nowhere else.
file(GLOB_RECURSE files ${prefix}/*.cmake ${prefix}/*.hpp)
foreach(file IN LISTS files)
  file(STRINGS ${file} leaks REGEX "${BUILD}")
  if(leaks)
    message(FATAL_ERROR "${file} names the build tree: ${leaks}")
  endif()
endforeach()

run(${SCRATCH}/build/grow_a_tree)
# The streams of this deterministic tree are counted by hand in the catalogue (A6).
set(expected "split(1/4.35), n = 579: order 5, streams 580 186 46 11 3 1\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "grow_a_tree printed\n${output}instead of\n${expected}")
endif()

run(${prefix}/bin/ramify list models)
if(NOT output MATCHES "patricia")
  message(FATAL_ERROR "the installed ramify does not list its models:\n${output}")
endif()
