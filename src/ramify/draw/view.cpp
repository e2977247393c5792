#include "ramify/draw/view.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/shape/degrees.hpp"

namespace ramify {
namespace {

struct NamedView {
  const char* name;
  double azimuth, elevation;
};

constexpr NamedView named_views[] = {{"front", 0, 0},     {"right", 90, 0},   {"back", 180, 0},
                                     {"left", -90, 0},    {"top", 0, 90},     {"bottom", 0, -90},
                                     {"oblique", 30, 30}, {"quarter", 40, 0}, {"inverted", 0, 180}};

}  // namespace

View View::from(double azimuth, double elevation) {
  const double a = radians(azimuth), b = radians(elevation);
  View view;
  view.right = {std::cos(a), 0, -std::sin(a)};
  view.up = {-std::sin(a) * std::sin(b), std::cos(b), -std::cos(a) * std::sin(b)};
  view.toward = {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
  return view;
}

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedView& view : named_views) all.emplace_back(view.name);
    return all;
  }();
  return names;
}

View parse_view(const std::string& name) {
  for (const NamedView& view : named_views)
    if (name == view.name) return View::from(view.azimuth, view.elevation);
  throw Error(
      fmt::format("view '{}'", name), "no such view",
      fmt::format("{}take one of {}", did_you_mean(name, view_names()), fmt::join(view_names(), ", ")));
}

}  // namespace ramify
