// Runs: the same bytes for any number of threads, nothing lost when stopped, nothing that looks finished and
// is not.
#include "program.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ramify::test {
namespace {

constexpr const char* small_config = R"toml(
models     = ["bst", "beta(0.5,2)", "patricia(1/4.35)", "dst(0.3)", "catalan", "split(0.25)"]
n          = { from = 10, to = 1200, count = 4 }
replicates = { to_1e3 = 300, above = 30 }
statistics = ["size", "strahler", "height", "depth", "fill_level", "balance", "nodes", "streams",
              "streams_mean_ratio", "nodes_regression", "streams_geometric"]
)toml";

constexpr const char* quick_config =
    "models = [\"bst\", \"catalan\"]\nn = [10, 1000]\nreplicates = 20\nstatistics = [\"strahler\", "
    "\"nodes\"]\n";

std::string run_into(const Scratch& scratch, const std::string& text, const std::string& out,
                     const std::string& options) {
  const std::string config = scratch.file("small.toml", text);
  const Ran ran = ramify("run " + config + " --out " + (scratch / out).string() + " " + options);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return (scratch / out / "small").string();
}

TEST(Run, TablesAreTheSameBytesForOneTwoAndSevenThreads) {
  const Scratch scratch;
  const std::string one = run_into(scratch, small_config, "one", "--threads 1");
  for (const char* threads : {"2", "7"}) {
    const std::string other =
        run_into(scratch, small_config, std::string("t") + threads, std::string("--threads ") + threads);
    for (const char* table : {"/summary.csv", "/orders.csv", "/histograms.csv"}) {
      const std::string expected = read_file(one + table);
      EXPECT_GT(expected.size(), 200u);
      EXPECT_EQ(expected, read_file(other + table)) << table << " with " << threads << " threads";
    }
  }
}

TEST(Run, AnotherSeedGivesAnotherTable) {
  const Scratch scratch;
  const std::string one = run_into(scratch, quick_config, "one", "");
  const std::string other = run_into(scratch, quick_config, "two", "--seed 7");
  EXPECT_NE(read_file(one + "/summary.csv"), read_file(other + "/summary.csv"));
}

// It needs no config, and nothing is sampled.
TEST(Reproduce, DecidesAClaimThatTakesNoTrees) {
  const Scratch scratch;
  const Ran ran = ramify("reproduce --claim c3 --out " + (scratch / "out").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("C3.1"), std::string::npos) << ran.out;
  EXPECT_NE(read_file(scratch / "out/verdicts.csv").find("reproduced"), std::string::npos);
  const Ran served = ramify("run " + scratch.file("c.toml", std::string("claim = \"C3\"\n") + quick_config) +
                            " --out " + (scratch / "run").string());
  EXPECT_EQ(served.code, 2);
  EXPECT_NE(served.err.find("claim C3 (it is decided without trees): take it out of the config"),
            std::string::npos)
      << served.err;
}

TEST(Reproduce, DrawsWhatAClaimDrawsFromLaws) {
  const Scratch scratch;
  const Ran ran = ramify("reproduce --claim C10.1 --out " + (scratch / "out").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(read_file(scratch / "out/plots/C10_split_order.gp").find("log_(1/X) n + 1"), std::string::npos);
}

TEST(Run, ProvenanceSaysHowTheTableWasMade) {
  const Scratch scratch;
  const std::string folder = run_into(scratch, quick_config, "one", "--threads 2");
  const auto provenance = nlohmann::json::parse(read_file(folder + "/provenance.json"));
  EXPECT_EQ(provenance.at("status"), "complete");
  EXPECT_EQ(provenance.at("seed"), 1996);
  EXPECT_EQ(provenance.at("threads"), 2);
  EXPECT_EQ(provenance.at("config_text"), quick_config);
  EXPECT_TRUE(provenance.contains("version") && provenance.contains("compiler") &&
              provenance.contains("duration_seconds"));
}

TEST(Run, ProvenanceSaysWhatWasGrafted) {
  const Scratch scratch;
  const std::string config = scratch.file(
      "order.toml", "models=[\"bst\"]\nn=[1000, 1024]\nreplicates=5\nstatistics=[\"strahler\"]\n");
  const Ran ran = ramify("run " + config + " --out " + (scratch / "o").string());
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto sampled = nlohmann::json::parse(read_file(scratch / "o/order/provenance.json")).at("sampled");
  EXPECT_EQ(sampled.at(0).at("method"), "every node is grown");
  EXPECT_EQ(sampled.at(1).at("method"), "strahler of subtrees up to n = 256 drawn from the exact law");
}

TEST(Run, IsSilentOnStandardErrorWhenPipedExceptForItsClosingLines) {
  const Scratch scratch;
  const std::string config = scratch.file("small.toml", quick_config);
  const Ran ran = ramify("run " + config + " --out " + (scratch / "o").string());
  EXPECT_EQ(ran.err.find('\r'), std::string::npos) << "a progress line in a pipe";
}

// How soon every verb ends is tested in stop_test.cpp, what comes after it in
// tests/threads/run_stop_test.cpp.
TEST(Run, StopsAtASignalAndSaysWhereTheCompleteCellsAre) {
  const Scratch scratch;
  const std::string config = scratch.file("slow.toml",
                                          "replicates=10000\nstatistics=[\"strahler\"]\ngraft=false\n"
                                          "[[cells]]\nmodels=[\"bst\"]\nn=[100]\n"
                                          "[[cells]]\nmodels=[\"catalan\"]\nn=[3000000]\n");
  const std::string out = (scratch / "o").string(), work = out + "/slow.incomplete";
  const Ran stopped =
      shell(std::string(RAMIFY_PROGRAM) + " run " + config + " --out " + out + " & run=$!; until [ -s " +
            work + "/blocks.sqlite-wal ]; do kill -0 $run || break;" +
            " sleep 0.01; done; sleep 1; kill -INT $run; wait $run");
  EXPECT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("kept in " + work + "; continue with --resume"), std::string::npos)
      << stopped.err;
  EXPECT_FALSE(std::filesystem::exists(out + "/slow"));
  EXPECT_NE(read_file(work + "/summary.csv").find("bst,100,"), std::string::npos);
}

