#include <memory>

#include "session.hpp"
#include "verbs.hpp"

#include "ramify/tabulate/trie_table.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct TrieArguments {
  std::string p = "1/2", n, epsilon = "0.2", strings, seed = "1996", replicates = "1";
  Output output;
  bool nodes = false;
};

ExitCode trie(const TrieArguments& options, const Cancellation& cancellation) {
  TrieRequest request;
  if (!options.strings.empty()) request.strings = split_list(options.strings);
  if (request.strings.empty() == options.n.empty())
    throw Error("trie without --n or --strings, or with both", "it is of n random strings or of given ones",
                "write --n 1000, or --strings 01001,01011,10011");
  request.rule = {request.strings.empty() ? read_count("--n", options.n) : request.strings.size(),
                  read_real("--p", options.p), read_real("--epsilon", options.epsilon)};
  if (request.rule.n == 0) throw Error("--n 0", "a trie has one string at least", "take 1 or more");
  request.seed = read_count("--seed", options.seed);
  request.replicates = read_count("--replicates", options.replicates);
  emit(options.nodes ? trie_node_table(request, cancellation) : trie_zone_table(request, cancellation),
       options.output);
  return ExitCode::done;
}

}  // namespace

void add_trie(Program& program) {
  auto options = std::make_shared<TrieArguments>();
  Verb verb = program.verb(
      "trie", "Cardinalities of a trie's nodes, and the zones of the proof that bounds its balance number");
  verb.option("--p", options->p, "probability of bit 0, which is left", Need::defaulted);
  verb.option("--n", options->n, "number of random strings");
  verb.option("--strings", options->strings, "the strings themselves, 01001,01011,10011");
  verb.option("--epsilon", options->epsilon,
              "zone A: n q >= n^epsilon, zone C: n q <= n^-epsilon, B between them", Need::defaulted);
  verb.flag("--nodes", options->nodes, "a row for every node: path, strings through it, n q, zone");
  verb.option("--replicates", options->replicates, "number of random tries", Need::defaulted);
  verb.option("--seed", options->seed, "seed; the tries are those of sample --model \"trie(p)\"",
              Need::defaulted);
  options->output.add_table_to(verb);
  verb.example("Example: ramify trie --strings 01001,01011,10011,10100,11100 --nodes");
  verb.work([options](const Cancellation& cancellation) { return trie(*options, cancellation); });
}

}  // namespace ramify::cli
