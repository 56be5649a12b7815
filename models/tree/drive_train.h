#pragma once

// What a drive train puts into the tree of a support: a generator, and a shaft that couples it to
// the axle.

#include <cstddef>
#include <string>

#include "models/coupling.h"
#include "models/spatial_model.h"
#include "models/tree/tree.h"

namespace spoke::spatial {

/// Returns the generator, which turns about z.
RigidBody make_generator(const DriveTrain& train);
/// Returns the shaft between the axle and the generator, as a coupling of these joints. `prefix`:
/// of the rotor's names.
Coupling make_shaft(const DriveTrain& train, const std::string& prefix);

// A body without mass has no inverse of its own. So the equations give a generator a share of the
// mass of another one, and an inertia across its axis, and that one as much less: together they
// have its mass, and its inertia but for that of the generator about its axis. The giver is the
// carrier where that is rigid, else the hub of the rotor: a mass on the axis, and inertia alike
// about all axes across it, move with the one as with the other, however they turn.

/// Returns a generator of a tree, by its index, with its share. `base`: of the tree.
RigidBody with_share(const Tree& tree, std::size_t generator, const RigidBody& base);
/// Returns a body less the shares that it gives to generators of a tree; `body`: its index there,
/// -1: the base.
RigidBody without_shares(const RigidBody& giver, const Tree& tree, int body);

}  // namespace spoke::spatial
