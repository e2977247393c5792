#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ramify::detail {

/// What the shell says of a program that is not there.
inline constexpr int not_installed = 127;

/// How a program ended and what it said.
struct ProgramResult {
  int exit_code;       ///< not_installed where there is none; 128 + signal where it was killed
  std::string output;  ///< the last line it printed that is not empty
};

/// What is wrong where gnuplot ended with an exit code other than 0, or drew nothing.
std::string gnuplot_complaint(int exit_code, const std::string& said);

/// Runs gnuplot on a script in a folder, so that the pictures land beside it.
ProgramResult run_gnuplot(const std::filesystem::path& folder, std::string_view script);

}  // namespace ramify::detail
