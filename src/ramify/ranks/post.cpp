#include "ramify/ranks/post.hpp"

#include <cstring>

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

Post::Post() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &neighbours_);
  MPI_Comm_free(&machine);
}

Post::~Post() {
  MPI_Finalize();
}

void Post::send(int to, MessageKind kind, const Bytes& body) const {
  MPI_Send(body.data(), static_cast<int>(body.size()), MPI_BYTE, to, static_cast<int>(kind), MPI_COMM_WORLD);
}

std::optional<Message> Post::next() const {
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
