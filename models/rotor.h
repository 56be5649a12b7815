#pragma once

// The description of a rotor, as an engineer gives it: a hub and its blades. make_system() (see
// system.h) turns it into the constant data that the engine works on.

#include <optional>
#include <string>
#include <vector>

#include "models/drive.h"
#include "models/vectors.h"

namespace spoke {

/// Where a flexible body's floating frame sits (its reference conditions).
enum class ReferenceFrame {
  clamped,  ///< at the inboard node, along its tangent: u_0 = v_0 = psi_0 = 0
  chord,    ///< at the inboard node, through the outboard node: u_0 = v_0 = v_E = 0
};

/// What a blade is made of from root to tip: values at stations, linear between them. As many of
/// each as there are stations.
struct BladeSections {
  std::vector<double> station;            ///< from the root, ascending from 0 to the length [m]
  std::vector<double> mass_per_length;    ///< rhoA [kg/m]
  std::vector<double> axial_stiffness;    ///< EA [N]
  std::vector<double> bending_stiffness;  ///< EI in the plane [N m^2]

  /// Whether all values are equal.
  friend bool operator==(const BladeSections&, const BladeSections&) = default;
};

/// A small mass on the axis of a blade.
struct PointMass {
  double position = 0.0;  ///< from the blade's root [m]
  double mass = 0.0;      ///< [kg]
  double inertia = 0.0;   ///< about its centre, for rotation in the plane [kg m^2]

  /// Whether all values are equal.
  friend bool operator==(const PointMass&, const PointMass&) = default;
};

/// A slender straight blade, cut into equal flexible bodies of equal Euler-Bernoulli elements.
struct Blade {
  double length = 0.0;          ///< [m]
  int bodies = 4;               ///< flexible bodies along the blade
  int elements = 4;             ///< finite elements per body
  double density = 0.0;         ///< [kg/m^3]
  double area = 0.0;            ///< cross section [m^2]
  double second_moment = 0.0;   ///< second moment of area for bending in the plane [m^4]
  double youngs_modulus = 0.0;  ///< [Pa]
  /// Whether rotation stiffens the bending within a body.
  bool geometric_stiffening = true;
  /// Of each of its bodies.
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  double azimuth = 0.0;  ///< direction of the undeformed blade in the hub frame [rad]
  /// If the blade is not uniform; density, area, second_moment and youngs_modulus are then 0.
  BladeSections sections{};
  std::vector<PointMass> point_masses{};  ///< that it carries besides its own mass
};

/// How the hub is held.
enum class HubSupport {
  axle,  ///< rotates about a fixed point
  free,  ///< moves in the plane
};

/// What the blades are fixed to.
struct Hub {
  HubSupport support = HubSupport::axle;  ///< how it is held
  double radius = 0.0;                    ///< from the hub's axis to the blade roots [m]
  double mass = 0.0;                      ///< [kg]; > 0 for a free hub
  double inertia = 1.0;                   ///< about the hub's axis [kg m^2]
  Drive drive{};                          ///< what turns it; SpinUp unless set
};

/// Damping D = mass_factor Mff + stiffness_factor K of the deformation coordinates (Rayleigh).
struct Damping {
  double mass_factor = 0.0;       ///< [1/s]
  double stiffness_factor = 0.0;  ///< [s]
};

/// Frame in which a load's force is resolved.
enum class LoadFrame {
  inertial,  ///< keeps its direction in space
  hub,       ///< turns with the hub
  section,   ///< follows the loaded cross section
};

/// A point force and moment on a node of a blade, scaled by a function of time.
struct PointLoad {
  int blade = -1;  ///< index from 0; -1: every blade
  double position =
      0.0;  ///< distance of the node from the blade root [m]; the nearest node is taken
  LoadFrame frame = LoadFrame::hub;  ///< in which the force is resolved
  Position force{0.0, 0.0};          ///< [N]
  double moment = 0.0;               ///< about z [N m]
  Curve factor{1.0};                 ///< dimensionless function of time
};

/// A hub with its blades, and what acts on them.
struct Rotor {
  Hub hub;                       ///< in the middle
  std::vector<Blade> blades;     ///< one or more
  Position gravity{0.0, 0.0};    ///< acceleration, inertial frame [m/s^2]
  Damping damping;               ///< of all bodies
  std::vector<PointLoad> loads;  ///< given as data; spoke::Load is for functions
};

}  // namespace spoke
