// Several hundred command lines that are wrong in one way each: one line on standard error that gives the
// right advice, exit code 2, nothing on standard output.
#include <map>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// What is wrong, and a part of what is said.
struct BadLine {
  std::string arguments, says;
};

using BadLines = std::vector<BadLine>;

/// A line of every verb that lacks nothing.
const std::map<std::string, std::string>& good_lines() {
  static const std::map<std::string, std::string> lines{
      {"list", "list models"},
      {"sample", "sample --model bst --n 10"},
      {"law", "law --model bst --n 10 --statistic height"},
      {"measure", "measure data/examples/sapling.newick"},
      {"test", "test data/examples/sapling.newick --model bst --replicates 99"},
      {"trie", "trie --n 10"},
      {"theory", "theory --model bst"},
      {"run", "run configs/quick/catalan_order.toml"},
      {"reproduce", "reproduce --claim C22"},
      {"fit", "fit data/species.csv"},
      {"design", "design --mean 0.3 --variance 0.02"},
      {"draw", "draw --model bst --n 20"},
      {"describe", "describe bash"}};
  return lines;
}

/// Of every verb.
BadLines bad_verbs() {
  BadLines lines;
  for (const auto& [verb, line] : good_lines()) {
    lines.push_back({line + " --sizes 3", verb + " --help"});
    lines.push_back({line + " --output", verb + " --help"});
    lines.push_back({line + " -q", verb + " --help"});
    lines.push_back({verb.substr(0, verb.size() - 1), "did you mean " + verb});
    lines.push_back({verb + "x", "did you mean " + verb});
    lines.push_back({line + " -o a -o b", verb + " --help"});
  }
  for (const char* verb : {"list", "law", "measure", "test", "theory", "run", "fit", "describe"})
    lines.push_back({verb, "--help"});
  for (const char* verb : {"list", "sample", "law", "measure", "trie", "theory", "design", "describe"}) {
    lines.push_back({good_lines().at(verb) + " -o /proc/no/such", "/proc/no/such"});
    lines.push_back({good_lines().at(verb) + " -o /tmp", "Is a directory"});
  }
  for (const char* verb : {"run", "reproduce"}) {
    lines.push_back({good_lines().at(verb) + " -o LICENSE", "Not a directory"});
    lines.push_back({good_lines().at(verb) + " --resume --restart", verb + std::string(" --help")});
    lines.push_back({good_lines().at(verb) + " --seed x", "whole number"});
  }
  return lines;
}

/// Sizes, seeds, replicates and threads are whole numbers.
BadLines bad_numbers() {
  BadLines lines;
  for (const char* number :
       {"x", "1.5", "1e", "1e-3", "0x10", "''", "1,5", "ten", "1/2", "nan", "inf", "1e99", "=-1"}) {
    const std::string value = number[0] == '=' ? number : " " + std::string(number);
    for (const char* option : {"sample --model bst --n", "trie --n", "sample --model bst --n 9 --seed",
                               "sample --model bst --n 9 --replicates",
                               "sample --model bst --n 9 --replicate", "sample --model bst --n 9 --threads"})
      lines.push_back({option + value, "--"});
    if (value != " 1,5" && value != " 1e99")
      lines.push_back({"law --model bst --statistic height --n" + value, "--n"});
  }
  for (const char* threads : {"0", "1025", "1e9"})
    for (const char* line : {"sample --model bst --n 9", "fit data/species.csv",
                             "test data/examples/sapling.newick --model bst"})
      lines.push_back({std::string(line) + " --threads " + threads, "from 1 to 1024"});
  for (const char* p : {"0", "1", "-0.5", "2", "x", "nan", "1/0", "''"})
    lines.push_back({"trie --n 10 --p=" + std::string(p), "p"});
  for (const char* epsilon : {"0", "-1", "x", "inf"})
    lines.push_back({"trie --n 10 --epsilon=" + std::string(epsilon), "epsilon"});
  return lines;
}

