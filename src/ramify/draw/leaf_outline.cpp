#include "ramify/draw/leaf_outline.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/draw/page_vector.hpp"

namespace ramify {
namespace {

using Apex = LeafForm::Apex;
using Base = LeafForm::Base;
using Margin = LeafForm::Margin;

constexpr std::array<std::string_view, 9> apex_names{
    "acuminate", "acute", "cuspidate", "mucronate", "obtuse", "rounded", "truncate", "retuse", "emarginate"};
constexpr std::array<std::string_view, 4> base_names{"cuneate", "rounded", "cordate", "truncate"};
constexpr std::array<std::string_view, 2> margin_names{"entire", "lobed"};

template <class Form, std::size_t count>
Form named_form(const std::array<std::string_view, count>& all, std::string_view kind,
                const std::string& name) {
  const auto found = std::ranges::find(all, name);
  if (found != all.end()) return static_cast<Form>(found - all.begin());
  throw Error(
      fmt::format("{} '{}'", kind, name), fmt::format("no such {} of a leaf", kind),
      fmt::format("{}take one of {}", did_you_mean(name, {all.begin(), all.end()}), fmt::join(all, ", ")));
}

/// Points of cubic curves: along the blade from 0 to 1, and across it from 0 to 1, half its width.
using Curves = std::vector<PagePoint>;

/// From the foot, which is not written, to the full width.
Curves base_curves(Base base) {
  switch (base) {
    case Base::cuneate:
      return {{0.13, 0.33}, {0.27, 0.8}, {0.42, 1}};
    case Base::rounded:
      return {{0, 0.65}, {0.12, 1}, {0.35, 1}};
    case Base::cordate:
      return {{-0.2, 0.3}, {-0.14, 1}, {0.25, 1}};
    case Base::truncate:
      return {{0, 0.25}, {0, 0.5}, {0, 0.7}, {0.05, 0.9}, {0.12, 1}, {0.25, 1}};
  }
  return {};
}

/// From the full width to the tip.
Curves apex_curves(Apex apex) {
  switch (apex) {
    case Apex::acuminate:
      return {{0.65, 1}, {0.74, 0.1}, {1, 0}};
    case Apex::acute:
      return {{0.65, 1}, {0.85, 0.4}, {1, 0}};
    case Apex::cuspidate:
      return {{0.75, 1}, {0.8, 0.3}, {0.86, 0.12}, {0.9, 0.08}, {0.95, 0.03}, {1, 0}};
    case Apex::mucronate:
      return {{0.8, 1}, {0.92, 0.6}, {0.93, 0.05}, {0.95, 0.04}, {0.98, 0.02}, {1, 0}};
    case Apex::obtuse:
      return {{0.75, 1}, {0.95, 0.6}, {1, 0}};
    case Apex::rounded:
      return {{0.82, 1}, {1, 0.6}, {1, 0}};
    case Apex::truncate:
      return {{0.8, 1}, {0.97, 0.95}, {1, 0.55}, {1, 0.4}, {1, 0.2}, {1, 0}};
    case Apex::retuse:
      return {{0.85, 1}, {1.03, 0.75}, {1, 0.3}, {0.99, 0.15}, {0.96, 0.05}, {0.95, 0}};
    case Apex::emarginate:
      return {{0.85, 1}, {1.06, 0.85}, {1, 0.4}, {0.97, 0.2}, {0.9, 0.05}, {0.86, 0}};
  }
  return {};
}

/// A white oak's leaf from its foot, which is not written, to its tip: a wedge, then lobes by turns with
/// sinuses, the broadest beyond the middle.
Curves lobed_curves() {
  return {{0.08, 0.02}, {0.12, 0.05}, {0.16, 0.12},  // the wedge
          {0.2, 0.19},  {0.2, 0.5},   {0.29, 0.5},   // out to the first lobe
          {0.37, 0.5},  {0.31, 0.26}, {0.37, 0.26},  // back into a sinus
          {0.43, 0.26}, {0.4, 0.78},  {0.51, 0.78},  //
          {0.62, 0.78}, {0.52, 0.32}, {0.59, 0.32},  //
          {0.66, 0.32}, {0.61, 1},    {0.72, 1},     // the broadest
          {0.83, 1},    {0.73, 0.38}, {0.79, 0.38},  //
          {0.84, 0.38}, {0.83, 0.54}, {0.9, 0.54},   // the lobe at the tip
          {0.96, 0.54}, {1, 0.3},     {1, 0}};
}

/// One half of a blade, from the foot, which is not written, to the tip.
Curves half_of(const LeafForm& form) {
  if (form.margin == Margin::lobed) return lobed_curves();
  Curves half = base_curves(form.base);
  const Curves apex = apex_curves(form.apex);
  half.insert(half.end(), apex.begin(), apex.end());
  return half;
}

}  // namespace

Apex parse_apex(const std::string& name) {
  return named_form<Apex>(apex_names, "apex", name);
}

Base parse_base(const std::string& name) {
  return named_form<Base>(base_names, "base", name);
}

Margin parse_margin(const std::string& name) {
  return named_form<Margin>(margin_names, "margin", name);
}

void add_leaf(Patches& patches, const LeafForm& form, const Color& color, PagePoint foot, PagePoint blade) {
  const PagePoint side = to_the_left(blade) * (form.width / 2);
  Curves half = half_of(form);
  half.insert(half.begin(), {0, 0});
  const auto on_page = [&](PagePoint p, double sign) { return foot + blade * p.x + side * (sign * p.y); };
  patches.begin(color, foot);
  for (std::size_t i = 1; i + 2 < half.size(); i += 3)
    patches.curve(on_page(half[i], 1), on_page(half[i + 1], 1), on_page(half[i + 2], 1));
  std::ranges::reverse(half);
  for (std::size_t i = 1; i + 2 < half.size(); i += 3)
    patches.curve(on_page(half[i], -1), on_page(half[i + 1], -1), on_page(half[i + 2], -1));
}

}  // namespace ramify
