#pragma once

// How far a simulation has come, and what a pass and a step report. Subsystems that share nothing
// but a prescribed hub do not wait for one another: each has progress of its own, iterates until
// its own coordinates have converged, and goes on to its next step. If the hub has a free
// coordinate, or one system is solved for all, one progress counts for all. What a step leaves
// behind is kept in records, rings by the number of the step, until the whole system has made that
// step.

#include <cstdint>

#include "engine/support/page_arena.h"

namespace spoke {

/// Yes or no, in the table. Any bits are a value of it: the check of declarations fills what a node
/// must not read with bits of its own, most of which a bool may not hold.
class Flag {
 public:
  constexpr Flag(bool value = false) : bits_(value ? 1 : 0) {}
  constexpr operator bool() const { return bits_ != 0; }

 private:
  std::uint8_t bits_;
};

/// What one pass over the step graph evaluates.
struct PassControl {
  static constexpr int kEvaluateOnly = -1;
  static constexpr int kRestart = -2;  ///< generalized_alpha: finds accelerations to start from

  double time = 0.0;          ///< of the state to evaluate [s]
  int stage = kEvaluateOnly;  ///< of rk4, or iteration of generalized_alpha
  Flag is_implicit;           ///< solve with the implicit elastic block
  double relaxation = 1.0;    ///< share of the accelerations' change that the pass takes

  /// Whether the pass belongs to no step, and changes no coordinate.
  bool is_between_steps() const { return stage < 0; }
  /// Whether it is the first implicit one of a step, or one that belongs to none.
  bool begins_iteration() const { return is_implicit && stage <= 0; }
};

/// How a step ended.
enum class StepOutcome {
  done,
  left_limits,    ///< a body's deformation or an acceleration is not finite or beyond its limits
  not_converged,  ///< the iteration did not reach its tolerance
  energy_grew,    ///< complete, but with more energy than work explains
  load_failed,    ///< a load of the user's failed; the state is that before the step
};

/// Rates of work [W].
struct Power {
  double applied = 0.0;      ///< of drive and loads, and of gravity that rises
  double dissipation = 0.0;  ///< by damping
};

/// The deflection of a body beyond the range of linear elasticity.
struct LargeDeflection {
  double ratio = 0.0;  ///< to the length of the body; 0: all are within the range
  int blade = -1;      ///< index from 0; where a subsystem reports, -1
  int body = -1;       ///< index from 0
};

/// Which coordinates of the model.
enum class CoordinatePlace : std::int64_t { hub_position, hub_rotation, joint, deformation };

/// The estimated error of a step in a coordinate (see integrator/step_error.h).
struct StepError {
  double size = 0.0;  ///< [rad], or by a length of the model [-]; 0: none, or not known
  int blade = -1;     ///< index from 0; of the hub, and where a subsystem reports, -1
  int body = -1;      ///< index from 0; of the hub -1
  CoordinatePlace place = CoordinatePlace::hub_position;
};

/// What a pass found, summed in fixed order over the bodies that report together.
struct PassReport {
  double change = 0.0;  ///< largest change of a coordinate in this iteration [m, rad]
  /// Of the first iteration of a step: the largest change of accelerations in it, by what it moves
  /// a coordinate [m, rad].
  double step_change = 0.0;
  Power power;
  bool failed = false;         ///< a body or the hub
  LargeDeflection deflection;  ///< the largest, the first of equal ones
  StepError error;             ///< the same, of the first iteration of a step
};

/// Where a subsystem, or a coupled system, stands, and what it needs to turn the end of a pass into
/// the start of the next (see integrator/step_control.h). Part of the table.
struct alignas(kInterferenceSize) StepProgress {
  static constexpr std::int64_t kNone = -1;

  PassControl control;             ///< of the next pass
  std::int64_t step = 0;           ///< that this pass belongs to; 0: the start
  std::int64_t completed = kNone;  ///< the step that the last pass completed
  int passes = 0;                  ///< within the step
  StepOutcome outcome = StepOutcome::done;
  Flag is_halted;             ///< nothing to do, at the end of the window or after a failure
  double change = 0.0;        ///< of the last iteration [m, rad]
  double tolerance = 0.0;     ///< of the step's changes, or what is left of them [m, rad]
  double usual_change = 0.0;  ///< largest step change of the last steps, fading [m, rad]
  double contraction = 0.0;   ///< of changes by plain iterations, within the step; 0: not known
  double share_before = 1.0;  ///< of its change that the last pass took
  Power power;                ///< at the end of the last step
  double work = 0.0;          ///< by drive and loads, within the step so far [J]
  double dissipated = 0.0;    ///< within the step so far [J]
  StepError error;            ///< of the step
};

/// What a step did, as far as one progress counts.
struct StepRecord {
  std::int64_t passes = 0;
  double work = 0.0;           ///< by drive and loads during the step [J]
  double dissipated = 0.0;     ///< during the step [J]
  LargeDeflection deflection;  ///< the largest at its end
  StepError error;             ///< the largest
};
// Nodes assign whole records: bytes that belong to no member would differ from run to run.
static_assert(sizeof(StepRecord) ==
              3 * sizeof(double) + sizeof(LargeDeflection) + sizeof(StepError));
static_assert(sizeof(StepError) == 3 * sizeof(double));

/// What one run over the step graph may do; set before it, constant during it.
struct Window {
  std::int64_t first = 0;  ///< the first step that has no record yet
  std::int64_t last = 0;   ///< no subsystem goes beyond the end of this step
  bool observed = false;   ///< samples are wanted
};

}  // namespace spoke
