#pragma once

// Where in time the parts of a system stand. Subsystems that share nothing but a prescribed hub do
// not wait for one another: each has a clock of its own, iterates until its own coordinates have
// converged, and goes on to its next step. If the hub has a free coordinate, or one system is
// solved for all, one clock counts for all. What a step leaves behind is kept in records, rings by
// the number of the step, until the whole system has made that step.

#include <cstdint>

#include "engine/apart.h"
#include "models/space.h"

namespace spoke {

/// What one pass over the step graph evaluates.
struct PassControl {
  static constexpr int kEvaluateOnly = -1;

  double time = 0.0;             ///< of the state to evaluate [s]
  double stage = kEvaluateOnly;  ///< of rk4, or iteration of generalized_alpha: a whole number
  double implicit = 0.0;         ///< 1: solve with the implicit elastic block

  bool is_implicit() const { return implicit != 0.0; }
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
  double applied = 0.0;      ///< of drive and loads
  double dissipation = 0.0;  ///< by damping
};

/// A deflection beyond the range of linear elasticity.
struct Bend {
  double ratio = 0.0;   ///< to the length of the body; 0: all are within the range
  double blade = -1.0;  ///< index from 0; where a subsystem reports, -1
  double body = -1.0;   ///< index from 0
};

/// What a pass found, summed in fixed order over the bodies that a clock counts for.
struct PassReport {
  double change = 0.0;  ///< largest change of a coordinate in this iteration [m, rad]
  Power power;
  double failed = 0.0;  ///< 1 if any body or the hub failed
  Bend bend;            ///< the largest, the first of equal ones
};

/// A clock and what it needs to turn the end of a pass into the start of the next (see
/// integrator/step_control.h). Part of the table: doubles only.
struct alignas(kApart) Clock {
  PassControl control;      ///< of the next pass
  double step = 0.0;        ///< number of the step that this pass belongs to; 0: the start
  double halted = 0.0;      ///< 1: nothing to do, at the end of the window or after a failure
  double completed = -1.0;  ///< number of the step that the last pass completed, else -1
  double outcome = 0.0;     ///< a StepOutcome
  double passes = 0.0;      ///< within the step
  double change = 0.0;      ///< of the last iteration [m, rad]
  Power power;              ///< at the end of the last step
  double work = 0.0;        ///< by drive and loads, within the step so far [J]
  double dissipated = 0.0;  ///< within the step so far [J]

  bool is_halted() const { return halted != 0.0; }
  StepOutcome ended() const { return static_cast<StepOutcome>(static_cast<int>(outcome)); }
};

/// What a step did, as far as one clock counts.
struct StepRecord {
  double passes = 0.0;
  double work = 0.0;               ///< by drive and loads during the step [J]
  double dissipated = 0.0;         ///< during the step [J]
  Twist reaction = Twist::Zero();  ///< of the support and drive on the hub at its end, hub frame
  Bend bend;                       ///< at its end
};

/// What the sensors show of a subsystem at the end of a step.
struct SubsystemSample {
  double tip_x = 0.0, tip_y = 0.0;  ///< displacement of the tip node, hub frame [m]
  double kinetic = 0.0;             ///< energy, stiffening term included [J]
  double strain = 0.0;              ///< energy [J]
  double gravity = 0.0;             ///< work of gravity since the undeformed start [J]
};

/// The step as a whole: what all clocks did, and the hub.
struct SystemRecord {
  StepRecord step;
  double applied_torque = 0.0;     ///< of a torque drive at the step's end [N m]
  Twist position = Twist::Zero();  ///< of the hub, inertial frame: x, y [m], angle [rad]
  Twist velocity = Twist::Zero();  ///< [m/s, rad/s]
};

/// What one run over the step graph may do; set before it, constant during it.
struct Window {
  std::int64_t first = 0;  ///< the first step that has no record yet
  std::int64_t last = 0;   ///< no clock goes beyond the end of this step
  bool observed = false;   ///< samples are wanted
};

}  // namespace spoke