/// A config that lacks what its claim needs is refused before any work.
TEST(Run, RefusesAConfigThatCannotDecideItsClaim) {
  const Scratch scratch;
  const std::string config = scratch.file("c20.toml",
                                          "claim=\"C20\"\nmodels=[\"bst\"]\nn=[10, 20, 30]\nreplicates=5\n"
                                          "statistics=[\"strahler\"]\n");
  const Ran ran = ramify("run " + config + " --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find("claim C20 with 3 sizes of bst"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "o"));
}

TEST(Run, WithOneTreeACellDecidesNoClaim) {
  const Scratch scratch;
  const std::string config = scratch.file("c22.toml",
                                          "claim=\"C22\"\nmodels=[\"catalan\"]\nn=[10,20,30,40]\n"
                                          "replicates=1\nstatistics=[\"strahler\"]\n");
  const Ran ran = ramify("run " + config + " --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find("claim C22 with 1 replicate(s) at n = 10"), std::string::npos) << ran.err;
}

/// What a stopped run has kept is neither dropped nor taken over without a word.
TEST(Run, OverKeptCellsHasToBeMeant) {
  const Scratch scratch;
  const std::string config = scratch.file("small.toml",
                                          "models=[\"bst\"]\nn=[3000000]\nreplicates=10000\n"
                                          "statistics=[\"strahler\"]\ngraft=false\n");
  const std::string run = "run " + config + " --out " + (scratch / "o").string();
  const std::filesystem::path store = scratch / "o/small.incomplete/blocks.sqlite";
  shell(std::string(RAMIFY_PROGRAM) + " " + run + " & run=$!; until [ -s " + store.string() +
        "-wal ]; do kill -0 $run || break; sleep 0.01; done; sleep 1; kill -KILL $run; wait $run");
  scratch.file("small.toml", quick_config);
  const Ran refused = ramify(run);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("of a stopped run are kept in"), std::string::npos) << refused.err;
  const Ran another = ramify(run + " --resume");
  EXPECT_EQ(another.code, 2);
  EXPECT_EQ(count_lines(another.err), 1u) << another.err;
  EXPECT_NE(another.err.find("is of another run: it has"), std::string::npos) << another.err;
  EXPECT_TRUE(std::filesystem::exists(store));
  EXPECT_EQ(ramify(run + " --resume --restart").code, 2);
  EXPECT_EQ(ramify(run + " --restart").code, 0);
  EXPECT_FALSE(std::filesystem::exists(scratch / "o/small.incomplete"));
}

TEST(Run, DryRunSaysWhatItWouldCostAndDoesNothing) {
  const Scratch scratch;
  const Ran ran = ramify("run configs/quick/bst_order.toml --dry-run --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("nodes"), std::string::npos);
  EXPECT_NE(ran.out.find("minutes"), std::string::npos);
  EXPECT_NE(ran.out.find("MB"), std::string::npos);
  EXPECT_NE(ran.out.find("exact laws"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch / "o"));
}

TEST(Run, DryRunSaysWhichLawsWouldTakeTooLong) {
  const Scratch scratch;
  const std::string config = scratch.file("heights.toml",
                                          "models=[\"catalan\"]\nn=[1000000000]\nreplicates=1\n"
                                          "statistics=[\"strahler\", \"height\"]\n");
  const Ran ran = ramify("run " + config + " --dry-run --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("no exact_mean for height of catalan beyond n = "), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace ramify::test
