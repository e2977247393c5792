#include "ramify/ranks/mpi_team.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "ramify/core/error.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/ranks/crew.hpp"
#include "ramify/ranks/started_with.hpp"

namespace ramify {
namespace {

/// How long a process sleeps where no message has come: below the time that an item takes. To wake is not
/// free where a machine is a guest of another: at 1 ms it took 4 % of two cores.
constexpr std::chrono::microseconds pause{5000};

/// Of the program that this process runs.
std::uint64_t hash_of_build() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::string piece(1 << 20, '\0');
  std::uint64_t hash = 0;
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())), file.gcount() > 0)
    hash = hash_text(std::string_view(piece).substr(0, static_cast<std::size_t>(file.gcount())), hash);
  return hash;
}

/// Where the one process that has the terminal is another.
void fall_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

/// An outcome as the body of a message.
Bytes packed(const Outcome& outcome) {
  const std::uint64_t item = outcome.item;
  Bytes body = bytes_of({&item, 1});
  body.insert(body.end(), outcome.bytes.begin(), outcome.bytes.end());
  return body;
}

Outcome unpacked(const Message& message) {
  constexpr std::ptrdiff_t head = sizeof(std::uint64_t);
  return {message.words().front(), {message.body.begin() + head, message.body.end()}};
}

}  // namespace

std::unique_ptr<JoinedTeam> join_team(Cancellation& cancellation) {
  if (!is_started_with_others()) return nullptr;
  return std::make_unique<MpiTeam>(cancellation);
}

MpiTeam::MpiTeam(Cancellation& cancellation)
    : cancellation_(&cancellation), build_(hash_of_build()), greetings_(processes()) {
  if (!leads()) fall_silent();
}

unsigned MpiTeam::cores() const {
  // Where the starter has bound a rank to cores, these; else its share of the machine.
  const unsigned seen = std::max(1u, std::thread::hardware_concurrency());
  const auto machine = static_cast<unsigned>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  return std::max(1u, std::min(seen, machine / neighbours()));
}

void MpiTeam::share(const SharedWork& work, unsigned threads, const Cancellation& cancellation) {
  ++round_;
  if (leads())
    lead(work, threads, cancellation);
  else
    help(work, threads, cancellation);
}

Words MpiTeam::greeting(const SharedWork& work, unsigned threads) const {
  return {round_, threads, build_, hash_text(work.identity)};
}

std::vector<unsigned> MpiTeam::await_all(const SharedWork& work, unsigned threads,
                                         const Cancellation& cancellation) {
  const Words own = greeting(work, threads);
  greetings_[0] = own;
  while (std::ranges::any_of(greetings_, &Words::empty)) {
    if (cancellation.requested()) throw Interrupted();
    if (const auto message = post_.next())
      hear(*message);
    else
      std::this_thread::sleep_for(pause);
  }
  std::vector<unsigned> all;
  for (std::size_t rank = 0; rank < greetings_.size(); ++rank) {
    const Words& theirs = greetings_[rank];
    if (theirs[2] != own[2])
      throw Error(fmt::format("rank {} runs another build of ramify than rank 0", rank),
                  "its trees need not be the same", "start the same program on every machine");
    if (theirs[0] != own[0] || theirs[3] != own[3])
      throw Error(fmt::format("rank {} has another config, data or command than rank 0", rank),
                  "they would not do the same work", "give every machine the same files");
    all.push_back(static_cast<unsigned>(theirs[1]));
  }
  std::ranges::fill(greetings_, Words());
  return all;
}

void MpiTeam::hear(const Message& message) {
  const auto from = static_cast<std::size_t>(message.from);
  switch (message.kind) {
    case MessageKind::ready:
      greetings_[from] = message.words();
      return;
    case MessageKind::stopped:
      throw Interrupted();
    case MessageKind::failed:
      throw Error(fmt::format("rank {} cannot go on", from), message.text(),
                  "mend it; what was finished is kept, and --resume goes on with it");
    case MessageKind::left:
      ++left_;
      throw Error(fmt::format("rank {} has ended before the others", from), "no reason is known",
                  "start the same command on every machine; --resume goes on with what is kept");
    default:
      return;  // an outcome of a round that was broken off
  }
}

void MpiTeam::lead(const SharedWork& work, unsigned threads, const Cancellation& cancellation) {
  HandOut hand_out(work.items.size(), await_all(work, threads, cancellation));
  Crew crew(threads, [&work](std::size_t item, unsigned worker) {
    work.keep(item, worker);
    return Bytes{};
  });
  const auto deal = [&](std::size_t member) {
    const auto places = hand_out.next(member);
    Words items;
    for (const std::size_t place : places) items.push_back(work.items[place]);
    if (member == 0)
      for (const std::size_t item : items) crew.give(item);
    else if (!items.empty())
      post_.send(static_cast<int>(member), MessageKind::items, bytes_of(items));
  };
  const auto replace = [&](std::size_t member) {
    hand_out.done(member);
    deal(member);
  };
  for (std::size_t member = 0; member < processes(); ++member) deal(member);
  while (!hand_out.is_over()) {
    if (cancellation.requested()) throw Interrupted();
    const auto own = crew.outcomes(pause);
    for (std::size_t i = 0; i < own.size(); ++i) replace(0);
    while (const auto message = post_.next()) {
      if (message->kind != MessageKind::outcome) {
        hear(*message);
        continue;
      }
      const Outcome outcome = unpacked(*message);
      work.take(outcome.item, outcome.bytes);
      replace(static_cast<std::size_t>(message->from));
    }
  }
  for (int rank = 1; rank < post_.ranks(); ++rank) post_.send(rank, MessageKind::round_over);
}

bool MpiTeam::is_round_over(const Message& message) {
  if (message.kind != MessageKind::dismissed) return message.kind == MessageKind::round_over;
  is_dismissed_ = true;
  cancellation_->request();
  throw Dismissed();
}

void MpiTeam::help(const SharedWork& work, unsigned threads, const Cancellation& cancellation) {
  Crew crew(threads, work.send);
  post_.send(0, MessageKind::ready, bytes_of(greeting(work, threads)));
  while (true) {
    // What an item throws, Interrupted where this process was stopped, goes to rank 0 by leave().
    for (const Outcome& outcome : crew.outcomes(pause)) post_.send(0, MessageKind::outcome, packed(outcome));
    if (cancellation.requested()) throw Interrupted();
    while (const auto message = post_.next()) {
      if (message->kind == MessageKind::items)
        for (const std::size_t item : message->words()) crew.give(item);
      else if (is_round_over(*message))
        return;
    }
  }
}

void MpiTeam::dismiss_others() {
  for (int rank = 1; rank < post_.ranks(); ++rank) post_.send(rank, MessageKind::dismissed);
  while (left_ + 1 < processes()) {
    const auto message = post_.next();
    if (!message) std::this_thread::sleep_for(pause);
    if (message && message->kind == MessageKind::left) ++left_;
  }
}

void MpiTeam::leave(std::string_view failure) {
  if (leads()) return dismiss_others();
  if (!is_dismissed_ && cancellation_->requested()) post_.send(0, MessageKind::stopped);
  if (!is_dismissed_ && !failure.empty()) post_.send(0, MessageKind::failed, bytes_of(failure));
  post_.send(0, MessageKind::left);
  while (!is_dismissed_) {  // MPI_Finalize would wait too, but keep a core busy
    const auto message = post_.next();
    if (!message) std::this_thread::sleep_for(pause);
    is_dismissed_ = message && message->kind == MessageKind::dismissed;
  }
}

}  // namespace ramify
