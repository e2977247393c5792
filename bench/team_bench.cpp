// What it costs rank 0 to lead: blocks that sleep where trees would grow, at a thousand a second. In one call
// messages alone, and with the store of a run:
//   mpirun -n 2 build/bench/bench/team_bench
// prints processor time of rank 0 a block, and as a share of one core.
#include <chrono>
#include <filesystem>
#include <numeric>
#include <thread>

#include "cpu_time.hpp"
#include <fmt/format.h>

#include "ramify/ranks/joined_team.hpp"
#include "ramify/run/block_store.hpp"
#include "ramify/run/grown_block.hpp"

namespace ramify::bench {
namespace {

constexpr std::size_t blocks = 5000;
constexpr unsigned threads = 8;               // of a rank; they sleep
constexpr std::chrono::milliseconds nap{16};  // of 2 x 8 threads: 1,000 blocks a second

Plan plan_of_a_cell() {
  const std::vector<std::string> names{"strahler", "height", "streams", "streams_mean_ratio"};
  const StatisticSet statistics = StatisticSet::parse(names);
  return {1996, statistics, sampling_method(statistics, true), {{Model::parse("bst"), 1'000'000, blocks}}};
}

/// The first block, whose sums stand for those of all.
GrownBlock first_block(const Plan& plan) {
  GrownBlock first;
  const Cancellation never;
  std::vector<GrowingJob> jobs = jobs_of(plan);
  jobs.front().last = 1;
  grow_blocks(jobs, 1, never,
              [&](const Block& block, const BlockTrees& trees) { first = grown_block(plan, block, trees); });
  return first;
}

void lead(JoinedTeam& team, const char* what, const std::function<void(std::size_t)>& keep,
          const Bytes& sent) {
  SharedWork work{what, std::vector<std::size_t>(blocks), {}, {}, {}};
  std::iota(work.items.begin(), work.items.end(), std::size_t{0});
  work.keep = [&](std::size_t item, unsigned) {
    std::this_thread::sleep_for(nap);
    keep(item);
  };
  work.send = [&](std::size_t, unsigned) {
    std::this_thread::sleep_for(nap);
    return sent;
  };
  work.take = [&](std::size_t item, const Bytes&) { keep(item); };
  const Cancellation never;
  const auto begin = std::chrono::steady_clock::now();
  const double spent = cpu_seconds([&] { team.share(work, threads, never); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (team.leads())
    fmt::print("{}: {:.0f} blocks/s of {} bytes, {:.1f} us of rank 0 a block, {:.2f} % of a core\n", what,
               blocks / wall.count(), sent.size(), 1e6 * spent / blocks, 100 * spent / wall.count());
}

void run() {
  Cancellation stopped;
  const auto team = join_team(stopped);
  if (team == nullptr) {
    fmt::print(stderr, "start it with mpirun -n 2\n");
    return;
  }
  const Plan plan = plan_of_a_cell();
  const GrownBlock block = first_block(plan);
  const Bytes bytes = encode(block);
  std::mutex mutex;
  lead(*team, "messages alone", [](std::size_t) {}, bytes);
  const auto file = std::filesystem::temp_directory_path() / "team_bench.sqlite";
  std::unique_ptr<BlockStore> store;
  if (team->leads()) {
    std::filesystem::remove(file);
    store = std::make_unique<BlockStore>(file, plan);
  }
  lead(
      *team, "with the store",
      [&](std::size_t item) {
        auto grown = decode_block(bytes, plan);
        grown->block.index = item;
        const std::lock_guard lock(mutex);
        store->save(*grown);
      },
      bytes);
  team->leave("");
}

}  // namespace
}  // namespace ramify::bench

int main() {
  ramify::bench::run();
  return 0;
}
