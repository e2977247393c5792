#include "ramify/draw/tree_look.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"

namespace ramify {

TreeLook::Style parse_tree_style(const std::string& name) {
  if (name == "lines") return TreeLook::Style::lines;
  if (name == "bars") return TreeLook::Style::bars;
  if (name == "branches") return TreeLook::Style::branches;
  throw Error(fmt::format("style '{}'", name), "no such style of a form",
              did_you_mean(name, {"lines", "bars", "branches"}) + "take lines, bars or branches");
}

bool parse_color_by(const std::string& name) {
  if (name == "order") return true;
  if (name == "bark") return false;
  throw Error(fmt::format("colour by '{}'", name), "no such choice",
              did_you_mean(name, {"bark", "order"}) + "take bark or order");
}

}  // namespace ramify
