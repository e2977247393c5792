#include "program.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace ramify::test {

Ran shell(const std::string& command) {
  const Scratch scratch;
  const std::string out = (scratch / "out").string(), err = (scratch / "err").string();
  std::ostringstream line;
  line << "cd '" << RAMIFY_SOURCE << "' && { " << command << " ; } >" << out << " 2>" << err << " </dev/null";
  const int status = std::system(line.str().c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(out), read_file(err)};
}

Ran ramify(const std::string& arguments) {
  std::ostringstream command;
  command << RAMIFY_PROGRAM << ' ' << arguments;
  return shell(command.str());
}

void expect_same_on_any_threads(const std::string& line) {
  const Ran one = ramify(line + " --threads 1"), three = ramify(line + " --threads 3");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, three.out);
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::string name_of(std::initializer_list<std::string> parts) {
  std::string name;
  for (const auto& part : parts) {
    for (const char c : part + '_') {
      const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
      if (letter || (!name.empty() && name.back() != '_')) name += letter ? c : '_';
    }
  }
  name.pop_back();
  return name;
}

}  // namespace ramify::test
