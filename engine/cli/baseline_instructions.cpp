// The C library chooses its functions before main(), so that only a new start can change its mind.

#include "engine/cli/baseline_instructions.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

#include "engine/support/instructions.h"
#include "models/error.h"

namespace spoke::cli {

void use_baseline_instructions(char** arguments) {
  if (instructions_in_use() == "baseline") return;
  if (instructions_in_use() == "native")
    throw InputError(
        "--instructions baseline: this program was built for one processor "
        "(SPOKE_NATIVE), expected a build without that option");
  const char* before = std::getenv(kTunables);
  std::string tunables = before ? std::string(before) + ':' : std::string();
  tunables += kWithoutFusing;
  if (setenv(kTunables, tunables.c_str(), 1) == 0) execv("/proc/self/exe", arguments);
  throw InputError(
      "--instructions baseline: the program cannot be started again, expected that "
      "/proc/self/exe can be run");
}

}  // namespace spoke::cli
