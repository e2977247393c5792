#pragma once

#include <string>
#include <vector>

#include "support/error_of.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "ramify/format/order_counts.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace ramify::test {

/// A small file with its right answer, worked out by hand.
struct Fixture {
  const char* writer;  ///< the program, or the rule, that such files come from
  std::string text;
  /// Of every tree, parted by "; ": "nodes / streams[ / mean lengths]", tips first, as in "4 2 1 / 4 2 1
  /// / 1.5 3 10"; or "refused: " and a part of the message.
  const char* answer;
  ReadOptions options{};
};

/// Nodes, streams and mean lengths of the orders of a tree.
inline std::string measured(const MeasuredOrders& orders) {
  std::string text = fmt::format("{} / {}", fmt::join(orders.nodes, " "), fmt::join(orders.streams, " "));
  if (orders.mean_lengths.empty()) return text;
  text += " /";
  for (const double length : orders.mean_lengths)
    text += length == length ? fmt::format(" {:.6g}", length) : std::string(" -");
  return text;
}

/// Those of all trees of a text, or how it is refused.
inline std::string measured_text(std::string_view text, const ReadOptions& options, Remarks& remarks) {
  std::string all;
  const std::string message = error_of([&] {
    for (RecordedTree& tree : read_trees(text, "f", std::nullopt, options, remarks))
      all += (all.empty() ? "" : "; ") + measured(measure_orders(contract_unary(std::move(tree))));
  });
  return message.empty() ? all : "refused: " + message;
}

/// The answer, or a refusal that says what the fixture's does.
inline void expect_answer(const Fixture& fixture, const std::string& found) {
  const std::string answer = fixture.answer;
  const bool is_right =
      answer.starts_with("refused: ")
          ? found.starts_with("refused: ") && found.find(answer.substr(9)) != std::string::npos
          : found == answer;
  EXPECT_TRUE(is_right) << fixture.writer << '\n'
                        << fixture.text << "\nright: " << answer << "\nfound: " << found;
}

inline void expect_answers(const std::vector<Fixture>& fixtures) {
  for (const Fixture& fixture : fixtures) {
    Remarks remarks;
    expect_answer(fixture, measured_text(fixture.text, fixture.options, remarks));
  }
}

}  // namespace ramify::test
