#pragma once

#include <cmath>

#include "ramify/draw/drawing.hpp"

/// Arithmetic of places on a page.
namespace ramify {

inline PagePoint operator+(PagePoint a, PagePoint b) {
  return {a.x + b.x, a.y + b.y};
}

inline PagePoint operator-(PagePoint a, PagePoint b) {
  return {a.x - b.x, a.y - b.y};
}

inline PagePoint operator*(PagePoint a, double factor) {
  return {a.x * factor, a.y * factor};
}

inline double dot(PagePoint a, PagePoint b) {
  return a.x * b.x + a.y * b.y;
}

inline double length(PagePoint a) {
  return std::hypot(a.x, a.y);
}

/// A quarter of a turn to the left of who goes that way, y down.
inline PagePoint to_the_left(PagePoint a) {
  return {a.y, -a.x};
}

}  // namespace ramify
