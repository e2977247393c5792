#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "config_folder.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/config/run_config.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/draw/drawing_file.hpp"
#include "ramify/draw/node_link.hpp"
#include "ramify/draw/sheet.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/gallery/form_table.hpp"
#include "ramify/gallery/gallery.hpp"
#include "ramify/gallery/preset_drawing.hpp"
#include "ramify/shape/place_limbs.hpp"
#include "ramify/shape/usual_rules.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/read_count.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace ramify::cli {
namespace {

struct DrawArguments {
  std::string tree, format = "auto", root, which, model, n, seed, replicate, preset, configs, style, view,
                    color_by, table, label, up, side = "800", leaf_order = "1", gallery, output;
  bool same_lengths = false, keep_unary = false, sheet = false;
};

/// A picture of a form, in place of a node-link diagram.
bool is_form(const std::string& style) {
  return style == "lines" || style == "bars" || style == "branches";
}

void require_style(const std::string& style) {
  if (style.empty() || is_form(style) || style == "dendrogram" || style == "upright") return;
  throw Error(fmt::format("--style {}", style), "no such style",
              did_you_mean(style, {"dendrogram", "upright", "lines", "bars", "branches"}) +
                  "take dendrogram or upright for a diagram, lines, bars or branches for a form");
}

/// One of several trees must be named: which of them is drawn is never a guess.
RecordedTree chosen(std::vector<RecordedTree> trees, const DrawArguments& options) {
  if (options.which.empty() && trees.size() > 1)
    throw Error(fmt::format("{} holds {} trees", options.tree, trees.size()), "a drawing shows one",
                fmt::format("add --which K, K from 1 to {}", trees.size()));
  const std::uint64_t which = options.which.empty() ? 1 : read_count("--which", options.which);
  if (which < 1 || which > trees.size())
    throw Error(fmt::format("--which {}", which),
                fmt::format("{} holds {} trees", options.tree, trees.size()),
                fmt::format("take a number from 1 to {}", trees.size()));
  return std::move(trees[which - 1]);
}

RecordedTree read_tree(const DrawArguments& options) {
  Remarks remarks;
  auto trees = read_trees(read_tree_file(options.tree), options.tree, parse_tree_format(options.format),
                          {options.root}, remarks);
  for (const auto& line : remarks.lines(options.tree)) fmt::print(stderr, "ramify: warning: {}\n", line);
  RecordedTree tree = chosen(std::move(trees), options);
  const bool has_own_form = is_form(options.style) && !tree.places.empty();
  return options.keep_unary || has_own_form ? tree : contract_unary(std::move(tree));
}

/// Of the places of a measured tree.
Upwards upwards_of(const DrawArguments& options, const RecordedTree& tree) {
  if (options.up.empty()) return Upwards::y;
  if (tree.places.empty())
    throw Error(fmt::format("--up {}", options.up), "the tree has no coordinates",
                "leave it out, or draw a file of points (SWC)");
  if (options.up != "y" && options.up != "z")
    throw Error(fmt::format("--up {}", options.up), "it is y or z", "take one of these");
  return options.up == "y" ? Upwards::y : Upwards::z;
}

/// Of a tree, its form and the outlines of its picture: what was measured and a tenth; and of the page.
double drawing_bytes(double nodes) {
  return 6e7 + 300 * nodes;
}

/// The model, size, seed and replicate that are asked for, as the one panel of a picture.
PicturePanel grown_panel(const DrawArguments& options) {
  if (options.n.empty())
    throw Error(fmt::format("--model {} without --n", options.model), "a tree has a size",
                "add --n, say --n 100");
  Model model = Model::parse(options.model);
  const Size n = read_count("--n", options.n);
  model.require_size(n);
  const std::uint64_t seed = options.seed.empty() ? default_seed : read_count("--seed", options.seed);
  const std::uint64_t replicate =
      options.replicate.empty() ? 0 : read_count("--replicate", options.replicate);
  return {{}, std::move(model), n, seed, replicate, {}, {}};
}

/// Refuses a tree whose form would not fit into memory.
void require_drawing_memory(const PicturePanel& panel) {
  require_memory("the drawing", "--n", panel.n,
                 [&](Size size) { return drawing_bytes(expected_pieces(panel, size)); });
}

RecordedTree grow_tree(const PicturePanel& panel, const DrawingFile& file, const Cancellation& cancellation) {
  file.require_room(expected_nodes(panel.model, panel.n));
  require_drawing_memory(panel);
  return panel_tree(panel, cancellation);
}

/// The one thing that is drawn; which of several is never a guess.
void require_one_subject(const DrawArguments& options) {
  std::vector<std::string> given;
  for (const auto& [name, value] :
       {std::pair("--tree", &options.tree), std::pair("--model", &options.model),
        std::pair("--preset", &options.preset), std::pair("--gallery", &options.gallery)})
    if (!value->empty()) given.emplace_back(name);
  if (given.size() == 1) return;
  if (given.empty())
    throw Error(
        "neither --tree nor --model nor --preset nor --gallery", "a drawing shows one tree",
        "name a file with --tree, grow one with --model and --n, or name a preset of docs/gallery.md");
  throw Error(fmt::format("{} and {}", given[0], given[1]), "a drawing shows one tree", "leave one out");
}

double side_of(const DrawArguments& options) {
  constexpr std::uint64_t least = 50, most = 20'000;
  const std::uint64_t side = read_count("--side", options.side);
  if (side < least || side > most)
    throw Error(fmt::format("--side {}", side), fmt::format("it lies from {} to {}", least, most),
                "take a side in between");
  return static_cast<double>(side);
}

/// The form of a tree of which nobody has named rules: its own as far as it was measured, else the thesis's.
Shape usual_shape(const DrawArguments& options, const RecordedTree& tree, const PicturePanel* grown,
                  const Cancellation& cancellation) {
  const Upwards upwards = upwards_of(options, tree);
  if (!tree.places.empty()) return measured_shape(tree, upwards);
  if (grown == nullptr) {
    Stream none({0, 0}, 0, Lane::form);  // these rules draw nothing
    return place_limbs(tree.tree, measured_rules(tree), none, cancellation);
  }
  PicturePanel panel = *grown;
  panel.rules = thesis_rules(tree.tree);
  return panel_shape(panel, tree.tree, cancellation);
}

Drawing form_drawing(const DrawArguments& options, const RecordedTree& tree, const PicturePanel* grown,
                     const Cancellation& cancellation) {
  TreeLook look;
  look.style = parse_tree_style(options.style);
  look.by_order = options.color_by.empty() || parse_color_by(options.color_by);
  look.tips_are_branches = grown == nullptr;
  const Shape shape = usual_shape(options, tree, grown, cancellation);
  const std::vector<std::string> views =
      options.sheet ? sheet_views() : std::vector{options.view.empty() ? "front" : options.view};
  Sheet sheet(views.size(), 2, options.sheet, side_of(options));
  for (const auto& view : views) {
    look.view = parse_view(view);
    sheet.add(options.sheet ? view : std::string(), tree.tree, shape, look, cancellation);
  }
  return sheet.drawing();
}

Drawing diagram(const DrawArguments& options, const RecordedTree& tree) {
  if (!options.view.empty() || options.sheet || !options.color_by.empty() || !options.up.empty())
    throw Error("--view, --sheet, --up or --color-by of a diagram",
                "a node-link diagram lies in a plane, coloured by order",
                "add --style branches for a form, or leave it out");
  const std::uint64_t leaf_order = read_count("--leaf-order", options.leaf_order);
  if (leaf_order > 1)
    throw Error(fmt::format("--leaf-order {}", leaf_order), "it is 0 or 1", "take one of these");
  NodeLinkStyle style{options.style.empty() ? NodeLinkStyle::Form::dendrogram : parse_form(options.style),
                      static_cast<unsigned>(leaf_order), options.same_lengths};
  if (!options.label.empty()) style.number = parse_node_number(options.label);
  return node_link_diagram(tree, style);
}

Drawing tree_drawing(const DrawArguments& options, const DrawingFile& file,
                     const Cancellation& cancellation) {
  std::optional<PicturePanel> panel;
  if (options.tree.empty()) panel = grown_panel(options);
  const RecordedTree tree = panel ? grow_tree(*panel, file, cancellation) : read_tree(options);
  file.require_room(static_cast<double>(tree.tree.node_count()));
  if (is_form(options.style)) return form_drawing(options, tree, panel ? &*panel : nullptr, cancellation);
  return diagram(options, tree);
}

PicturePreset asked_preset(const DrawArguments& options) {
  PicturePreset preset = find_picture_preset(config_folder(options.configs, "draw"), options.preset);
  PresetChange changes;
  if (!options.n.empty()) changes.n = read_count("--n", options.n);
  if (!options.seed.empty()) changes.seed = read_count("--seed", options.seed);
  if (!options.replicate.empty()) changes.replicate = read_count("--replicate", options.replicate);
  changes.view = options.view;
  changes.style = options.style;
  changes.color_by = options.color_by;
  change(preset, changes);
  if (options.sheet) show_in_sheet_views(preset);
  return preset;
}

Drawing picture(const DrawArguments& options, const DrawingFile& file, const Cancellation& cancellation) {
  const PicturePreset preset = asked_preset(options);
  file.require_room(expected_pieces(preset));
  for (const PicturePanel& panel : preset.panels) require_drawing_memory(panel);
  return preset_drawing(preset, side_of(options), cancellation);
}

void print_table(const DrawArguments& options, const Cancellation& cancellation) {
  const FormTable kind = parse_form_table(options.table);
  if (options.preset.empty())
    throw Error("--table without --preset", "it measures the form of a preset",
                "name one, or measure a tree of a file with ramify measure");
  const PicturePreset preset = asked_preset(options);
  for (const PicturePanel& panel : preset.panels) require_drawing_memory(panel);
  emit(form_table(preset, kind, cancellation), {options.output, false});
}

ExitCode draw(const DrawArguments& options, const Cancellation& cancellation) {
  require_one_subject(options);
  require_style(options.style);
  if (!options.label.empty() && (is_form(options.style) || !options.preset.empty()))
    throw Error("--label of a form", "numbers stand at the nodes of a diagram",
                "take --tree or --model with --style dendrogram or upright");
  if (!options.up.empty() && options.tree.empty())
    throw Error("--up without --tree", "a grown tree has its foot below", "leave it out");
  if (!options.gallery.empty()) {
    draw_gallery(options.gallery, config_folder(options.configs, "draw"), cancellation);
    return ExitCode::done;
  }
  if (!options.table.empty()) {
    print_table(options, cancellation);
    return ExitCode::done;
  }
  if (options.output.empty())
    throw Error("--output is required", "a drawing goes into a file", "add -o FILE.svg");
  const DrawingFile file(options.output);
  file.write(options.preset.empty() ? tree_drawing(options, file, cancellation)
                                    : picture(options, file, cancellation),
             cancellation);
  return ExitCode::done;
}

/// How it is drawn.
void add_look(Verb& verb, DrawArguments& options) {
  verb.option(
      "--style", options.style,
      "dendrogram (root at the left, right angles; the usual one) or upright (root at the bottom); or "
      "a form in space: lines, bars or branches");
  verb.option("--view", options.view, "of a form: front, right, back, left, top, bottom or oblique");
  verb.option("--up", options.up, "of a file of points: the coordinate that points up, y (if left out) or z");
  verb.flag("--sheet", options.sheet, "of a form: four views in one drawing");
  verb.option("--color-by", options.color_by, "of a form: order or bark");
  verb.option("--side", options.side, "of the picture of a form, in pixels", Need::defaulted);
  verb.option("--leaf-order", options.leaf_order, "order of the tips in the key: 0 or 1", Need::defaulted);
  verb.option("--label", options.label,
              "of a diagram: at every node its order, depth, leaves, balance or alternate_balance");
  verb.flag("--same-lengths", options.same_lengths,
            "every branch as long as another, whatever the file says");
}

}  // namespace

