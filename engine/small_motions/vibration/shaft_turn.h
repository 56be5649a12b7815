#pragma once

// Shafts seen from outside: a subsystem that is round about the hub's axis has constant matrices
// for what stands around it.
//
// Turned by psi about the axis, a shape of the shaft is a shape again: y becomes exp(G psi) y. With
// z = exp(G psi) y, the motion as it is seen from outside at psi = W t,
//
//   M z'' + (C - 2 W M G) z' + (K - W C G + W^2 M G^2) z,
//
// with what stands, such as bearings, in C and K as at psi = 0.

#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/standing_axes.h"

namespace spoke::vibration {

/// Returns G, square of the size of the subsystem's independent coordinates; empty: it is no shaft,
/// as nodes are beside the hub's axis, or its shapes, turned about the axis, are none of it.
Eigen::MatrixXd find_turn(std::size_t subsystem, const Linearised& all);

/// Returns exp(G psi).
Eigen::MatrixXd turn_by(const Eigen::MatrixXd& G, double psi);

/// Returns the matrices of a shaft seen from outside at psi = 0. `speed`: of the hub, W [rad/s].
steady::LinearSubsystem stand_shaft(const steady::LinearSubsystem& turning,
                                    const Eigen::MatrixXd& G, double speed);

/// Returns those at azimuth psi, where its matrices `turning` were found.
steady::SizedMatrices stand_shaft_at(double psi, const steady::LinearSubsystem& turning,
                                     const Eigen::MatrixXd& G, double speed);

}  // namespace spoke::vibration
