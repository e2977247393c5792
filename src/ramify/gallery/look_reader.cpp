#include "ramify/gallery/look_reader.hpp"

#include <array>
#include <charconv>

#include <fmt/format.h>

namespace ramify::detail {
namespace {

constexpr Expected look_wanted{"a table", "look = { style = \"branches\" }"};
constexpr Expected leaves_wanted{"a table", "leaves = { apex = \"acute\" }"};
constexpr Expected style_wanted{"a style", "style = \"branches\""};
constexpr Expected part_wanted{"a number", "shade = 0.3"};
constexpr Expected yes_wanted{"true or false", "needles = true"};
constexpr Expected color_wanted{"a colour", "bark = \"#5c4030\""};

Color read_color(const TomlValue& value) {
  const std::string text = value.text(color_wanted);
  unsigned code = 0;
  const char* const end = text.data() + text.size();
  const bool is_color =
      text.size() == 7 && text[0] == '#' && std::from_chars(text.data() + 1, end, code, 16).ptr == end;
  if (!is_color)
    value.fail(fmt::format("{} = \"{}\"", value.key(), text), "a colour is # and six digits from 0 to f",
               fmt::format("write {}", color_wanted.example));
  return {(code >> 16) / 255.0, (code >> 8 & 0xff) / 255.0, (code & 0xff) / 255.0};
}

double read_part(const TomlValue& value, double least, double most) {
  return read_between(value, least, most, part_wanted);
}

/// A word that a function knows.
template <class Parse>
auto read_word(const TomlValue& value, Parse parse) {
  const std::string text = value.text(style_wanted);
  return at_place(value, [&] { return parse(text); });
}

LeafLook read_leaves(const TomlValue& value) {
  constexpr std::array<std::string_view, 7> keys{"margin", "apex",  "base",  "width",
                                                 "length", "color", "autumn"};
  const TomlTable table(value.file(), value.table(leaves_wanted));
  table.require_known("leaves", keys);
  LeafLook look;
  const auto margin = table.find("margin"), apex = table.find("apex"), base = table.find("base");
  if (margin) look.form.margin = read_word(*margin, parse_margin);
  if (look.form.margin == LeafForm::Margin::lobed && (apex || base))
    margin->fail("a lobed leaf with an apex or a base", "its outline is one from foot to tip",
                 "leave them out");
  if (apex) look.form.apex = read_word(*apex, parse_apex);
  if (base) look.form.base = read_word(*base, parse_base);
  if (const auto width = table.find("width")) look.form.width = read_part(*width, 0.01, 3);
  if (const auto length = table.find("length")) look.length = read_part(*length, 0.0001, 0.3);
  if (const auto color = table.find("color")) look.color = read_color(*color);
  if (const auto autumn = table.find("autumn")) look.is_autumn = autumn->boolean(yes_wanted);
  return look;
}

}  // namespace

TreeLook read_look(const FindKey& find) {
  TreeLook look;
  if (const auto view = find("view")) look.view = read_word(*view, parse_view);
  const auto value = find("look");
  if (!value) return look;
  constexpr std::array<std::string_view, 11> keys{"style",      "color_by", "bark",   "tapers",
                                                  "line_width", "shade",    "leaves", "blossoms",
                                                  "fruit",      "needles",  "shadow"};
  const TomlTable table(value->file(), value->table(look_wanted));
  table.require_known("look", keys);
  if (const auto style = table.find("style")) look.style = read_word(*style, parse_tree_style);
  if (const auto by = table.find("color_by")) look.by_order = read_word(*by, parse_color_by);
  if (const auto bark = table.find("bark")) look.bark = read_color(*bark);
  if (const auto width = table.find("line_width")) look.line_width = read_part(*width, 0.01, 100);
  if (const auto shade = table.find("shade")) look.shade = read_part(*shade, 0, 1);
  if (const auto leaves = table.find("leaves")) look.leaves = read_leaves(*leaves);
  const auto yes = [&](std::string_view key, bool& target) {
    if (const auto given = table.find(key)) target = given->boolean(yes_wanted);
  };
  yes("tapers", look.tapers);
  yes("blossoms", look.has_blossoms);
  yes("fruit", look.has_fruit);
  yes("needles", look.has_needles);
  yes("shadow", look.has_shadow);
  return look;
}

}  // namespace ramify::detail
