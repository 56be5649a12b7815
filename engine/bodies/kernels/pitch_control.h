#pragma once

// The law of a pitch controller, and the course of the angle that it demands
// (docs/formulation.md, section 15).

#include <cstdint>
#include <optional>

#include "engine/bodies/space/joint_motion.h"
#include "engine/bodies/table/control_data.h"
#include "models/control.h"

namespace spoke {

/// Returns the state of a controller at t = 0.
ControlState start_control(const PitchControl& control);
/// Returns the state of an angle that is demanded from outside, at t = 0.
ControlState start_angle(double initial);

/// Returns the steps between two samples of a period [s], of a step without one, in steps of h [s].
std::int64_t count_sample_steps(const std::optional<double>& period, double h);

/// Demands an angle for the course from time t [s] to t + period [s].
void demand_angle(double angle, double t, double period, ControlState& state) noexcept;

/// Takes an angle from its controller at time t [s]: its course goes on from there with demands in
/// steps of h [s], its value, rate and acceleration continuous.
void hold_angle(double t, double h, ControlState& state) noexcept;

/// Takes a sample: filters the speed [rad/s], and demands an angle for the course from time t [s]
/// to t + period [s]. `is_first`: the filter begins with this speed.
void take_sample(const PitchControl& control, double speed, double t, double period, bool is_first,
                 ControlState& state) noexcept;

/// Returns the pitch angle at time t [s], from the newest sample to the next one.
space::PrescribedMotion follow(const ControlState& state, double t) noexcept;

}  // namespace spoke
