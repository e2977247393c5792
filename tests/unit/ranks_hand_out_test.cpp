// Who does which item: each once, in order, none waiting for another's last ones.
#include <cstdlib>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/ranks/hand_out.hpp"
#include "ramify/ranks/started_with.hpp"

namespace ramify {
namespace {

struct Given {
  std::vector<std::size_t> order;       // of all items as they were given
  std::size_t most_in_hand = 0;         // of any member, over its threads
  std::size_t most_in_hand_at_end = 0;  // when no more than two items a thread were left before
};

/// Members finish one item each in turn until all is done.
Given play(std::size_t items, const std::vector<unsigned>& threads) {
  HandOut hand_out(items, threads);
  std::size_t all_threads = 0;
  for (const unsigned t : threads) all_threads += t;
  std::vector<std::size_t> in_hand(threads.size());
  Given given;
  const auto deal = [&](std::size_t member) {
    const bool is_end = items - given.order.size() <= 2 * all_threads;
    const auto places = hand_out.next(member);
    given.order.insert(given.order.end(), places.begin(), places.end());
    in_hand[member] += places.size();
    if (places.empty()) return;
    given.most_in_hand = std::max(given.most_in_hand, in_hand[member] / threads[member]);
    if (is_end)
      given.most_in_hand_at_end = std::max(given.most_in_hand_at_end, in_hand[member] / threads[member]);
  };
  for (std::size_t member = 0; member < threads.size(); ++member) deal(member);
  for (std::size_t turn = 0; !hand_out.is_over() && turn < 10 * items + 10; ++turn) {
    const std::size_t member = turn % threads.size();
    if (in_hand[member] == 0) continue;
    --in_hand[member];
    hand_out.done(member);
    deal(member);
  }
  EXPECT_TRUE(hand_out.is_over());
  return given;
}

TEST(HandOut, GivesEveryItemOnceInOrder) {
  for (const std::size_t items : {0u, 1u, 5u, 1000u}) {
    const Given given = play(items, {1, 3, 2});
    ASSERT_EQ(given.order.size(), items);
    for (std::size_t i = 0; i < items; ++i) EXPECT_EQ(given.order[i], i);
  }
}

TEST(HandOut, GivesOneItemBeyondTheThreadsUntilFewAreLeft) {
  const Given given = play(1000, {1, 1, 1, 1});
  EXPECT_EQ(given.most_in_hand, 2u);
  EXPECT_EQ(given.most_in_hand_at_end, 1u);
}

TEST(HandOut, IsNotOverWhileAnItemIsInHand) {
  HandOut hand_out(1, {1, 1});
  EXPECT_EQ(hand_out.next(1), std::vector<std::size_t>{0});
  EXPECT_TRUE(hand_out.next(0).empty());
  EXPECT_FALSE(hand_out.is_over());
  hand_out.done(1);
  EXPECT_TRUE(hand_out.is_over());
}

/// An environment variable for as long as a test.
class Set {
 public:
  Set(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  Set(const Set&) = delete;
  Set(Set&&) = delete;
  Set& operator=(const Set&) = delete;
  Set& operator=(Set&&) = delete;
  ~Set() { unsetenv(name_); }

 private:
  const char* name_;
};

TEST(StartedWithOthers, IsSaidByTheEnvironmentOfMpirunAndSrun) {
  EXPECT_FALSE(is_started_with_others());
  {
    const Set alone("OMPI_COMM_WORLD_SIZE", "1"), rank("PMIX_RANK", "0");
    EXPECT_FALSE(is_started_with_others());
  }
  for (const auto& [name, value] :
       {std::pair{"OMPI_COMM_WORLD_SIZE", "2"}, {"PMI_SIZE", "16"}, {"PMIX_RANK", "0"}}) {
    const Set one(name, value);
    EXPECT_TRUE(is_started_with_others()) << name;
  }
}

}  // namespace
}  // namespace ramify
