#pragma once

// The table as far as it does not depend on the world: the progress of the simulation, and
// functions on a state as a whole.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/bodies/coordinate_block.h"
#include "engine/bodies/table/step_progress.h"

namespace spoke {

/// The table, whatever the world: functions that steps and windows, failures and restarts need.
class StepTable {
 public:
  StepTable() = default;
  StepTable(const StepTable&) = delete;
  StepTable& operator=(const StepTable&) = delete;

  Window window;
  /// One progress and one hub motion for all subsystems, because the hub has a free coordinate, the
  /// formulation solves for all at once, or a load of the user's or a loop is between subsystems.
  /// Else each has its own.
  bool is_coupled = false;
  std::vector<StepProgress> progress;  ///< one, or one for each subsystem

  /// Steps that have a place in the rings of records.
  virtual std::size_t ring_size() const = 0;
  /// Return the passes of a step, by progress number `index`, and the most of all. Precondition:
  /// the step has a record.
  virtual std::int64_t passes_of(std::size_t index, std::int64_t step) const = 0;
  virtual std::int64_t most_passes_of(std::int64_t step) const = 0;
  /// Calls `apply` with each block of coordinates, in fixed order.
  virtual void for_each_block(const std::function<void(CoordinateBlock&)>& apply) = 0;
  /// Returns the memory of all that the next step and the sensors depend on: coordinates, histories
  /// and accelerations, loads of the joints, and the progress.
  virtual std::vector<std::span<std::byte>> state_memory() = 0;
  /// Copies the state at the end of step `step`; `values` keeps its memory (state_values.h).
  virtual void take_state(std::int64_t step, std::vector<double>& values) = 0;
  /// Sets the table to a state that was taken at the end of step `step`.
  virtual void put_state(std::span<const double> values, std::int64_t step) = 0;
  /// Remembers the record of a step, which an evaluation at its end overwrites.
  virtual void keep_record(std::int64_t step) = 0;
  /// Takes the record that an evaluation has made of a step.
  virtual void take_evaluated_record(std::int64_t step) = 0;
  /// Puts back the record that was kept.
  virtual void return_record(std::int64_t step) = 0;

  virtual bool has_loads() const = 0;  ///< whether the user has given loads
  virtual bool is_any_load_failed()
      const = 0;  ///< whether one has failed since clear_load_failures()
  virtual void clear_load_failures() = 0;

 protected:
  ~StepTable() = default;
};

}  // namespace spoke
