#pragma once

namespace ramify {

/// Whether a starter of parallel jobs (mpirun, srun) began this process together with others, by what it left
/// in the environment: a process alone does not pay for MPI_Init.
bool is_started_with_others();

}  // namespace ramify
