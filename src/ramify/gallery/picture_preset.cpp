#include "ramify/gallery/picture_preset.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/gallery/panel_reader.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

constexpr detail::Expected title_wanted{"a text", "title = \"An apple tree\""};
constexpr detail::Expected columns_wanted{"a whole number", "columns = 3"};

std::string read_line(const detail::TomlTable& table, std::string_view file, std::string_view key,
                      bool is_required) {
  if (const auto value = table.find(key)) return value->text(title_wanted);
  if (!is_required) return {};
  throw error_at({std::string(file), 0, 0}, fmt::format("no '{}'", key),
                 "a preset says what it shows and where it is from", fmt::format("add {} = \"...\"", key));
}

}  // namespace

PicturePreset parse_picture_preset(std::string_view text, const fs::path& name) {
  const std::string file = name.string();
  const toml::table document = detail::parse_toml(text, file);
  const detail::TomlTable table(file, document);
  std::vector<std::string_view> keys{"title", "source", "note", "columns", "panel"};
  keys.insert(keys.end(), detail::panel_keys().begin(), detail::panel_keys().end());
  table.require_known("a preset", keys);
  PicturePreset preset{file,
                       name.stem().string(),
                       read_line(table, file, "title", true),
                       read_line(table, file, "source", true),
                       read_line(table, file, "note", false),
                       0,
                       detail::read_panels(file, table)};
  constexpr std::uint64_t most_columns = 20;
  if (const auto columns = table.find("columns"))
    preset.columns = columns->whole(1, most_columns, columns_wanted);
  else
    preset.columns =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(preset.panels.size()))));
  return preset;
}

std::vector<std::string> picture_preset_names(const fs::path& folder) {
  std::error_code problem;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  if (problem)
    throw Error(fmt::format("no presets in '{}'", folder.string()), problem.message(),
                "name the folder that has draw/ with --configs");
  std::ranges::sort(names);
  return names;
}

PicturePreset find_picture_preset(const fs::path& folder, const std::string& name) {
  const auto names = picture_preset_names(folder);
  if (!std::ranges::binary_search(names, name))
    throw Error(fmt::format("no preset '{}'", name), fmt::format("{} has {}", folder.string(), names.size()),
                did_you_mean(name, names) + "see docs/gallery.md");
  const fs::path file = folder / (name + ".toml");
  return parse_picture_preset(read_text_file(file), file);
}

void change(PicturePreset& preset, const PresetChange& changes) {
  for (PicturePanel& panel : preset.panels) {
    if (changes.n) panel.n = *changes.n;
    panel.model.require_size(panel.n);
    panel.seed = changes.seed.value_or(panel.seed);
    panel.replicate = changes.replicate.value_or(panel.replicate);
    if (!changes.view.empty()) panel.look.view = parse_view(changes.view);
    if (!changes.style.empty()) panel.look.style = parse_tree_style(changes.style);
    if (!changes.color_by.empty()) panel.look.by_order = parse_color_by(changes.color_by);
  }
}

const std::vector<std::string>& sheet_views() {
  static const std::vector<std::string> views{"top", "oblique", "front", "right"};
  return views;
}

void show_in_sheet_views(PicturePreset& preset) {
  if (preset.panels.size() != 1)
    throw Error(fmt::format("--sheet of {}", preset.name),
                fmt::format("it shows {} trees, a sheet of views shows one", preset.panels.size()),
                "leave --sheet out");
  const PicturePanel panel = preset.panels.front();
  preset.panels.clear();
  for (const std::string& view : sheet_views()) {
    preset.panels.push_back(panel);
    preset.panels.back().caption = view;
    preset.panels.back().look.view = parse_view(view);
  }
  preset.columns = 2;
}

}  // namespace ramify
