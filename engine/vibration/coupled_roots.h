#pragma once

// Roots of a model whose trees meet at a hub that moves.

#include <vector>

#include "engine/vibration/eigenvalues.h"

namespace spoke::vibration {

/// The `count` roots of least magnitude like find_roots() of a pencil of all trees, vectors in its
/// order: the hub, then tree by tree. Of N trees that are alike only three patterns move the hub or
/// feel it: those whose amplitudes are 1, cos(azimuth) and sin(azimuth), for the hub is a rigid
/// body. The others, orthogonal to these, vibrate as one tree does at a hub that is held, with
/// N - 3 roots each (multi-blade coordinates; Coleman and Feingold 1958, NACA report 1351). So a
/// model of many blades costs no more than one of three. `azimuths`: by tree [rad].
std::vector<Root> find_coupled_roots(const steady::LinearModel& model,
                                     const std::vector<double>& azimuths, Eigen::Index count);

/// Parts of a model that together have all of its roots: where trees meet at a hub that moves, the
/// hub with the patterns that it feels, and one tree for the others of each kind, the hub held;
/// else one tree of each kind.
std::vector<steady::LinearModel> take_apart(const steady::LinearModel& model,
                                            const std::vector<double>& azimuths);

}  // namespace spoke::vibration
