#pragma once

// Random systems in space, and random states of systems.

#include <random>

#include "engine/step/step_context.h"

namespace spoke::test {

/// Two subsystems of several trees on a hub.
struct RandomSystem {
  HubSupport support = HubSupport::axle;
  bool is_driven = true;  ///< the rotation about the hub's z axis is prescribed
  int bodies = 14;        ///< of each subsystem; from 14 on it has joints of every kind
};

/// Rigid and flexible bodies in both frames, with several children at any nodes, carried by joints
/// of every kind with springs, dampers, stops, motors and prescribed motions.
System<Space> make_random_system(const RandomSystem& kind, std::mt19937& random);

/// Fills coordinates, velocities and accelerations, and what the integrator keeps, as after some
/// steps. Equal systems and equal generators have equal states, whatever the formulation.
void randomize_state(std::mt19937& random, StepData<Space>& data);

}  // namespace spoke::test
