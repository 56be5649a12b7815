// The C library chooses its functions before main(), so that only a new start can change its mind.

#include "program/cli/choose_instructions.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

#include "models/error.h"
#include "models/support/instructions.h"

namespace spoke::cli {
namespace {

void use_baseline(char** words) {
  if (instructions_in_use() == "baseline") return;
  const char* before = std::getenv(kTunables);
  std::string tunables = before ? std::string(before) + ':' : std::string();
  tunables += kWithoutFusing;
  if (setenv(kTunables, tunables.c_str(), 1) == 0) execv("/proc/self/exe", words);
  throw InputError(
      "--instructions baseline: the program cannot be started again, expected that "
      "/proc/self/exe can be run");
}

void use_avx2() {
  use_kernels(Kernels::avx2);
  if (kernels_in_use() != Kernels::avx2)
    throw InputError("--instructions avx2: this program computes with " +
                     std::string(instructions_in_use()) +
                     " here, expected a processor with AVX2, and an environment (" + kTunables +
                     ") that does not forbid it");
}

/// Changes to the instructions `before` where that is possible. If it is not, resuming is refused
/// later.
void go_on_with(const std::string& before, char** words) {
  if (instructions_in_use() == "native") return;
  if (before == "baseline") use_baseline(words);
  if (before == "avx2") use_kernels(Kernels::avx2);
}

}  // namespace

void choose_instructions(const std::string& name, const std::function<std::string()>& before,
                         char** words) {
  if (name == "auto") return go_on_with(before(), words);
  if (instructions_in_use() == "native")
    throw InputError("--instructions " + name +
                     ": this program was built for one processor (SPOKE_NATIVE), expected a "
                     "build without that option");
  if (name == "baseline") return use_baseline(words);
  use_avx2();
}

}  // namespace spoke::cli
