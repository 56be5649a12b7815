// The C library chooses its functions before main(), so that only a new start can change its mind.

#include "engine/cli/choose_instructions.h"

#include <unistd.h>

#include <cstdlib>

#include "engine/checkpoint.h"
#include "engine/support/instructions.h"
#include "models/error.h"

namespace spoke::cli {
namespace {

void use_baseline(char** arguments) {
  if (instructions_in_use() == "baseline") return;
  const char* before = std::getenv(kTunables);
  std::string tunables = before ? std::string(before) + ':' : std::string();
  tunables += kWithoutFusing;
  if (setenv(kTunables, tunables.c_str(), 1) == 0) execv("/proc/self/exe", arguments);
  throw InputError(
      "--instructions baseline: the program cannot be started again, expected that "
      "/proc/self/exe can be run");
}

void use_avx2() {
  use_kernels(Kernels::avx2);
  if (kernels_in_use() != Kernels::avx2)
    throw InputError("--instructions avx2: this program computes with " +
                     std::string(instructions_in_use()) +
                     " on this processor, expected one with kernels for AVX2");
}

/// What a checkpoint was computed with; empty if it cannot be read, which resume() will tell.
std::string instructions_of(const std::string& checkpoint) {
  try {
    return load_checkpoint(checkpoint).instructions;
  } catch (const InputError&) {
    return {};
  }
}

/// Changes to these where that is possible; resume() refuses what then differs.
void use_those_of(const std::string& checkpoint, char** arguments) {
  const std::string before = instructions_of(checkpoint);
  if (instructions_in_use() == "native") return;
  if (before == "baseline") use_baseline(arguments);
  if (before == "avx2") use_kernels(Kernels::avx2);
}

}  // namespace

void choose_instructions(const std::string& name, const std::string& resumed, char** arguments) {
  if (name == "auto" && !resumed.empty()) return use_those_of(resumed, arguments);
  if (name == "auto") return;
  if (instructions_in_use() == "native")
    throw InputError("--instructions " + name +
                     ": this program was built for one processor (SPOKE_NATIVE), expected a "
                     "build without that option");
  if (name == "baseline") return use_baseline(arguments);
  use_avx2();
}

}  // namespace spoke::cli
