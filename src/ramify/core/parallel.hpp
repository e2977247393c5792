#pragma once

#include <cstddef>
#include <functional>

namespace ramify {

/// Calls work(item, worker) for items 0..count-1, each once, on `threads` threads over one atomic counter.
///
/// worker (0..threads-1) says which thread it is, for scratch that a thread keeps; results go to places that
/// depend on the item alone. Items are handed out in ascending order. The first exception stops the hand-out
/// and is thrown again here.
/// @param threads  >= 1; that many run, however few the cores, unless the system refuses some
void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t item, unsigned worker)>& work);

}  // namespace ramify
