#include "ramify/core/workforce.hpp"

#include "ramify/core/parallel.hpp"

namespace ramify {

void share(const SharedWork& work, const Workforce& workforce, const Cancellation& cancellation) {
  if (workforce.team != nullptr) return workforce.team->share(work, workforce.threads, cancellation);
  parallel_for(work.items.size(), workforce.threads,
               [&work](std::size_t place, unsigned worker) { work.keep(work.items[place], worker); });
}

}  // namespace ramify
