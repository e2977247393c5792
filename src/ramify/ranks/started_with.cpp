#include "ramify/ranks/started_with.hpp"

#include <cstdlib>
#include <string_view>

namespace ramify {

bool is_started_with_others() {
  // Open MPI's mpirun; those of MPICH and its kin, and srun --mpi=pmi2.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name)) return std::string_view(size) != "1";
  return std::getenv("PMIX_RANK") != nullptr;  // srun --mpi=pmix tells no size
}

}  // namespace ramify
