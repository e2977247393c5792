#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include <benchmark/benchmark.h>

namespace {

/// Prints the median of the repetitions, in the order of the program: on a machine that is shared, the mean
/// measures the neighbours. --benchmark_out keeps every repetition.
class MedianReporter : public benchmark::ConsoleReporter {
 public:
  MedianReporter() : ConsoleReporter(OO_Tabular) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(shown_), [](const Run& run) {
      return run.error_occurred || run.repetitions <= 1 || run.aggregate_name == "median";
    });
  }

  void Finalize() override {
    std::stable_sort(shown_.begin(), shown_.end(), [](const Run& a, const Run& b) {
      return std::tie(a.family_index, a.per_family_instance_index) <
             std::tie(b.family_index, b.per_family_instance_index);
    });
    ConsoleReporter::ReportRuns(shown_);
    ConsoleReporter::Finalize();
  }

  bool failed() const {
    return std::any_of(shown_.begin(), shown_.end(), [](const Run& run) { return run.error_occurred; });
  }

 private:
  std::vector<Run> shown_;
};

}  // namespace

/// Every program here runs its repetitions in random order, so that a slow minute of the machine hits all of
/// its rows; any flag can be overridden from the command line.
int main(int argc, char** argv) {
  std::array<std::string, 2> defaults{"--benchmark_repetitions=5",
                                      "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments{argv[0]};
  for (std::string& flag : defaults) arguments.push_back(flag.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return reporter.failed() ? 1 : 0;
}
