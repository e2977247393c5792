#pragma once

#include <cstddef>
#include <vector>

namespace ramify {

/// Which member of a team does which item: dynamically, in the order of the items.
///
/// A member has as many items in hand as it has threads, and twice as many while more than two items are left
/// for each thread of the team: so that no thread waits for a message, and none for another's last items.
/// Knows nothing of messages: bench/team_model.cpp plays it with 10^4 members. Cost: O(1) for an item.
class HandOut {
 public:
  /// @param threads  of every member, >= 1
  HandOut(std::size_t items, std::vector<unsigned> threads);

  /// Places of the items that a member gets now: none, or one or more of the lowest that are left.
  std::vector<std::size_t> next(std::size_t member);
  /// A member has done one of those it had in hand.
  void done(std::size_t member);
  /// Every item is done.
  bool is_over() const { return done_ == items_; }

 private:
  std::size_t items_;
  std::vector<unsigned> threads_;
  std::vector<std::size_t> in_hand_;
  std::size_t all_threads_ = 0, given_ = 0, done_ = 0;
};

}  // namespace ramify
