#include "ramify/core/memory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// Of what a limit leaves, the program itself and its libraries take some.
constexpr double own_bytes = 32e6;

/// Of what is there; the rest is for the system and what else runs on it, or lost between allocations.
constexpr double usable_share = 0.9;

unsigned processes_here = 1;

double limit_of(int resource) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return HUGE_VAL;
  return std::max(0.0, usable_share * (static_cast<double>(limit.rlim_cur) - own_bytes));
}

/// Of the control group that a container runs in; where it has none the file is not there, or says "max".
double group_limit() {
  double bytes = HUGE_VAL;
  std::ifstream file("/sys/fs/cgroup/memory.max");
  return file >> bytes ? bytes : HUGE_VAL;
}

/// Private memory that is mapped already, used or not: a sanitizer's shadow alone is larger than any machine.
double mapped_memory() {
  std::array<double, 6> pages{};  // size, resident, shared, text, lib, data
  std::ifstream file("/proc/self/statm");
  for (double& kind : pages) file >> kind;
  return pages.back() * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Two digits of the largest size of which the bytes are there.
std::uint64_t largest_that_fits(std::uint64_t size, const std::function<double(std::uint64_t)>& bytes,
                                double there) {
  std::uint64_t fits = 0, too_large = size;
  while (too_large - fits > 1) {
    const std::uint64_t middle = fits + (too_large - fits) / 2;
    (bytes(middle) <= there ? fits : too_large) = middle;
  }
  std::uint64_t unit = 1;
  while (fits / unit >= 100) unit *= 10;
  return fits / unit * unit;
}

}  // namespace

double usable_memory() {
  const double machine = usable_share * static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                         static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::min(
      {machine / processes_here, group_limit() / processes_here, limit_of(RLIMIT_AS), limit_of(RLIMIT_DATA)});
}

void share_memory(unsigned processes) {
  processes_here = processes;
}

std::string in_bytes(double bytes) {
  constexpr std::array<const char*, 5> units{"kB", "MB", "GB", "TB", "PB"};
  double value = bytes / 1000;
  std::size_t unit = 0;
  for (; value >= 1000 && unit + 1 < units.size(); ++unit) value /= 1000;
  return fmt::format("{:.3g} {}", value, units[unit]);
}

void require_memory(std::string_view what, std::string_view name, std::uint64_t size,
                    const std::function<double(std::uint64_t)>& bytes) {
  const double needed = bytes(size), there = usable_memory();
  if (needed <= there) return;
  const std::uint64_t fits = largest_that_fits(size, bytes, there);
  throw Error(fmt::format("{} {}: {} would take about {} of memory", name, size, what, in_bytes(needed)),
              fmt::format("this process may use {}", in_bytes(there)),
              fits > 0 ? fmt::format("take {} {} or less", name, fits) : "take a smaller tree");
}

void bound_memory() {
  rlimit limit{};
  const double bytes = usable_memory();
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || mapped_memory() > bytes) return;
  if (!(bytes < static_cast<double>(limit.rlim_cur))) return;
  limit.rlim_cur = static_cast<rlim_t>(bytes);
  ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace ramify
