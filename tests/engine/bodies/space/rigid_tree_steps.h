#pragma once

// Makes steps of a tree of rigid bodies by both methods.

#include "tests/engine/bodies/space/rigid_tree.h"

namespace spoke::space::testing {

/// Takes the accelerations of the state at t = 0 as those to start from; without a method, of rk4.
void start(RigidTree& tree);
void start(const GeneralizedAlpha& method, RigidTree& tree);

/// Makes step `n` (from 1), which ends at n h.
void step(const Rk4& method, int n, RigidTree& tree);

/// Makes the step by iterating until no coordinate changes by more than `tolerance`; returns the
/// number of evaluations.
int step(const GeneralizedAlpha& method, int n, RigidTree& tree, double tolerance = 1e-12);

/// Starts, and steps to time t [s] by steps of about `h`.
void run_rk4(double t, double h, RigidTree& tree);
void run_generalized_alpha(double t, double h, double radius, RigidTree& tree);

}  // namespace spoke::space::testing
