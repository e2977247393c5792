#include <memory>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/design/depth_height_table.hpp"
#include "ramify/design/height_map.hpp"
#include "ramify/design/moment_table.hpp"
#include "ramify/design/ratio_designs.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct DesignArguments {
  std::string depth, height, ratio, n, mean, variance, plot;
  Output output;
  bool map = false;
};

/// One question at a time, and all of it.
void require_one_question(const DesignArguments& options) {
  std::vector<std::string> asked;
  if (options.map || !options.depth.empty()) asked.emplace_back(options.map ? "--map" : "--depth");
  if (!options.ratio.empty()) asked.emplace_back("--ratio");
  if (!options.mean.empty()) asked.emplace_back("--mean");
  if (asked.size() > 1)
    throw Error(fmt::format("{} and {}", asked[0], asked[1]), "design answers one question",
                "leave one of them out");
  if (options.map && !options.height.empty())
    throw Error("--height with --map", "a map has all heights", "leave one of them out");
  const std::pair<const std::string&, const char*> parts[] = {
      {options.height, "--height"}, {options.n, "--n"}, {options.variance, "--variance"}};
  const char* const wholes[] = {"--depth", "--ratio", "--mean"};
  for (std::size_t i = 0; i < std::size(parts); ++i)
    if (!parts[i].first.empty() && (asked.empty() || asked[0] != wholes[i]))
      throw Error(fmt::format("{} without {}", parts[i].second, wholes[i]), "that is half a question",
                  fmt::format("add {}", wholes[i]));
  if (asked.empty())
    throw Error("design without a question", "it must know what the tree shall have",
                "write, say, --depth 2 --height 4.4, --ratio 3, --mean 0.3 --variance 0.02, or --map");
  if (!options.mean.empty() && options.variance.empty())
    throw Error("--mean without --variance", "that is half a question", "add --variance");
}

Table design_map(const DesignArguments& options, const std::optional<PictureFile>& picture,
                 const ScanEffort& effort) {
  std::vector<double> depths;
  for (const auto& depth : split_list(options.depth)) depths.push_back(read_real("--depth", depth));
  Table map = height_map(depths.empty() ? map_depths() : depths, effort);
  if (picture) picture->draw(height_map_plot(map));
  return map;
}

Table designs(const DesignArguments& options, const ScanEffort& effort) {
  if (!options.mean.empty())
    return moment_table(read_real("--mean", options.mean), read_real("--variance", options.variance));
  if (!options.ratio.empty()) {
    const double ratio = read_real("--ratio", options.ratio);
    return options.n.empty() ? limiting_ratio_designs(ratio, effort)
                             : finite_ratio_designs(ratio, read_count("--n", options.n), effort);
  }
  const double depth = read_real("--depth", options.depth);
  if (options.height.empty()) return depth_curve_table({depth, effort});
  const double height = read_real("--height", options.height);
  return depth_height_table({depth, effort}, height);
}

ExitCode design(const DesignArguments& options, const Cancellation& cancellation) {
  require_one_question(options);
  const auto picture = picture_file(options.plot);
  if (picture && !options.map)
    throw Error("--plot without --map", "the map is what has a picture", "add --map, or leave --plot out");
  const ScanEffort effort{read_threads(""), &cancellation};
  emit(options.map ? design_map(options, picture, effort) : designs(options, effort), options.output);
  return ExitCode::done;
}

}  // namespace

void add_design(Program& program) {
  auto options = std::make_shared<DesignArguments>();
  Verb verb = program.verb(
      "design",
      "The models whose trees have a wanted depth and height, ratio, or mean and variance of splits");
  verb.option("--depth", options->depth,
              "depth constant: D_n ~ D log n; alone: the curve of all beta(a,b) that have it");
  verb.option("--height", options->height, "height constant: H_n ~ H log n; with --depth");
  verb.option("--ratio", options->ratio, "Horton ratio of streams, of the limit or, with --n, of that size");
  verb.option("--n", options->n, "size: the ratio is that of expected counts, pooled over orders");
  verb.option("--mean", options->mean, "mean of the split fraction X ~ beta(a,b)");
  verb.option("--variance", options->variance, "its variance; with --mean");
  verb.flag("--map", options->map,
            "the heights that go with each depth; with --depth D[,D..] of these depths");
  options->output.add_table_to(verb);
  verb.option("--plot", options->plot, "draw the map into this file, FILE.svg or FILE.png");
  verb.example("Example: ramify design --depth 2 --height 4.4");
  verb.work([options](const Cancellation& cancellation) { return design(*options, cancellation); });
}

}  // namespace ramify::cli