/// Models and their parameters, for the three verbs that take them alike.
BadLines bad_models() {
  const BadLines models{
      {"", "is empty"},
      {"bts", "did you mean bst"},
      {"BST", "did you mean bst"},
      {"catlan", "did you mean catalan"},
      {"patrica(0.3)", "did you mean patricia"},
      {"bst(1)", "takes 0"},
      {"catalan(2)", "takes 0"},
      {"beta", "takes 2"},
      {"beta(1)", "takes 2"},
      {"beta(1,2,3)", "takes 2"},
      {"beta(1,2", "without its ')'"},
      {"beta(0,1)", "[1e-9,1e9]"},
      {"beta(1,-1)", "[1e-9,1e9]"},
      {"beta(1e10,1)", "[1e-9,1e9]"},
      {"beta(1e308,1e308)", "[1e-9,1e9]"},
      {"beta(1e-10,1)", "[1e-9,1e9]"},
      {"beta(a,b)", "not a finite number"},
      {"beta(nan,1)", "not a finite number"},
      {"beta(inf,1)", "not a finite number"},
      {"beta_multinomial(1e100,1)", "[1e-9,1e9]"},
      {"beta_multinomial(1)", "takes 2"},
      {"split(0)", "(0,1)"},
      {"split(1)", "(0,1)"},
      {"split(3/2)", "(0,1)"},
      {"split(1/0)", "not a finite number"},
      {"split()", "not a finite number"},
      {"dst(0)", "(0,1)"},
      {"dst(1)", "(0,1)"},
      {"dst(0.2,0.3)", "takes 1"},
      {"patricia(-0.1)", "(0,1)"},
      {"patricia(0.1x)", "not a finite number"},
      {"aldous(-2)", "above -2"},
      {"aldous", "takes 1"},
      {"ford(-0.1)", "[0,1]"},
      {"ford(1.1)", "[0,1]"},
      {"file(nothing.csv)", "cannot read 'nothing.csv'"},
      {"file()", "write file(PATH)"},
      {"trie(1)", "(0,1)"},
      {"ternary(0.34)", "1/3"},
      {"flow_rate(0)", "(0,1]"},
      {"node_beta(d)", "takes 2"},
      {"node_beta(d+,1)", "node_beta: A"},
      {"node_dst(q)", "node_dst: P"},
      {"branching(0.5,0.4,0.2)", "sum to"},
      {"branching(0.5,0.5)", "takes 3"},
      {"galton_watson(0.5,0.5,0)", "p2"},
      {"tokunaga(0,1)", "above 0"},
      {"kary(1)", "k"},
      {"markov(nothing.csv)", "cannot read 'nothing.csv'"},
      {"hybrid(data/ramification_bst.csv,data/ramification_bst.csv,AC)", "neither A nor B"}};
  BadLines lines;
  for (const auto& [model, says] : models)
    for (const char* verb :
         {"sample --n 9", "law --n 9 --statistic height", "test data/examples/sapling.newick", "theory"})
      lines.push_back({std::string(verb) + " --model '" + model + "'", says});
  return lines;
}

