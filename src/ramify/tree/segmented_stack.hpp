#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "ramify/core/contract.hpp"

namespace ramify {

/// A stack that grows by whole segments: nothing is ever copied, and depth d costs d * sizeof(T) plus at most
/// one segment, where a doubling vector would need up to three times that. Segments are kept for reuse.
template <class T>
  requires std::is_trivially_copyable_v<T>
class SegmentedStack {
 public:
  bool empty() const { return top_ == base_ && segment_ == 0; }

  T& top() {
    RAMIFY_EXPECTS(!empty());
    return *top_;
  }

  [[gnu::always_inline]] void push(const T& item) {
    if (top_ == end_) next_segment();
    *++top_ = item;
  }

  void pop() {
    RAMIFY_EXPECTS(!empty());
    if (--top_ == base_ && segment_ > 0) previous_segment();
  }

  void clear() {
    if (!segments_.empty()) enter(0, 0);
  }

  std::size_t capacity_bytes() const { return segments_.size() * segment_items * sizeof(T); }

 private:
  static constexpr std::size_t segment_items = 4096;

  // Slot 0 of a segment is never used: base_ is "nothing in this segment", so push and pop compare once.
  void enter(std::size_t segment, std::size_t items) {
    segment_ = segment;
    base_ = segments_[segment].get();
    end_ = base_ + segment_items - 1;
    top_ = base_ + items;
  }

  [[gnu::noinline]] void next_segment() {
    const std::size_t next = segments_.empty() ? 0 : segment_ + 1;
    if (next == segments_.size()) segments_.emplace_back(new T[segment_items]);
    enter(next, 0);
  }

  void previous_segment() { enter(segment_ - 1, segment_items - 1); }

  std::vector<std::unique_ptr<T[]>> segments_;
  std::size_t segment_ = 0;
  T* base_ = nullptr;
  T* end_ = nullptr;
  T* top_ = nullptr;
};

}  // namespace ramify
