#pragma once

#include <cstddef>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// All the ways a procedure with random choices can go, one after another: restart, run the procedure with
/// choose in place of every random choice, read the probability; again while next() says so.
class ChoicePath {
 public:
  /// Forgets every way.
  void clear() { choices_.clear(); }

  void restart() { position_ = 0; }

  /// The choice that the present way takes among weights that sum to total.
  template <class Weights>
  std::size_t choose(const Weights& weights, Size total) {
    if (position_ == choices_.size()) choices_.push_back(first_choice(weights, total));
    return choices_[position_++].taken;
  }

  double probability() const {
    double product = 1;
    for (const Choice& choice : choices_) product *= choice.probabilities[choice.taken];
    return product;
  }

  /// Goes on to the next way; false after the last.
  bool next() {
    while (!choices_.empty()) {
      if (advance(choices_.back())) return true;
      choices_.pop_back();
    }
    return false;
  }

 private:
  struct Choice {
    std::vector<double> probabilities;
    std::size_t taken;
  };

  /// To the next index that has a probability.
  static bool advance(Choice& choice) {
    while (++choice.taken < choice.probabilities.size())
      if (choice.probabilities[choice.taken] > 0) return true;
    return false;
  }

  template <class Weights>
  static Choice first_choice(const Weights& weights, Size total) {
    Choice choice{{}, 0};
    for (const Size weight : weights)
      choice.probabilities.push_back(static_cast<double>(weight) / static_cast<double>(total));
    if (choice.probabilities.front() == 0) advance(choice);
    return choice;
  }

  std::vector<Choice> choices_;
  std::size_t position_ = 0;
};

/// A walk that takes the choices of a path: LastNodeDepthOf<EnumeratedWalk>.
class EnumeratedWalk {
 public:
  /// @param path  must outlive the walk
  explicit EnumeratedWalk(ChoicePath& path) : path_(&path) {}

  template <class Weights>
  std::size_t choose(const Weights& weights, Size total) {
    return path_->choose(weights, total);
  }

 private:
  ChoicePath* path_;
};

}  // namespace ramify
