#pragma once

// At which steps pictures are taken.

#include <cstddef>
#include <cstdint>

#include "engine/simulation.h"

namespace spoke::run_report {

/// The steps at which the whole shape is recorded: those of every k-th output time (see
/// OutputTimes), and the last. There the blades must meet, so they are no closer to one another
/// than the window of steps that the caller of the program asked for.
class PictureSteps {
 public:
  /// No more than `most` of them, the first and the last not counted; 0: at all output times.
  PictureSteps(const Simulation& simulation, std::size_t most);

  /// The first of them after step `step`; the last step if there is none.
  std::int64_t next(std::int64_t step) const;

 private:
  double multiples_at(std::int64_t step) const;

  std::int64_t planned_;
  double step_size_;
  double interval_;  ///< [s]
};

}  // namespace spoke::run_report
