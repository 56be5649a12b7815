#pragma once

// What a drive train puts into the tree of a support: a generator, and a shaft that couples it to
// the axle.

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

// A body without mass has no inverse of its own. So the equations give a generator a share of its
// carrier's mass, and an inertia across its axis, and the carrier as much less: together they have
// the mass of the carrier, and its inertia but for that of the generator about its axis.

/// Returns a generator with its share. `carrier`: as the model has it.
RigidBody with_share(const TreeBody& generator, const RigidBody& carrier);
/// Returns a carrier less the shares of the generators that a tree has on it; `body`: its index
/// there, -1: the base.
RigidBody without_shares(const RigidBody& carrier, const Tree& tree, int body);

}  // namespace spoke::spatial
