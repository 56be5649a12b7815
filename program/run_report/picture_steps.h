#pragma once

// Steps at which pictures are taken.

#include <cstddef>
#include <cstdint>

#include "engine/simulation.h"

namespace spoke::run_report {

/// The steps at which the whole shape is recorded: those of every k-th output time (see
/// OutputTimes), and the last. All blades must be at the same step there, so these steps are no
/// closer than the window of steps that the user asked for.
class PictureSteps {
 public:
  /// Chooses no more than `most` steps, the first and the last not counted; 0: at all output times.
  PictureSteps(const Simulation& simulation, std::size_t most);

  /// Returns the first of them after step `step`; the last step if there is none.
  std::int64_t next(std::int64_t step) const;

 private:
  double multiples_at(std::int64_t step) const;

  std::int64_t planned_;
  double step_size_;
  double interval_;  ///< [s]
};

}  // namespace spoke::run_report
