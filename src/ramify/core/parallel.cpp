#include "ramify/core/parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "ramify/core/contract.hpp"

namespace ramify {

void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t, unsigned)>& work) {
  RAMIFY_EXPECTS(threads >= 1);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto take_items = [&](unsigned worker) {
    try {
      for (std::size_t item = next++; item < count && !failed; item = next++) work(item, worker);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
      failed = true;
    }
  };
  {
    std::vector<std::jthread> team;
    // Where the system has no more threads, those that there are do the work.
    const auto started = [&](unsigned worker) {
      try {
        team.emplace_back(take_items, worker);
        return true;
      } catch (const std::system_error&) {
        return false;
      }
    };
    unsigned worker = 1;
    while (worker < threads && started(worker)) ++worker;
    take_items(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ramify
