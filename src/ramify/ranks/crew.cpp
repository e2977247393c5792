#include "ramify/ranks/crew.hpp"

#include <system_error>
#include <utility>

namespace ramify {

Crew::Crew(unsigned threads, std::function<Bytes(std::size_t, unsigned)> work) : work_(std::move(work)) {
  for (unsigned worker = 0; worker < threads; ++worker) {
    try {
      threads_.emplace_back([this, worker] { work_on(worker); });
    } catch (const std::system_error&) {  // where the system has no more, those that there are do the work
      if (worker == 0) throw;
      break;
    }
  }
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  given_.notify_all();
}

void Crew::give(std::size_t item) {
  {
    const std::lock_guard lock(mutex_);
    items_.push_back(item);
  }
  given_.notify_one();
}

std::vector<Outcome> Crew::outcomes(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  done_.wait_for(lock, patience, [this] { return !outcomes_.empty() || failure_ != nullptr; });
  if (failure_ != nullptr) std::rethrow_exception(failure_);
  return std::exchange(outcomes_, {});
}

void Crew::work_on(unsigned worker) {
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return closed_ || !items_.empty(); });
    if (closed_ || failure_ != nullptr) return;
    const std::size_t item = items_.front();
    items_.pop_front();
    lock.unlock();
    Outcome outcome{item, {}};
    std::exception_ptr failure;
    try {
      outcome.bytes = work_(item, worker);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure != nullptr)
      failure_ = failure;
    else
      outcomes_.push_back(std::move(outcome));
    done_.notify_one();
  }
}

}  // namespace ramify
