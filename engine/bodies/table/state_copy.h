#pragma once

// A copy of a state within one table, to go back to.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/bodies/table/step_table.h"

namespace spoke {

/// A copy of StepTable::state_memory(). All else in the table is recalculated by a pass.
class StateCopy {
 public:
  /// Prepares to copy the state of `data`, which must outlive this and stay in place.
  explicit StateCopy(StepTable& data);

  void save();
  /// Sets the table back to what was saved last.
  void restore() const;

 private:
  std::vector<std::span<std::byte>> state_;
  std::vector<std::byte> values_;
};

}  // namespace spoke
