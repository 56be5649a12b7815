#pragma once

// Mechanisms with closed loops that tests run, and random trees cut and closed again.

#include <random>
#include <string>

#include "models/spatial_model.h"

namespace spoke::test {

/// A rod along x from its frame's origin: its mass and moments of inertia about its middle.
spatial::Body make_rod(const std::string& name, double mass, double length);

/// A joint on the hub or a body, at `offset`.
spatial::SubsystemJoint make_hinge(const std::string& parent, const std::string& child,
                                   const spatial::Vector& offset, double angle, double speed = 0.0,
                                   const spatial::Vector& axis = spatial::Vector::UnitZ());

/// A place on a rigid body.
LoopPlace on_body(const std::string& body, const spatial::Vector& point = {0, 0, 0});

/// The N-four-bar of the IFToMM benchmarks: N + 1 upright bars on a fixed hub and N couplers, all
/// of 1 m and 1 kg; the first coupler's end moves at 1 m/s along x. Closed by N loops.
spatial::Model make_four_bars(int count, LoopKind kind = LoopKind::revolute);

/// Andrews' squeezer: seven bodies in the plane z = 0, driven by a torque, with a spring.
/// Bodies K1, K2, K3, K5, K4, K7, K6, in this order; angles beta, Theta, gamma, delta, phi,
/// epsilon, Omega.
spatial::Model make_andrews_squeezer();

/// Bricard's mechanism: five bars of 1 m and 1 kg on six hinges.
spatial::Model make_bricard();

/// Returns the tree with some joints given more freedoms, which loops of the joints' own kinds then
/// lock. The motion is that of the tree.
spatial::Model cut(spatial::Model tree, std::mt19937& random);

}  // namespace spoke::test
