#include "support/scratch.hpp"

#include <fstream>

#include <stdlib.h>

namespace ramify::test {

Scratch::Scratch() {
  std::string pattern = (std::filesystem::temp_directory_path() / "ramify-XXXXXX").string();
  path_ = mkdtemp(pattern.data());
}

std::string Scratch::file(const std::string& name, const std::string& content) const {
  const auto path = path_ / name;
  std::ofstream(path, std::ios::binary) << content;
  return path.string();
}

}  // namespace ramify::test
