#include "ramify/draw/drawing.hpp"

#include <utility>

#include "ramify/core/contract.hpp"
#include "ramify/draw/page_vector.hpp"

namespace ramify {

void Patches::begin(const Color& color, PagePoint from) {
  const std::array<float, 3> narrow{static_cast<float>(color[0]), static_cast<float>(color[1]),
                                    static_cast<float>(color[2])};
  patches_.push_back({narrow, steps_.size(), points_.size()});
  steps_.push_back(Step::move);
  points_.push_back(from);
}

void Patches::line(PagePoint to) {
  RAMIFY_EXPECTS(!patches_.empty());
  steps_.push_back(Step::line);
  points_.push_back(to);
}

void Patches::curve(PagePoint first_handle, PagePoint second_handle, PagePoint to) {
  RAMIFY_EXPECTS(!patches_.empty());
  steps_.push_back(Step::curve);
  points_.insert(points_.end(), {first_handle, second_handle, to});
}

Color Patches::color(std::size_t patch) const {
  const auto& [red, green, blue] = patches_[patch].color;
  return {red, green, blue};
}

std::span<const Patches::Step> Patches::steps(std::size_t patch) const {
  const std::size_t end = patch + 1 < patches_.size() ? patches_[patch + 1].first_step : steps_.size();
  return std::span(steps_).subspan(patches_[patch].first_step, end - patches_[patch].first_step);
}

std::span<const PagePoint> Patches::points(std::size_t patch) const {
  const std::size_t end = patch + 1 < patches_.size() ? patches_[patch + 1].first_point : points_.size();
  return std::span(points_).subspan(patches_[patch].first_point, end - patches_[patch].first_point);
}

void Patches::append(const Patches& other, PagePoint at, double scale) {
  for (Patch patch : other.patches_) {
    patch.first_step += steps_.size();
    patch.first_point += points_.size();
    patches_.push_back(patch);
  }
  steps_.insert(steps_.end(), other.steps_.begin(), other.steps_.end());
  for (const PagePoint point : other.points_) points_.push_back(at + point * scale);
}

void add_drawing(Drawing& page, const Drawing& part, PagePoint at, double scale) {
  page.patches.append(part.patches, at, scale);
  for (Stroke stroke : part.strokes) {
    stroke.width *= scale;
    for (Stroke::Line& line : stroke.lines) line = {at + line.from * scale, at + line.to * scale};
    page.strokes.push_back(std::move(stroke));
  }
  for (Label label : part.labels) {
    label.place = at + label.place * scale;
    label.size *= scale;
    page.labels.push_back(std::move(label));
  }
}

}  // namespace ramify
