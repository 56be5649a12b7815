#pragma once

// Checkpoints of a run: when they are written, and how a run resumes from one.

#include <chrono>
#include <filesystem>
#include <optional>

#include "engine/checkpoint.h"
#include "engine/simulation.h"

namespace spoke::cli {

/// Loads a checkpoint and restores its state. Throws InputError, its text beginning with the file,
/// if it cannot be read, holds no record of a run, does not belong to this simulation, was computed
/// with other instructions or stands beyond its end.
Checkpoint resume(const std::filesystem::path& file, Simulation& simulation);

/// Warns on standard error if another version of Spoke wrote the checkpoint.
void warn_of_version(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// The checkpoints of a run: one file, replaced every so many seconds of wall time.
class Checkpoints {
 public:
  /// `every`: seconds from one checkpoint to the next; none: no checkpoints.
  Checkpoints(std::filesystem::path file, std::optional<double> every);

  bool are_wanted() const { return every_.has_value(); }
  /// Whether a checkpoint is due. Cheap enough for every step.
  bool is_due() const { return every_ && Clock::now() >= next_; }
  /// Writes a checkpoint. Throws InputError if it cannot; the previous one is then still there.
  void save(const Simulation& simulation, const RunRecord& record);
  const std::filesystem::path& file() const { return file_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start_waiting();

  std::filesystem::path file_;
  std::optional<double> every_;
  Clock::time_point next_;
};

}  // namespace spoke::cli
