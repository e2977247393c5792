#pragma once

#include <cstddef>
#include <string>

#include "ramify/draw/tree_picture.hpp"

namespace ramify {

/// Pictures in rows, each in a box of the same size (G11, G12), with captions below.
class Sheet {
 public:
  /// @param side  of a picture that stands alone; a sheet is twice as wide, however many stand in a row
  Sheet(std::size_t pictures, std::size_t columns, bool has_captions, double side);

  /// The next picture. Throws Interrupted.
  void add(const std::string& caption, const Tree& tree, const Shape& shape, const TreeLook& look,
           const Cancellation& cancellation);

  const Drawing& drawing() const { return drawing_; }

 private:
  std::size_t columns_, added_ = 0;
  double cell_, letters_;
  Drawing drawing_;
};

}  // namespace ramify
