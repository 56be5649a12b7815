#pragma once

// Trees of straight uniform beams with strains of second order, whose motions are known: the
// scenarios of checks in statics, vibration and runs.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/scenario.h"

namespace spoke::test {

/// How a beam is cut: bodies, and elements of each.
struct Cut {
  int bodies, elements;
};
inline constexpr Cut kOneOfEight{1, 8}, kFourOfFour{4, 4};
inline constexpr Cut kCuts[] = {kOneOfEight, kFourOfFour};
/// So far from the exact value one body of eight elements, or four of four, may be: a share of it.
inline double tolerance_of(const Cut& cut) { return cut.bodies == 1 ? 0.02 : 0.003; }

/// A section whose axes are y and z, all its centres on the beam's axis.
struct UniformSection {
  double axial = 1e7;                              ///< EA [N]
  double torsion = 1.0;                            ///< GJ [N m^2]
  double flap = 1.0;                               ///< EI of bending along z [N m^2]
  double lag = 1.0;                                ///< EI of bending along y [N m^2]
  double mass = 1.0;                               ///< [kg/m]
  double flap_inertia = 1e-9, lag_inertia = 1e-9;  ///< [kg m]
};

/// Makes a straight beam with strains of second order.
spatial::Beam make_nonlinear_beam(const UniformSection& section, double length, const Cut& cut);
/// Makes a rigid body about whose centre, its origin, all moments of inertia are equal.
spatial::RigidBody make_ball(double mass, double inertia);

/// A tree of bodies, "s", on a hub that stands unless it is changed.
class BeamTree {
 public:
  BeamTree();

  /// Adds a body at the end of the one before, the first on the hub; returns its joint, which is to
  /// be changed before the next is added.
  spatial::SubsystemJoint& add(const std::string& name,
                               const std::variant<spatial::Beam, spatial::RigidBody>& shape,
                               spatial::JointKind kind = spatial::JointKind::fixed,
                               const spatial::Vector& axis = spatial::Vector::Zero());
  /// Adds a load of the name "push" at the tip of a beam or the origin of a rigid body.
  spatial::PointLoad& push(const std::string& body, spatial::LoadFrame frame,
                           const spatial::Vector& force,
                           const spatial::Vector& moment = spatial::Vector::Zero());
  /// Adds such a load per length.
  spatial::DistributedLoad& push_along(const std::string& body, spatial::LoadFrame frame,
                                       const spatial::Vector& force_per_length);
  /// Closes a loop from the end of a beam, or the origin of a rigid body, to a place on the hub.
  Loop& close(LoopKind kind, const std::string& body, const spatial::Vector& place);
  /// Adds the sensor "s.NAME.x", ...: the displacement, in inertial space, of a beam's section or
  /// of the origin of a rigid body.
  void watch(const std::string& name, const std::string& body,
             std::optional<double> position = std::nullopt);
  /// Sets the step and the duration [s].
  void run_for(double step, double duration);

  spatial::Model& model() { return *scenario.space; }
  spatial::Subsystem& tree() { return model().subsystems.front(); }

  Scenario scenario;
};

/// A motion through these values at these times [s].
spatial::MotionTable move(const std::vector<double>& times, const std::vector<double>& values);

/// Returns the frequencies of the first modes of these names [rad/s].
std::vector<double> find_frequencies(const Scenario& scenario,
                                     const std::vector<std::string>& names);
/// Returns the critical factor of the loads "push", by the lowest six modes; at `from` the beam is
/// stable.
double find_critical_push(const Scenario& scenario, double from, double to);

}  // namespace spoke::test
