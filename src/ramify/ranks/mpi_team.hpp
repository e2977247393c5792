#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ramify/ranks/hand_out.hpp"
#include "ramify/ranks/joined_team.hpp"
#include "ramify/ranks/post.hpp"

namespace ramify {

/// The ranks of an MPI job as a team; rank 0 leads, and works too.
///
/// A round of share() begins when every rank is ready for the same work: then rank 0 hands items out
/// (HandOut), one message for every outcome and one for every item that takes its place. Whoever throws ends
/// the job: rank 0 dismisses the others, in leave() or before. For one thread, that which made it.
class MpiTeam final : public JoinedTeam {
 public:
  /// Several ranks, or one that then works alone.
  explicit MpiTeam(Cancellation& cancellation);

  bool leads() const override { return post_.rank() == 0; }
  unsigned processes() const override { return static_cast<unsigned>(post_.ranks()); }
  unsigned neighbours() const override { return static_cast<unsigned>(post_.neighbours()); }
  unsigned cores() const override;
  void share(const SharedWork& work, unsigned threads, const Cancellation& cancellation) override;
  void leave(std::string_view failure) override;

 private:
  void lead(const SharedWork& work, unsigned threads, const Cancellation& cancellation);
  void help(const SharedWork& work, unsigned threads, const Cancellation& cancellation);

  /// What this process says when it is ready for the round.
  Words greeting(const SharedWork& work, unsigned threads) const;
  /// Threads of every rank when all are ready. Throws Error where one does other work, or is another build.
  std::vector<unsigned> await_all(const SharedWork& work, unsigned threads, const Cancellation& cancellation);
  /// Rank 0: a message that is no outcome. Throws where it ends the round.
  void hear(const Message& message);
  /// The others: a message that gives no items. Throws Dismissed; true where the round is over.
  bool is_round_over(const Message& message);
  void dismiss_others();

  Post post_;
  Cancellation* cancellation_;
  std::uint64_t build_, round_ = 0;
  std::vector<Words> greetings_;  ///< rank 0: of each rank, for this round or the next; empty: not ready yet
  std::size_t left_ = 0;          ///< rank 0: how many have sent their last message
  bool is_dismissed_ = false;     ///< the others
};

}  // namespace ramify
