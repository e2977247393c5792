#include "ramify/core/error.hpp"
#include "ramify/ranks/joined_team.hpp"
#include "ramify/ranks/started_with.hpp"

namespace ramify {

std::unique_ptr<JoinedTeam> join_team(Cancellation&) {
  if (!is_started_with_others()) return nullptr;
  throw Error("several processes were started together",
              "this ramify was built without MPI, and each of them would do the whole work",
              "start one, or build with -DRAMIFY_MPI=ON (docs/cluster.md)");
}

}  // namespace ramify