void add_draw(Program& program) {
  auto options = std::make_shared<DrawArguments>();
  Verb verb = program.verb(
      "draw",
      "Draw a tree: as a node-link diagram coloured by Horton-Strahler order, or in its botanical form");
  verb.option("--tree", options->tree, "file with a tree; - is standard input");
  verb.option("--format", options->format, "of the file, as of measure; auto: found by content",
              Need::defaulted);
  verb.option("--root", options->root, "of a table, as of measure: the id of the root, all or neurites");
  verb.option("--which", options->which,
              "of a file with several trees: the place of the one to draw, from 1");
  verb.flag("--keep-unary", options->keep_unary, "keep one-child nodes instead of contracting them");
  verb.option("--model", options->model, "or grow a tree of this model; see: ramify list models");
  verb.option("--n", options->n, "its size");
  verb.option("--seed", options->seed, "seed; 1996 where it is left out, of a preset its own");
  verb.option("--replicate", options->replicate,
              "the tree that sample --no-graft prints under this number; 0 where it is left out");
  verb.option("--preset", options->preset, "or draw a picture of the sources; see docs/gallery.md");
  verb.option("--gallery", options->gallery, "or draw all of them into this new folder, with a page");
  verb.option("--table", options->table,
              "of a preset, measures of its form instead of a drawing: summary or orders");
  verb.option("--configs", options->configs, "the folder that holds draw/, the presets");
  add_look(verb, *options);
  verb.option("-o,--output", options->output,
              "the drawing, FILE.svg, FILE.pdf, FILE.ps or FILE.png, written in one step");
  verb.example("Example: ramify draw --model bst --n 200 -o bst.svg");
  verb.work([options](const Cancellation& cancellation) { return draw(*options, cancellation); });
}

}  // namespace ramify::cli
