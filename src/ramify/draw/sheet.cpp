#include "ramify/draw/sheet.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/draw/label_text.hpp"

namespace ramify {
namespace {

constexpr double margin_part = 0.05;

double cell_side(std::size_t pictures, std::size_t columns, double side) {
  return pictures == 1 ? side : std::min(side, 2 * side / static_cast<double>(columns));
}

}  // namespace

Sheet::Sheet(std::size_t pictures, std::size_t columns, bool has_captions, double side)
    : columns_(std::min(columns, pictures)),
      cell_(cell_side(pictures, columns_, side)),
      letters_(has_captions ? std::clamp(0.045 * cell_, 9.0, 16.0) : 0),
      drawing_{static_cast<double>(columns_) * cell_, 0, {}, {}} {
  RAMIFY_EXPECTS(pictures > 0 && columns > 0);
  const std::size_t rows = (pictures + columns_ - 1) / columns_;
  drawing_.height = static_cast<double>(rows) * (cell_ + 2 * letters_);
}

void Sheet::add(const std::string& caption, const Tree& tree, const Shape& shape, const TreeLook& look,
                const Cancellation& cancellation) {
  const std::size_t column = added_ % columns_, row = added_ / columns_;
  const double left = static_cast<double>(column) * cell_,
               top = static_cast<double>(row) * (cell_ + 2 * letters_);
  const double margin = margin_part * cell_;
  ++added_;
  add_tree(drawing_, {left + margin, top + margin, cell_ - 2 * margin, cell_ - 2 * margin}, tree, shape, look,
           cancellation);
  if (caption.empty()) return;
  const PagePoint below{left + cell_ / 2, top + cell_ + letters_ / 2};
  constexpr std::size_t longest = 80;
  drawing_.labels.push_back({below, label_text(caption, longest), letters_, Label::Anchor::middle});
}

}  // namespace ramify
