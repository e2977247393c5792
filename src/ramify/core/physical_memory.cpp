#include "ramify/core/physical_memory.hpp"

#include <unistd.h>

namespace ramify {

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace ramify
