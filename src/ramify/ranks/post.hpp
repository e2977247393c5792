#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ramify/core/workforce.hpp"

namespace ramify {

/// What a message between processes says; its MPI tag.
enum class MessageKind : std::uint8_t {
  ready,       ///< to rank 0: round, threads, hashes of build and work (words): items can come
  items,       ///< from rank 0: items to do (words)
  outcome,     ///< to rank 0: the item (a word), and its outcome
  round_over,  ///< from rank 0: every item of the round is done
  stopped,     ///< to rank 0: this process was told to stop
  failed,      ///< to rank 0: why this process cannot go on (text)
  dismissed,   ///< from rank 0: the job is over
  left,        ///< to rank 0: nothing more comes of this process
};

using Words = std::vector<std::uint64_t>;

struct Message {
  int from;
  MessageKind kind;
  Bytes body;

  Words words() const;
  std::string_view text() const;
};

/// The words as the bytes of a message's body.
Bytes bytes_of(std::span<const std::uint64_t> words);
Bytes bytes_of(std::string_view text);

/// Messages between the ranks of an MPI job: the one place that calls MPI. For one thread, that which made
/// it.
///
/// MPI gives messages of one rank to another in the order in which they were sent.
class Post {
 public:
  /// Enters MPI.
  Post();
  Post(const Post&) = delete;
  Post(Post&&) = delete;
  Post& operator=(const Post&) = delete;
  Post& operator=(Post&&) = delete;
  /// Leaves it: all ranks do so together. Nothing where another exit is under way.
  ~Post();

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  /// Ranks on this machine, this one among them.
  int neighbours() const { return neighbours_; }

  // Neither waits: Open MPI's waits keep a core busy.

  /// On its way; what is under way goes on in next().
  void send(int to, MessageKind kind, Bytes body = {});
  /// The next message that has come in; nothing where none has.
  std::optional<Message> next();

 private:
  class Outbox;

  std::unique_ptr<Outbox> outbox_;
  int rank_ = 0, ranks_ = 1, neighbours_ = 1;
};

}  // namespace ramify
