#include "reading.hpp"

#include <fmt/format.h>

#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

unsigned small_number(const std::string& option, const std::string& text, std::uint64_t most) {
  const std::uint64_t value = read_count(option, text);
  if (value > most)
    throw Error(fmt::format("{} {}", option, text), fmt::format("it is from 0 to {}", most),
                "take one of these");
  return static_cast<unsigned>(value);
}

}  // namespace

void add_resolve(Verb& verb, std::string& resolve) {
  verb.option("--resolve", resolve,
              "make forks of three and more into forks of two: ladder (in their order) or random");
}

void Reading::add_to(Verb& verb) {
  verb.option("FILE", files, "files of trees, or of counts of streams; - is standard input", Need::required);
  verb.option("--format", format,
              "newick, nexus, swc, mtg, qsm, edges, flowlines, parens or json; auto: found by content",
              Need::defaulted);
  verb.option("--leaf-order", leaf_order, "order of the tips in the table: 0 or 1", Need::defaulted);
  verb.option("--root", root,
              "of a table: the id of the root; all: every root a tree of its own; neurites: what leaves "
              "the soma of a neuron");
  verb.option("--scale", scale, "of an MTG: the scale of the nodes; 0 the finest", Need::defaulted);
  verb.flag("--keep-unary", keep_unary, "count one-child nodes, as in tries, instead of contracting them");
  add_resolve(verb, resolve);
}

MeasureRequest Reading::request() const {
  MeasureRequest request;
  request.files = files;
  request.format = parse_tree_format(format);
  request.leaf_order = small_number("--leaf-order", leaf_order, 1);
  request.reading = {root, small_number("--scale", scale, 1000)};
  request.keep_unary = keep_unary;
  if (!resolve.empty()) request.resolve = parse_fork_resolution(resolve);
  return request;
}

}  // namespace ramify::cli