/// What is unknown, what excludes another, what is in the wrong place.
BadLines bad_choices() {
  return {
      {"sample --model bst --n 10 --statistics strahlr", "did you mean strahler"},
      {"sample --model bst --n 10 --statistics hieght", "did you mean height"},
      {"sample --model bst --n 10 --statistics height,height", "given twice"},
      {"sample --model bst --n 10 --statistics streams_1", "streams"},
      {"sample --model bst --n 10 --replicate 3 --replicates 2", "--help"},
      {"sample --model bst --n 10 --format nwk", "newick"},
      {"sample --model bst --n 10 --format nexus", "not a format that sample writes"},
      {"sample --model bst --n 10 --format CSV", "did you mean csv"},
      {"sample --model bst", "--n"},
      {"sample --n 10", "--model"},
      {"sample", "--preset"},
      {"sample --preset appel", "did you mean apple"},
      {"sample --preset apple --model bst", "leave one of them out"},
      {"sample --model bst --n 1e14 --no-graft", "--yes"},
      {"sample --model 'beta(2,2)' --n 2^51", "reaches every index"},
      {"sample --model 'kary(3)' --n 1000", "smaller n"},
      {"law --model bst --n 10 --statistic strahlr", "did you mean strahler"},
      {"law --model bst --n 10 --statistic streams_mean_ratio", "known are those of"},
      {"law --model bst --n 10 --statistic width", "known are those of"},
      {"law --model bst --n 10 --statistic size", "known are those of"},
      {"law --model bst --n 10 --statistic height,depth", "known are those of"},
      {"law --model bst --n 10 --statistic sackin", "--moments"},
      {"law --model bst --n 10 --statistic height --covariances", "one number"},
      {"law --model bst --n 10 --statistic orders --covariances --moments", "--help"},
      {"law --model bst --n 10,10 --statistic height", "given twice"},
      {"law --model bst --n 10: --statistic height", "--n"},
      {"law --model bst --n 10:100 --statistic height", "from:to:count"},
      {"law --model bst --n 100:10:3 --statistic height", "exchange"},
      {"law --model bst --n 1e301 --statistic height", "1e300"},
      {"law --model 'trie(0.3)' --n 10 --statistic height", "sample it"},
      {"law --model bst --n 1e6 --statistic depth --exact", "--yes"},
      {"measure nothing.txt", "cannot read 'nothing.txt'"},
      {"measure docs", "cannot read 'docs'"},
      {"measure data/examples/sapling.newick --table sumary", "did you mean summary"},
      {"measure data/examples/sapling.newick --output summary", "--table summary"},
      {"measure data/examples/sapling.newick --output orders", "--table orders"},
      {"measure data/examples/sapling.newick -o nodes", "--table nodes"},
      {"measure data/examples/sapling.newick -o json", "--table json"},
      {"measure data/examples/sapling.newick -o levels", "--table levels"},
      {"measure data/examples/sapling.newick --table orders --statistics height", "--table summary"},
      {"measure data/examples/sapling.newick --statistics hieght", "did you mean height"},
      {"measure data/examples/sapling.newick --format nwk", "newick"},
      {"measure data/examples/sapling.newick --format swc", "sapling.newick:"},
      {"measure data/examples/sapling.newick --leaf-order 2", "from 0 to 1"},
      {"measure data/examples/sapling.newick --leaf-order x", "whole number"},
      {"measure data/examples/sapling.newick --scale x", "whole number"},
      {"measure data/examples/sapling.newick --resolve comb", "ladder"},
      {"measure data/examples/sapling_edges.csv --root nobody", "nobody"},
      {"measure LICENSE", "LICENSE:1"},
      {"test nothing.txt --model bst", "cannot read 'nothing.txt'"},
      {"test LICENSE --model bst", "LICENSE:1"},
      {"test data/examples/sapling.newick", "--model"},
      {"test data/examples/sapling.newick --model bst --replicates 98", "99 or more"},
      {"test data/examples/sapling.newick --model bst --resolve comb", "ladder"},
      {"test data/examples/sapling.newick --model 'trie(0.3)'", "internal nodes"},
      {"trie", "--strings"},
      {"trie --n 10 --strings 01,10", "or with both"},
      {"trie --n 0", "one string at least"},
      {"trie --strings 01,012", "0 and 1"},
      {"trie --strings 01,011", "begins with it"},
      {"list modles", "did you mean models"},
      {"list statistic", "did you mean statistics"},
      {"list models statistics", "--help"},
      {"theory --model bst,catlan", "did you mean catalan"},
      {"run nothing.toml", "nothing.toml"},
      {"run docs", "docs"},
      {"run README.md", "README.md:"},
      {"run configs/quick/depth.toml configs/full/depth.toml", "same file name"},
      {"reproduce --scale medium", "quick"},
      {"reproduce --claim C200", "did you mean C20"},
      {"reproduce --claim C20.", "C20"},
      {"reproduce --claim c20.7", "the parts of C20 end with C20.3"},
      {"reproduce --claim X1", "claim"},
      {"reproduce --configs nothere", "--configs"},
      {"reproduce --claim C22 --configs docs", "docs/quick"},
      {"fit nothing.csv", "nothing.csv"},
      {"fit LICENSE", "LICENSE"},
      {"fit data/species.csv --observable order", "ratio"},
      {"fit data/species.csv --format json", "table, csv"},
      {"fit data/species.csv --model bst", "patricia"},
      {"fit data/species.csv --model patrica", "patricia"},
      {"fit data/species.csv --n 1", "n"},
      {"fit data/species.csv --bootstrap 100", "leave it out"},
      {"fit data/walnut.csv --n 9", "leave it out"},
      {"fit data/walnut.csv --model patrica", "did you mean patricia"},
      {"fit data/walnut.csv --model patricia,catlan", "did you mean catalan"},
      {"fit data/walnut.csv --model ''", "is empty"},
      {"fit data/walnut.csv --bootstrap 10", "40 trees or more"},
      {"fit data/walnut.csv --bootstrap x", "--bootstrap"},
      {"fit data/walnut.csv --model patricia --curve c.csv", "add beta or beta_multinomial"},
      {"fit data/walnut.csv --model beta --plot c.jpg", ".svg or .png"},
      {"fit data/species.csv --robust", "--robust of a ratio"},
      {"fit data/examples/sapling.newick --curve c.csv", "--observable orders"},
      {"fit data/walnut.csv data/species.csv", "fits of one kind"},
      {"fit data/examples/sapling.newick --n 9", "leave it out"},
      {"fit data/examples/sapling.swc --resolve comb", "ladder"},
      {"fit data/species.csv --observable orders", "order"},
      {"design", "--depth 2 --height 4.4"},
      {"design --depth 2 --ratio 3", "leave one of them out"},
      {"design --map --mean 0.5 --variance 0.01", "leave one of them out"},
      {"design --height 4.4", "add --depth"},
      {"design --n 100", "add --ratio"},
      {"design --variance 0.02", "add --mean"},
      {"design --mean 0.3", "add --variance"},
      {"design --map --height 4", "a map has all heights"},
      {"design --depth 2 --height 4.4 --plot a.svg", "add --map"},
      {"design --map --depth 2 --plot a.pdf", "svg"},
      {"design --depth x --height 4", "not a finite number"},
      {"design --depth 1/0 --height 4", "not a finite number"},
      {"design --depth inf", "not a finite number"},
      {"design --depth 2 --height nan", "not a finite number"},
      {"design --depth=-2 --height 4", "1.442695"},
      {"design --depth 1.4", "1.442695"},
      {"design --depth 1e9", "take a smaller one"},
      {"design --depth 2,3 --height 4", "not a finite number"},
      {"design --map --depth 2,1", "1.442695"},
      {"design --depth 2 --height 5", "take --height 4.49772635"},
      {"design --depth 2 --height=-5", "take --height 4.307540352"},
      {"design --ratio 1.5", "2 or more"},
      {"design --ratio x", "not a finite number"},
      {"design --ratio 3 --n x", "whole number"},
      {"design --ratio 3 --n 2", "take a larger one"},
      {"design --ratio 30 --n 12", "or another size"},
      {"design --mean 1.5 --variance 0.1", "between 0 and 1"},
      {"design --mean 0.3 --variance 0.21", "take a smaller one"},
      {"design --mean 0.3 --variance 0", "take a larger one"},
      {"design --mean 0.3 --variance 1e-15", "take a larger variance"},
      {"draw --model bst --n 20", "--output"},
      {"draw --model bst --n 20 -o tree.gif", "svg"},
      {"draw --tree nothing.txt -o tree.svg", "cannot read 'nothing.txt'"},
      {"draw --model bst -o tree.svg", "--n"},
      {"draw -o tree.svg", "--tree"},
      {"draw --model bst --n 20 --style fan -o tree.svg", "upright"},
      {"describe fish", "man, bash or zsh"},
      {"describe zhs", "did you mean zsh"},
      {"", "--help"},
      {"--model bst", "--help"},
      {"-x", "--help"},
  };
}

