#include "ramify/ranks/post.hpp"

#include <cstring>
#include <list>
#include <utility>

#include <mpi.h>

namespace ramify {

Words Message::words() const {
  Words words(body.size() / sizeof(std::uint64_t));
  if (!words.empty()) std::memcpy(words.data(), body.data(), words.size() * sizeof(std::uint64_t));
  return words;
}

std::string_view Message::text() const {
  return {reinterpret_cast<const char*>(body.data()), body.size()};
}

Bytes bytes_of(std::span<const std::uint64_t> words) {
  Bytes bytes(words.size_bytes());
  if (!bytes.empty()) std::memcpy(bytes.data(), words.data(), bytes.size());
  return bytes;
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

/// Messages that MPI still reads from.
class Post::Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox(Outbox&&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  Outbox& operator=(Outbox&&) = delete;
  /// When all have arrived.
  ~Outbox() {
    for (Sent& sent : sent_) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
  }

  void send(int to, MessageKind kind, Bytes body) {
    Sent& sent = sent_.emplace_back(Sent{std::move(body), MPI_REQUEST_NULL});
    MPI_Isend(sent.body.data(), static_cast<int>(sent.body.size()), MPI_BYTE, to, static_cast<int>(kind),
              MPI_COMM_WORLD, &sent.request);
  }

  void drop_what_arrived() {
    std::erase_if(sent_, [](Sent& sent) {
      int is_done = 0;
      MPI_Test(&sent.request, &is_done, MPI_STATUS_IGNORE);
      return is_done != 0;
    });
  }

 private:
  struct Sent {
    Bytes body;
    MPI_Request request;
  };

  std::list<Sent> sent_;  // they do not move
};

Post::Post() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &neighbours_);
  MPI_Comm_free(&machine);
  outbox_ = std::make_unique<Outbox>();
}

Post::~Post() {
  outbox_.reset();
  MPI_Finalize();
}

void Post::send(int to, MessageKind kind, Bytes body) {
  outbox_->send(to, kind, std::move(body));
}

std::optional<Message> Post::next() {
  outbox_->drop_what_arrived();
  int is_there = 0, size = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) return std::nullopt;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, static_cast<MessageKind>(status.MPI_TAG),
                  Bytes(static_cast<std::size_t>(size))};
  MPI_Recv(message.body.data(), size, MPI_BYTE, message.from, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

}  // namespace ramify
