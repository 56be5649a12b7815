// The C library chooses its functions before main(), so that only a new start can change its mind.

#include "engine/cli/choose_instructions.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/checkpoint.h"
#include "engine/study/journal.h"
#include "engine/support/instructions.h"
#include "models/error.h"

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

/// As study_command.cpp has it: named after the study's file.
std::filesystem::path journal_of(const Arguments& arguments) {
  const std::filesystem::path folder =
      arguments.out.empty() ? "results" / std::filesystem::path(arguments.study).stem()
                            : std::filesystem::path(arguments.out);
  return folder / "study.journal";
}

/// What the run or study that is resumed was computed with; empty if none is, or if its file cannot
/// be read, which is told when it is resumed.
std::string instructions_before(const Arguments& arguments) {
  if (arguments.resumes) {
    const auto journal = study::find_journal(journal_of(arguments).string());
    return journal ? journal->instructions : std::string();
  }
  if (arguments.resume.empty()) return {};
  try {
    return load_checkpoint(arguments.resume).instructions;
  } catch (const InputError&) {
    return {};
  }
}

/// Changes to these where that is possible; what then differs is refused when it is resumed.
void go_on_with(const std::string& before, char** words) {
  if (instructions_in_use() == "native") return;
  if (before == "baseline") use_baseline(words);
  if (before == "avx2") use_kernels(Kernels::avx2);
}

}  // namespace

void choose_instructions(const Arguments& arguments, char** words) {
  const std::string& name = arguments.instructions;
  if (name == "auto") return go_on_with(instructions_before(arguments), words);
  if (instructions_in_use() == "native")
    throw InputError("--instructions " + name +
                     ": this program was built for one processor (SPOKE_NATIVE), expected a "
                     "build without that option");
  if (name == "baseline") return use_baseline(words);
  use_avx2();
}

}  // namespace spoke::cli
