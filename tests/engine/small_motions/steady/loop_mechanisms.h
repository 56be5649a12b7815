#pragma once

// Mechanisms with closed loops in space, as scenarios.

#include <array>
#include <string>

#include "models/scenario.h"
#include "tests/engine/loops/mechanisms.h"

namespace spoke::test {

/// Returns a scenario of one subsystem on a hub that stands still, or turns at the speed asked for.
Scenario make_mechanism(const spatial::Subsystem& subsystem);

spatial::Body make_rigid(const std::string& name, double mass, const spatial::Vector& center,
                         const spatial::Vector& inertia);

spatial::SubsystemJoint make_joint(const std::string& parent, const std::string& child,
                                   spatial::JointKind kind,
                                   const spatial::Vector& offset = {0, 0, 0},
                                   const spatial::Vector& axis = {0, 0, 1});

LoopPlace on_hub(const spatial::Vector& point);

/// A uniform straight beam.
struct UniformBeam {
  double length = 1.0, mass_per_length = 1.0;
  double axial = 1e7, lag = 100.0, flap = 150.0, torsion = 80.0;
  int elements = 4;
  bool stiffening = false;  ///< by the tension of rotation, which is that of the tree of joints
};
spatial::Beam make_beam(const UniformBeam& beam);

/// A four-bar of uniform bars in the plane of x and y: a crank and a rocker on the hub, a coupler
/// between them. A torsion spring holds the crank, gravity acts along -y. The loop is closed
/// between coupler and rocker.
struct FourBar {
  double crank = 0.3, coupler = 0.8, rocker = 0.5, ground = 0.7;  ///< lengths [m]
  std::array<double, 3> masses{0.9, 1.7, 1.1};                    ///< [kg]
  double stiffness = 30.0, rest = 0.9;                            ///< of the spring
  double gravity = 9.81;

  /// Returns the angles of crank, coupler and rocker from the x axis, by that of the crank.
  std::array<double, 3> angles(double crank_angle) const;
  double energy(double crank_angle) const;   ///< potential [J]
  double inertia(double crank_angle) const;  ///< by the rate of the crank [kg m^2]
};
Scenario make_scenario(const FourBar& bars);

}  // namespace spoke::test
