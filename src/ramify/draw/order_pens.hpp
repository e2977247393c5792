#pragma once

#include <cstddef>

#include "ramify/draw/drawing.hpp"

namespace ramify {

/// Colour and width of the branches of every order: light and thin at the tips, dark and thick at the root,
/// told apart in grey too.
class OrderPens {
 public:
  /// @param highest  the order of the root, leaf order 0
  /// @param thinnest  the width at the tips; every order is as many times as thick as the one below, 1.6 at
  /// most
  OrderPens(std::size_t highest, double thinnest);

  Color color(std::size_t order) const;
  double width(std::size_t order) const;

 private:
  std::size_t highest_;
  double thinnest_;
  double factor_;
};

}  // namespace ramify
