#include "support/tree_files.hpp"

#include <cstdlib>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify::test {

std::vector<RecordedTree> trees_of(std::string_view text, const ReadOptions& options) {
  Remarks remarks;
  return read_trees(text, "f", std::nullopt, options, remarks);
}

RecordedTree tree_of(std::string_view text, const ReadOptions& options) {
  auto trees = trees_of(text, options);
  EXPECT_EQ(trees.size(), 1u);
  return trees.front();
}

std::string word_of(std::string_view text, const ReadOptions& options) {
  return to_parentheses(tree_of(text, options).tree);
}

std::string refusal_of(std::string_view text, const ReadOptions& options, std::optional<TreeFormat> format) {
  const std::string message = error_of([&] {
    Remarks remarks;
    read_trees(text, "f", format, options, remarks);
  });
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

std::string remarks_of(std::string_view text, const ReadOptions& options) {
  Remarks remarks;
  read_trees(text, "f", std::nullopt, options, remarks);
  std::string lines;
  for (const std::string& line : remarks.lines("f")) lines += line + '\n';
  return lines;
}

std::string shared_file(const std::string& name) {
  const char* folder = std::getenv("RAMIFY_SHARED");
  return folder == nullptr ? std::string() : std::string(folder) + "/trees/" + name;
}

}  // namespace ramify::test
