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
  slow,       ///< in fewer rounds than planned, to save time
  no_answer,  ///< the process did not answer in time and was killed
  failed,     ///< the process could not simulate, or ended by itself
};
/// "measured", "slow", "no_answer", "failed".
std::string_view name_of(Status status);

struct Measurement {
  Configuration configuration;
  Status status = Status::measured;
  std::string message = {};                ///< of no_answer and failed: what happened, for people
  std::vector<double> step_times = {};     ///< by round: time per step [s]
  std::vector<std::uint64_t> hashes = {};  ///< of the state after each batch, warm-ups included
};

/// Quarters of a batch at the very start: the last one shows what is too slow to go on with.
constexpr int kTrials = 2;
/// Untimed batches before the first round: memory is touched, and an executor that tunes itself has
/// done so. Fewer of a configuration that is slow.
constexpr int kWarmUpBatches = 12;
/// All steps of a process, trials and warm-ups included; what leaves early does fewer.
std::int64_t steps_of(std::int64_t batch, int rounds);

struct Effort {
  int rounds = 20;
  /// Of a configuration, after which it leaves the rounds, two of which it does. If it will, it
  /// spends half of that on its warm-up at most, but for the last batch. If a batch takes more than
  /// half of that, it leaves before the first, and the trial is its only sample. The serial one
  /// never leaves.
  double most_seconds = 6.0;
  /// What is slow makes fewer steps in a batch, so that it is in all rounds, instead of leaving
  /// before the first. Its hashes are then of other steps than serial's.
  bool shrinks_batches = false;
  double start_seconds = 120.0;  ///< allowed for a process to build its simulation
  double answer_seconds = 60.0;  ///< allowed for a batch
};

/// Makes the command that measures a configuration. The process answers "ready" when it is, "done
/// SECONDS HASH" to each "run STEPS", or "diverged MESSAGE" or "failed MESSAGE" in place of either.
using MakeCommand = std::function<Command(const Configuration&)>;
/// Steps in one batch of a formulation.
using BatchSize = std::function<std::int64_t(Formulation)>;
using bench::Progress;

/// Takes part in every round before the configurations do; all processes are halted meanwhile.
using BeforeRound = std::function<void()>;

/// Precondition: configurations as by make_configurations(). Throws DivergenceError if a
/// process says that the scenario diverged, InputError if a serial one leaves without a sample, and
/// what `before_round` throws.
std::vector<Measurement> measure(const std::vector<Configuration>& configurations,
                                 const MakeCommand& make_command, const BatchSize& batch_size,
                                 const Effort& effort, const Progress& progress,
                                 const BeforeRound& before_round = {});

}  // namespace spoke::compare
