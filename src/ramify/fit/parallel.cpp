#include "ramify/fit/parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "ramify/core/contract.hpp"

namespace ramify {

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  RAMIFY_EXPECTS(threads >= 1);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr first;
  const auto take = [&] {
    for (std::size_t index = next++; index < count; index = next++) {
      try {
        work(index);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!first) first = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(take);
    take();
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace ramify