/// Those that are not refused as they should be, a line each.
std::string not_refused_well(const BadLines& lines) {
  std::string wrong;
  for (const auto& [arguments, says] : lines) {
    const Ran ran = ramify(arguments);
    const bool well = ran.code == 2 && ran.out.empty() && count_lines(ran.err) == 1 &&
                      ran.err.starts_with("ramify: ") && ran.err.find(says) != std::string::npos;
    if (!well)
      wrong += "ramify " + arguments + "\n    wanted: " + says + "\n    status " + std::to_string(ran.code) +
               ": " + ran.err + '\n';
  }
  return wrong;
}

TEST(BadLines, OfVerbsAreRefusedWithAdvice) {
  EXPECT_EQ(not_refused_well(bad_verbs()), "");
}
TEST(BadLines, OfNumbersAreRefusedWithAdvice) {
  EXPECT_EQ(not_refused_well(bad_numbers()), "");
}
TEST(BadLines, OfModelsAreRefusedWithAdvice) {
  EXPECT_EQ(not_refused_well(bad_models()), "");
}
TEST(BadLines, OfChoicesAreRefusedWithAdvice) {
  EXPECT_EQ(not_refused_well(bad_choices()), "");
}
TEST(BadLines, AreManyAndTheLinesTheyComeFromAreGood) {
  EXPECT_GE(bad_verbs().size() + bad_numbers().size() + bad_models().size() + bad_choices().size(), 400u);
  for (const char* verb :
       {"list", "sample", "law", "measure", "test", "trie", "theory", "design", "describe"})
    EXPECT_EQ(ramify(good_lines().at(verb)).code, 0) << verb;
}

}  // namespace
}  // namespace ramify::test
