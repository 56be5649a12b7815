#pragma once

// Rotors and states that several tests use.

#include <random>

#include "engine/step/step_context.h"
#include "models/scenario.h"

namespace spoke::test {

/// Makes the blade of Wu & Haug 1988 and of the paper, 8 m long.
Blade wu_haug_blade(int bodies = 4, int elements = 4);

/// Makes a rotor of `count` equal blades, evenly spaced.
Rotor make_rotor(const Blade& blade, int count);

/// Makes the 20 s spin-up to 4 rad/s of three such blades.
Scenario spin_up_scenario(const Blade& blade, double step);

/// Makes a spin-up of 200 steps whose blades need different numbers of iterations, under gravity.
Scenario unequal_scenario(HubSupport support, IntegrationMethod method);

/// A rotor with blades of random sizes, materials, reference frames, stiffening and strains.
struct RandomRotor {
  int elements = 4;
  HubSupport support = HubSupport::axle;
  bool is_driven = true;  ///< the rotation is prescribed
};
Rotor make_random_rotor(const RandomRotor& kind, std::mt19937& random);

/// Adds a load of every kind to a rotor, on blades longer than 1 m, and lets gravity rise. The
/// drive stays.
void add_all_loads(Rotor& rotor);

/// Fills coordinates and velocities with a random smooth bend of every body and a random hub
/// motion.
void randomize_state(std::mt19937& random, SystemContext<Plane>& context);

/// Sets all progress to one pass with `control`.
void start_progress(const PassControl& control, StepData<Plane>& data);

/// All accelerations of a pass that only evaluates, hub, then bodies; and all joint wrenches from
/// root to tip.
struct Evaluation {
  Eigen::VectorXd accelerations;
  Eigen::VectorXd wrenches;
  Twist hub_reaction;
};
/// Builds the step graph of `context` and evaluates its state at time t [s], serially; `implicit`:
/// with the constant block of an implicit step.
Evaluation evaluate(double t, SystemContext<Plane>& context, bool implicit = false);

/// Makes a context for a rotor, undeformed. It is filled in place, since its address must not
/// change.
void make_context(const Rotor& rotor, Formulation formulation, const Method& method,
                  SystemContext<Plane>& context);

/// Copies coordinates and velocities of one context to another of the same system.
void copy_state(const SystemContext<Plane>& from, SystemContext<Plane>& to);

/// Returns the deformation coordinates of a body without padding, axial before bending.
Eigen::VectorXd unpadded(const double* flex, const plane::FlexLayout& layout);

}  // namespace spoke::test
