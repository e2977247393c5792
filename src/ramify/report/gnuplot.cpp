#include "ramify/report/gnuplot.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ramify::detail {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string last_line(std::FILE* file) {
  std::string line, last;
  if (std::fseek(file, 0, SEEK_SET) != 0) return last;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    if (c != '\n') {
      line += static_cast<char>(c);
    } else if (!line.empty()) {
      last = std::move(line);
      line.clear();
    }
  }
  return line.empty() ? last : line;
}

int exit_code(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return not_installed;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::string gnuplot_complaint(int exit_code, const std::string& said) {
  return exit_code == not_installed ? "gnuplot is not installed" : "gnuplot failed: " + said;
}

ProgramResult run_gnuplot(const std::filesystem::path& folder, std::string_view script) {
  // The shell changes the folder for us; names reach it as arguments, so nothing in them is a command.
  // LC_ALL=C keeps decimal points and messages as they are, GNUTERM and a user's settings are left out.
  std::string command = "cd -- \"$1\" && LC_ALL=C exec gnuplot -d \"$2\"";
  std::string shell = "sh", flag = "-c", where = folder.empty() ? "." : folder.string(), what(script);
  const std::array<char*, 7> arguments{shell.data(), flag.data(), command.data(), shell.data(),
                                       where.data(), what.data(), nullptr};
  const File output(std::tmpfile(), &std::fclose);
  if (!output) return {not_installed, "no temporary file"};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(output.get()), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(output.get()), STDERR_FILENO);
  pid_t child = 0;
  const int spawned = ::posix_spawn(&child, "/bin/sh", &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (spawned != 0) return {not_installed, "no shell"};
  const int code = exit_code(child);
  return {code, last_line(output.get())};
}

}  // namespace ramify::detail
