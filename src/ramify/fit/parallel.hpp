#pragma once

#include <cstddef>
#include <functional>

namespace ramify {

/// Calls work(0), ..., work(count - 1), each once, in any order, on `threads` threads over one atomic
/// counter.
///
/// Results are to be written to places that depend on the index alone. The first exception stops the hand-out
/// and is thrown again here. @param threads  >= 1
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace ramify
