#pragma once

// Measures configurations in turns, each in a process of its own: all processes are made first and
// halted, then every round lets each go on for one batch of steps.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/compare/child.h"
#include "bench/compare/configuration.h"
#include "bench/compare/interleaved.h"

namespace spoke::compare {

enum class Status {
  measured,
  slow,       ///< measured in fewer rounds than planned, to save time
  no_answer,  ///< the process did not answer in time and was killed
  failed,     ///< the process could not simulate, or ended by itself
};
/// Returns "measured", "slow", "no_answer" or "failed".
std::string_view name_of(Status status);

struct Measurement {
  Configuration configuration;
  Status status = Status::measured;
  std::string message = {};                ///< no_answer, failed: description of what happened
  std::vector<double> step_times = {};     ///< by round: time per step [s]
  std::vector<std::uint64_t> hashes = {};  ///< state after each batch, also of warm-ups
};

/// Number of trials, each a quarter of a batch, at the very start: the last one shows which
/// configurations are too slow to go on with.
constexpr int kTrials = 2;
/// Number of untimed batches before the first round, in which memory is touched and executors tune
/// themselves. A slow configuration makes fewer.
constexpr int kWarmUpBatches = 12;
/// Returns all steps of a process, trials and warm-ups included; one that leaves early makes fewer.
std::int64_t steps_of(std::int64_t batch, int rounds);

struct Effort {
  int rounds = 20;
  /// Time after which a configuration leaves the rounds, but not before the second [s]. One that
  /// will leave spends at most half of this time on its warm-up, but for the last batch. One whose
  /// batch takes more than half of it leaves before the first round, and the trial is its only
  /// sample. The serial one never leaves.
  double most_seconds = 6.0;
  /// Whether a slow configuration makes fewer steps in a batch, so that it takes part in all rounds
  /// instead of leaving before the first. Its hashes are then of other steps than serial's.
  bool shrinks_batches = false;
  double start_seconds = 120.0;  ///< allowed for a process to build its simulation
  double answer_seconds = 60.0;  ///< allowed for a batch
};

/// Makes the command that measures a configuration. The process first answers "ready", then "done
/// SECONDS HASH" to each "run STEPS"; or "diverged MESSAGE" or "failed MESSAGE" in place of either.
using MakeCommand = std::function<Command(const Configuration&)>;
/// Returns the number of steps in one batch of a formulation.
using BatchSize = std::function<std::int64_t(Formulation)>;
using bench::Progress;

/// Measures the configurations in turns. Precondition: make_configurations() made them. Throws
/// DivergenceError if a process reports that the scenario diverged, InputError if a serial one
/// leaves without a sample.
std::vector<Measurement> measure(const std::vector<Configuration>& configurations,
                                 const MakeCommand& make_command, const BatchSize& batch_size,
                                 const Effort& effort, const Progress& progress);

}  // namespace spoke::compare
