#include "ramify/gallery/panel_reader.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "ramify/config/run_config.hpp"
#include "ramify/gallery/look_reader.hpp"

namespace ramify::detail {
namespace {

constexpr std::array<std::string_view, 19> all_panel_keys{
    "caption", "model",        "n",     "seed",    "replicate",   "main",     "radius",
    "length",  "deviation",    "plane", "tropism", "arrangement", "azimuths", "joint",
    "mirrors", "foreshortens", "walk",  "view",    "look"};

constexpr Expected caption_wanted{"a text", "caption = \"n = 100\""};
constexpr Expected model_wanted{"a model", "model = \"bst\""};
constexpr Expected size_wanted{"a whole number", "n = 500"};
constexpr Expected number_wanted{"a whole number", "seed = 1996"};
constexpr Expected walk_wanted{"a table", "walk = { steps = 12, deviation = 0.1 }"};
constexpr Expected panels_wanted{"a list of tables", "[[panel]] before the keys of each"};

/// An @ in a model's text is the folder of the preset: a matrix lies beside it.
Model read_model(const TomlValue& value) {
  std::string text = value.text(model_wanted);
  if (const auto at = text.find('@'); at != std::string::npos)
    text.replace(at, 1, (std::filesystem::path(value.file()).parent_path() / "").string());
  return at_place(value, [&] { return Model::parse(text); });
}

LimbWalk read_walk(const TomlValue& value) {
  constexpr std::array<std::string_view, 2> keys{"steps", "deviation"};
  constexpr std::uint64_t most_steps = 1000;
  const TomlTable table(value.file(), value.table(walk_wanted));
  table.require_known("walk", keys);
  const auto steps = table.find("steps"), deviation = table.find("deviation");
  if (!steps || !deviation)
    value.fail("half a walk", "it has a number of steps and a deviation",
               fmt::format("write {}", walk_wanted.example));
  return {steps->whole(2, most_steps, walk_wanted), read_between(*deviation, 0, 1, walk_wanted)};
}

PicturePanel read_panel(std::string_view file, const FindKey& find) {
  const auto required = [&](std::string_view key) {
    return require(find, file, key, "a picture is of a tree");
  };
  const TomlValue model = required("model"), n = required("n");
  PicturePanel panel{{},
                     read_model(model),
                     n.whole(0, INT64_MAX, size_wanted),
                     default_seed,
                     0,
                     read_rules(file, find),
                     read_look(find)};
  panel.look.fills_notches = panel.rules.joint == BranchJoint::sides;
  at_place(n, [&] { panel.model.require_size(panel.n); });
  if (const auto walk = find("walk")) panel.walk = read_walk(*walk);
  if (const auto caption = find("caption")) panel.caption = caption->text(caption_wanted);
  if (const auto seed = find("seed")) panel.seed = seed->whole(0, INT64_MAX, number_wanted);
  if (const auto replicate = find("replicate"))
    panel.replicate = replicate->whole(0, INT64_MAX, number_wanted);
  return panel;
}

}  // namespace

std::span<const std::string_view> panel_keys() {
  return all_panel_keys;
}

std::vector<PicturePanel> read_panels(std::string_view file, const TomlTable& preset) {
  const auto panels = preset.find("panel");
  if (!panels) return {read_panel(file, [&](std::string_view key) { return preset.find(key); })};
  std::vector<PicturePanel> read;
  for (const auto& element : panels->elements(panels_wanted)) {
    const TomlTable own(file, element.table(panels_wanted));
    own.require_known("a [[panel]] table", all_panel_keys);
    read.push_back(read_panel(file, [&](std::string_view key) {
      auto value = own.find(key);
      return value ? value : preset.find(key);
    }));
  }
  return read;
}

}  // namespace ramify::detail
