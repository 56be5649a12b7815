#pragma once

// The course of a hub's speed whose end an importer gives, communication step by communication
// step.

#include "models/curve.h"

namespace spoke::fmu {

/// Returns a curve of the hub's speed [rad/s] that passes through `speed` at time t [s] with the
/// integral `angle` from 0 to t [rad] (0 at t = 0), goes from there to `target` at constant
/// acceleration within `step` [s], and keeps that. What it was before t is of no meaning.
/// Preconditions: t >= 0, step > 0, all finite.
Curve speed_course(double t, double angle, double speed, double target, double step);

}  // namespace spoke::fmu
