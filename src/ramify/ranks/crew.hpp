#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "ramify/core/workforce.hpp"

namespace ramify {

/// What became of an item.
struct Outcome {
  std::size_t item;
  Bytes bytes;
};

/// Threads that do items as they are given them, in their order.
class Crew {
 public:
  /// @param work  work(item, worker); where it throws, no further item is begun
  Crew(unsigned threads, std::function<Bytes(std::size_t item, unsigned worker)> work);
  Crew(const Crew&) = delete;
  Crew(Crew&&) = delete;
  Crew& operator=(const Crew&) = delete;
  Crew& operator=(Crew&&) = delete;
  /// Waits for the items that are begun; drops the others.
  ~Crew();

  void give(std::size_t item);

  /// The outcomes since the last call; waits for one no longer than this. Throws what an item has thrown.
  std::vector<Outcome> outcomes(std::chrono::microseconds patience);

 private:
  void work_on(unsigned worker);

  std::function<Bytes(std::size_t, unsigned)> work_;
  std::mutex mutex_;  // guards all below
  std::condition_variable given_, done_;
  std::deque<std::size_t> items_;
  std::vector<Outcome> outcomes_;
  std::exception_ptr failure_;
  bool closed_ = false;
  std::vector<std::jthread> threads_;  // last: they end before what they use does
};

}  // namespace ramify
