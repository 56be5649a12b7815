#pragma once

#include <span>
#include <vector>

#include "engine/step_data.h"

namespace spoke {

/// A copy of what the next step depends on: coordinates, histories and accelerations of hub and
/// bodies, and the clocks. All else in the table is recalculated by a pass.
class StateCopy {
 public:
  /// Prepares to copy the state of `data`, which must outlive this and stay in place.
  explicit StateCopy(StepData& data);

  void save();
  /// Sets the table back to what was saved last.
  void restore() const;

 private:
  std::vector<std::span<double>> state_;
  std::vector<double> values_;
};

}  // namespace spoke
