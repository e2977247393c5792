// Ctrl-C and SIGTERM end every verb within two seconds, whatever it is in the middle of.
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "program.hpp"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ramify::test {
namespace {

using Clock = std::chrono::steady_clock;

/// A program that was started in the background, with a standard input that never ends.
class Started {
 public:
  Started(const std::string& command, const std::string& err) {
    if (pipe(input_.data()) != 0) return;
    child_ = fork();
    if (child_ != 0) return;
    dup2(input_[0], STDIN_FILENO);
    const int out = open("/dev/null", O_WRONLY), error = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(error, STDERR_FILENO);
    close(input_[1]);
    if (chdir(RAMIFY_SOURCE) == 0) execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
    _exit(127);
  }
  ~Started() {
    close(input_[0]);
    close(input_[1]);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  bool runs() const { return waitpid(child_, nullptr, WNOHANG) == 0; }

  struct End {
    int code;
    double seconds;
  };
  End stop(int signal) const {
    const auto begin = Clock::now();
    kill(child_, signal);
    int status = 0;
    waitpid(child_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status),
            std::chrono::duration<double>(Clock::now() - begin).count()};
  }

 private:
  std::array<int, 2> input_{-1, -1};
  pid_t child_ = -1;
};

struct LongWork {
  const char* name;
  std::string arguments;

  friend std::ostream& operator<<(std::ostream& out, const LongWork& work) { return out << work.name; }
};

class Stop : public testing::TestWithParam<std::tuple<LongWork, int>> {};

TEST_P(Stop, EndsLongWorkWithinTwoSeconds) {
  const auto& [work, signal] = GetParam();
  const Scratch scratch;
  std::string arguments = work.arguments;
  const std::string here = "HERE";
  for (auto at = arguments.find(here); at != std::string::npos; at = arguments.find(here))
    arguments.replace(at, here.size(), scratch.path().string());
  scratch.file("slow.toml",
               "models=[\"bst\"]\nn=[30000000]\nreplicates=1000\nstatistics=[\"height\"]\ngraft=false\n");
  scratch.file("law.toml",
               "models=[\"beta(0.5,2)\",\"dst(0.3)\",\"patricia(0.2)\"]\nn=[1000000000]\n"
               "replicates=2\nstatistics=[\"height\",\"strahler\",\"balance\",\"streams\"]\n");
  ramify("sample --model bst --n 3000 --format parens -o " + (scratch / "tree.txt").string());
  const std::string err = (scratch / "err").string();
  const Started started(std::string(RAMIFY_PROGRAM) + " " + arguments, err);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  ASSERT_TRUE(started.runs()) << "no long work: " << read_file(err);
  const auto [code, seconds] = started.stop(signal);
  EXPECT_EQ(code, 128 + signal) << read_file(err);
  EXPECT_LT(seconds, 2) << read_file(err);
  EXPECT_TRUE(read_file(err).ends_with("ramify: interrupted\n")) << read_file(err);
  EXPECT_EQ(shell("find " + scratch.path().string() + " -name '*.part'").out, "");
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, Stop,
    testing::Combine(
        testing::Values(
            LongWork{"Sample", "sample --model bst --n 2^40 --no-graft --yes"},
            LongWork{"SampleOfAGrownModel", "sample --model 'node_beta(d,d)' --n 1e7 --replicates 100"},
            LongWork{"SampleThatGrafts", "sample --model catalan --n 2^45 --statistics height --yes"},
            LongWork{"SampleOfTrees",
                     "sample --model 'node_beta(d,d)' --n 5e6 --replicates 20 --format parens -o HERE/trees"},
            LongWork{"SampleOfSplitTrees", "sample --model 'beta(0.5,0.5)' --n 3e7 --format newick"},
            LongWork{"Law", "law --model bst --n 3e5 --statistic depth --exact"},
            LongWork{"LawOnAGrid", "law --model 'beta(0.5,0.7)' --n 1e200 --statistic height --yes"},
            LongWork{"MeasureOfAStreamThatNeverEnds", "measure -"},
            LongWork{"TestOfATree", "test HERE/tree.txt --model bst --replicates 1e6"},
            LongWork{"Trie", "trie --n 1e11"}, LongWork{"TrieOfNodes", "trie --n 1e5 --nodes --p 0.01"},
            LongWork{"Theory",
                     "theory --model 'beta(0.01,0.02),beta(2,3),beta(3,4),beta(4,5),beta(5,6),"
                     "beta(6,7),beta(7,8),beta(8,9),beta(9,10),beta(10,11),beta(11,12)'"},
            LongWork{"Run", "run HERE/slow.toml --out HERE/o"},
            LongWork{"RunInItsLaws", "run HERE/law.toml --out HERE/o"},
            LongWork{"Reproduce", "reproduce --scale full --out HERE/o"},
            LongWork{"DrawOfAStreamThatNeverEnds", "draw --tree - -o HERE/tree.svg"},
            LongWork{"DrawOfALargeTree", "draw --model bst --n 2e6 -o HERE/tree.png"},
            LongWork{"Design", "design --ratio 3 --n 1e6"}, LongWork{"DesignOfAMap", "design --map"},
            LongWork{"Fit", "fit data/lung.csv"}),
        testing::Values(SIGINT, SIGTERM)),
    [](const auto& test) {
      return std::get<0>(test.param).name +
             std::string(std::get<1>(test.param) == SIGINT ? "AtCtrlC" : "AtSigterm");
    });

}  // namespace
}  // namespace ramify::test
