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

function(build_project source folder)
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${source} -B ${folder} -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -DRAMIFY_VERSION=${VERSION})
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()

# The text between a line "```language" of a page and the next "```".
function(block_of page language variable)
  file(READ ${page} text)
  set(fence "```${language}\n")
  string(FIND "${text}" "${fence}" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "${page} has no block of ${language}")
  endif()
  string(LENGTH "${fence}" length)
  math(EXPR begin "${begin} + ${length}")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "```" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
build_project(${SOURCE} ${SCRATCH}/build)

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

# The program of docs/library.md, as the page shows it, prints what the page says.
block_of(${PAGE} cmake lists)
block_of(${PAGE} cpp program)
file(WRITE ${SCRATCH}/page/CMakeLists.txt "${lists}")
file(WRITE ${SCRATCH}/page/cherries.cpp "${program}")
build_project(${SCRATCH}/page ${SCRATCH}/page/build)
run(${SCRATCH}/page/build/cherries)
string(STRIP "${output}" output)
file(READ ${PAGE} text)
string(FIND "${text}" "It prints `${output}`" place)
if(output STREQUAL "" OR place EQUAL -1)
  message(FATAL_ERROR "${PAGE} does not say what its program prints:\n${output}")
endif()

run(${prefix}/bin/ramify list models)
if(NOT output MATCHES "patricia")
  message(FATAL_ERROR "the installed ramify does not list its models:\n${output}")
endif()
