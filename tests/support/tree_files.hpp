#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/format/read_trees.hpp"

namespace ramify {

/// As a test's parameter.
inline void PrintTo(TreeFormat format, std::ostream* out) {
  *out << name_of(format);
}

}  // namespace ramify

namespace ramify::test {

/// The trees of a text, format found by content.
std::vector<RecordedTree> trees_of(std::string_view text, const ReadOptions& options = {});

/// The one tree of a text.
RecordedTree tree_of(std::string_view text, const ReadOptions& options = {});

/// Its word of E and parentheses.
std::string word_of(std::string_view text, const ReadOptions& options = {});

/// What reading the text as file "f" says; empty where it reads. Also checks that it is one line.
std::string refusal_of(std::string_view text, const ReadOptions& options = {},
                       std::optional<TreeFormat> format = std::nullopt);

/// What is remarked when the text is read as file "f", each in a line.
std::string remarks_of(std::string_view text, const ReadOptions& options = {});

/// The file of the folder of measured trees that RAMIFY_SHARED names; empty where that is not set.
std::string shared_file(const std::string& name);

}  // namespace ramify::test

/// Ends a test, and says so, where there are no measured trees.
#define RAMIFY_NEEDS_SHARED_FILES()                         \
  if (std::getenv("RAMIFY_SHARED") == nullptr) /* NOLINT */ \
  GTEST_SKIP() << "RAMIFY_SHARED names no folder of measured trees"
