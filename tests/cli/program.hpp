#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "support/scratch.hpp"

namespace ramify::test {

/// What a command printed, and its exit code.
struct Ran {
  int code;
  std::string out;
  std::string err;
};

/// What Open MPI's mpirun wants to hear before it runs as root, as CI does.
inline const std::string mpi_as_root = "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ";

/// Runs "ramify <arguments>" through the shell, with the project as working folder.
Ran ramify(const std::string& arguments);

/// Runs any shell command so.
Ran shell(const std::string& command);

/// A line without --threads gives the same on one thread and on three.
void expect_same_on_any_threads(const std::string& line);

std::string read_file(const std::filesystem::path& path);

bool holds(const std::string& text, const std::string& part);

/// Lines of a text.
std::size_t count_lines(const std::string& text);

/// Of letters, digits and _: the name of a parameterised test.
std::string name_of(std::initializer_list<std::string> parts);

}  // namespace ramify::test
