// Looks for what launchers of MPI tell their processes.

#include <cstdlib>

#include "program/ranks/launch.h"

namespace spoke::ranks {

bool is_launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE", "PMI_RANK"})
    if (std::getenv(variable) != nullptr) return true;
  return false;
}

}  // namespace spoke::ranks
