#pragma once

// Progress of a simulation, and the reports of passes and steps. Subsystems that share nothing but
// a prescribed hub do not wait for one another: each has progress of its own, iterates until its
// own coordinates have converged, and goes on to its next step. If the hub has a free coordinate,
// or one system is solved for all, one progress counts for all. The results of a step are kept in
// records, rings by the number of the step, until the whole system has made that step.

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

/// Control of one pass over the step graph: what it evaluates.
struct PassControl {
  static constexpr int kEvaluateOnly = -1;
  static constexpr int kRestart = -2;  ///< generalized_alpha: finds accelerations to start from

  double time = 0.0;          ///< time of the state to evaluate [s]
  int stage = kEvaluateOnly;  ///< stage of rk4, or iteration of generalized_alpha
  Flag is_implicit;           ///< solve with the implicit elastic block
  int order = 1;              ///< accelerations that a prediction goes on from, 1 to 3
  double relaxation = 1.0;    ///< share of the accelerations' change that the pass takes

  /// Whether the pass belongs to no step, and changes no coordinate.
  bool is_between_steps() const { return stage < 0; }
  /// Whether it is the first implicit one of a step, or one that belongs to none.
  bool begins_iteration() const { return is_implicit && stage <= 0; }
  /// Whether it is an implicit one of a step, but not the first.
  bool continues_iteration() const { return is_implicit && stage > 0; }
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
  double applied = 0.0;      ///< power of drive and loads, and of gravity that rises
  double dissipation = 0.0;  ///< power of damping
};

/// The deflection of a body beyond the range of linear elasticity.
struct LargeDeflection {
  double ratio = 0.0;  ///< deflection by the length of the body; 0: all are within the range
  int subsystem = -1;  ///< index from 0; -1 where a subsystem reports
  int body = -1;       ///< index from 0
};

/// Kinds of coordinates of the model.
enum class CoordinatePlace : std::int64_t { hub_position, hub_rotation, joint, deformation };

/// The estimated error of a step in a coordinate (see integrator/step_error.h).
struct StepError {
  double size = 0.0;   ///< [rad], or by a length of the model [-]; 0: none, or not known
  int subsystem = -1;  ///< index from 0; -1 for the hub, and where a subsystem reports
  int body = -1;       ///< index from 0; -1 for the hub
  CoordinatePlace place = CoordinatePlace::hub_position;
};

/// How near a loop is to a singular position.
struct LoopNearness {
  /// Least pivot of the loops' equations, each by what it was at the start; 1: none is less.
  double left = 1.0;
  std::int64_t subsystem = -1;  ///< index from 0; -1 where a subsystem reports
  std::int64_t row = -1;        ///< of all loops of the subsystem, from 0
};

/// Report of a pass, summed in fixed order over the bodies that report together.
struct PassReport {
  double change = 0.0;  ///< largest change of a coordinate in this iteration [m, rad]
  /// Largest change of accelerations in the first iteration of a step, by the change of a
  /// coordinate that follows from it [m, rad].
  double step_change = 0.0;
  Power power;
  bool failed = false;         ///< a body or the hub
  LargeDeflection deflection;  ///< the largest, the first of equal ones
  StepError error;             ///< the largest, in the first iteration of a step
  LoopNearness loop;           ///< the nearest
};

/// What the steps before tell the iteration of the next. Part of saved states, which hold doubles.
struct IterationMemory {
  static constexpr double kRound = 8.0;  ///< steps from one trial to the next, at least

  double usual_change = 0.0;  ///< largest step change of the last steps, fading [m, rad]
  double contraction = 0.0;   ///< largest of the last steps that have seen one, fading; 0: none has
  double known = 1.0;         ///< accelerations that are known since a restart, to 3
  double order = 2.0;         ///< see PassControl
  double first_change = 0.0;  ///< first change of the last step that took it [m, rad]
  double order_every = kRound;  ///< steps from one trial of the order to the next
  double turn = 0.0;            ///< place of the next step among those, see foresight.h
};

/// Where a subsystem, or a coupled system, stands, and what it needs to turn the end of a pass into
/// the start of the next (see integrator/step_control.h). Part of the table.
struct alignas(kInterferenceSize) StepProgress {
  static constexpr std::int64_t kNone = -1;

  PassControl control;             ///< control of the next pass
  std::int64_t step = 0;           ///< step that this pass belongs to; 0: the start
  std::int64_t completed = kNone;  ///< the step that the last pass completed
  int passes = 0;                  ///< within the step
  StepOutcome outcome = StepOutcome::done;
  Flag is_halted;          ///< nothing to do, at the end of the window or after a failure
  double change = 0.0;     ///< change in the last iteration [m, rad]
  double tolerance = 0.0;  ///< tolerance of the step's changes, or what is left of them [m, rad]
  IterationMemory remembered;
  double contraction =
      0.0;  ///< factor of changes by plain iterations, within the step; 0: not known
  double share_before = 1.0;  ///< share of its change that the last pass took
  Power power;                ///< power at the end of the last step
  double work = 0.0;          ///< work of drive and loads, within the step so far [J]
  double dissipated = 0.0;    ///< within the step so far [J]
  StepError error;            ///< error of the step
};

/// Results of a step, as far as one progress counts.
struct StepRecord {
  std::int64_t passes = 0;
  double work = 0.0;           ///< work of drive and loads during the step [J]
  double dissipated = 0.0;     ///< during the step [J]
  LargeDeflection deflection;  ///< the largest at its end
  StepError error;             ///< the largest
  LoopNearness loop;           ///< the nearest in its last pass
};
// Nodes assign whole records: bytes that belong to no member would differ from run to run.
static_assert(sizeof(StepRecord) == 3 * sizeof(double) + sizeof(LargeDeflection) +
                                        sizeof(StepError) + sizeof(LoopNearness));
static_assert(sizeof(StepError) == 3 * sizeof(double));
static_assert(sizeof(LoopNearness) == 3 * sizeof(double));

/// Bounds of one run over the step graph; set before it, constant during it.
struct Window {
  std::int64_t first = 0;  ///< the first step that has no record yet
  std::int64_t last = 0;   ///< no subsystem goes beyond the end of this step
  bool observed = false;   ///< samples are wanted
};

}  // namespace spoke
