#pragma once

#include <filesystem>
#include <string>

#include "support/scratch.hpp"

#include "ramify/model/registry.hpp"

namespace ramify::test {

/// A table of split laws on disk, removed at the end.
class SplitTableFile {
 public:
  explicit SplitTableFile(const std::string& text) : path_(scratch_.file("law (of splits, n).csv", text)) {}

  const std::filesystem::path& path() const { return path_; }
  Model model() const { return Model::parse("file(" + path_.string() + ")"); }

 private:
  Scratch scratch_;
  std::filesystem::path path_;
};

/// The split laws of a model as such a table, n = 2..largest, with 17 digits.
std::string split_table_of(const Model& model, Size largest);

}  // namespace ramify::test
