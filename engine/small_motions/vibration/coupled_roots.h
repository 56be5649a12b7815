#pragma once

// Roots of a model whose subsystems meet at a hub that moves.

#include <vector>

#include "engine/small_motions/vibration/eigenvalues.h"

namespace spoke::vibration {

/// Returns the `count` roots of least magnitude, as find_roots() would for a pencil of all
/// subsystems, with vectors in its order: the hub, then subsystem by subsystem. Of N subsystems
/// that are alike only three patterns move the hub or feel it: those with the amplitudes 1,
/// cos(azimuth) and sin(azimuth), since the hub is a rigid body. The other patterns, orthogonal to
/// these, vibrate as one subsystem does while the hub is held, with N - 3 roots each (multi-blade
/// coordinates; Coleman and Feingold 1958, NACA report 1351). So a model of many subsystems costs
/// no more than one of three. `azimuths`: by subsystem [rad].
std::vector<Root> find_coupled_roots(const steady::LinearModel& model,
                                     const std::vector<double>& azimuths, Eigen::Index count);

/// Returns parts of a model that together have all of its roots. Where subsystems meet at a hub
/// that moves, these are the hub with the patterns that it feels, and for the other patterns one
/// subsystem of each kind with the hub held; otherwise one subsystem of each kind.
std::vector<steady::LinearModel> take_apart(const steady::LinearModel& model,
                                            const std::vector<double>& azimuths);

}  // namespace spoke::vibration
