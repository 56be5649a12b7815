// Where the programs share the library of the engine, `spoke` lacks MPI alone: it goes on as
// `spoke-whole` where it is launched.

#include "program/cli/commands.h"
#include "program/ranks/launch.h"

namespace spoke::cli {

void require_enough(const Scenario&) {}

void require_enough(const Arguments&) {
  if (ranks::is_launched()) throw OtherProgramNeeded();
}

}  // namespace spoke::cli
