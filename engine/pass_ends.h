#pragma once

// Where a pass meets the integrator: at its start coordinates are set, at its end the integrator
// takes the accelerations found, the state is checked, and all reports are summed in fixed order.

#include "engine/integrator/method.h"
#include "engine/step_data.h"

namespace spoke {

/// Sets the coordinates of a block for the pass.
void begin_block(const Method& method, const PassControl& control, CoordinateBlock& block) noexcept;

/// Sets the hub's coordinates, the prescribed ones by the drive, and its state.
void begin_hub(const System& system, const Method& method, StepData& data) noexcept;

/// Hands `body.a_found` to the integrator and reports the change and whether the deformation has
/// left its limits (a coordinate not finite, a displacement beyond the body's length, a rotation
/// beyond a half turn).
void complete_body(const Method& method, const PassControl& control, BodyData& body) noexcept;

/// Hands the hub's acceleration to the integrator; prescribed components follow the drive. Reports
/// the largest change of a free coordinate.
void complete_hub(const System& system, const Method& method, StepData& data) noexcept;

/// Sets position, velocity and acceleration of the hub's prescribed components at time t [s].
void impose_hub_motion(const System& system, double t, CoordinateBlock& hub) noexcept;

/// Sums the reports of a pass, in fixed order.
PassReport sum_reports(const StepData& data) noexcept;

/// A deformation coordinate that has left its limits.
struct Excess {
  int coordinate = -1;  ///< in the order "axial, then bending"; -1: none has
  double value = 0.0;
  double limit = 0.0;
};
/// Finds the first coordinate of a body that is not finite, or else the one farthest beyond its
/// limit.
Excess find_excess(const BodyData& body);

}  // namespace spoke
