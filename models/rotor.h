#pragma once

// The description of a rotor, as an engineer gives it: a hub and its blades. make_system() (see
// system.h) turns it into the constant data that the engine works on.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "models/blade_choice.h"
#include "models/damping.h"
#include "models/drive.h"
#include "models/loop.h"
#include "models/vectors.h"

namespace spoke {

/// The reference conditions of a flexible body: where its floating frame is.
enum class ReferenceFrame {
  clamped,  ///< frame at the inboard node, along its tangent: u_0 = v_0 = psi_0 = 0
  chord,    ///< frame at the inboard node, through the outboard node: u_0 = v_0 = v_E = 0
};

/// How the strains of a beam follow from the displacements of its nodes.
enum class BeamStrain {
  /// nonlinear, but for what linear strains are made for, which take less time: in the plane blades
  /// without loops, in space beams on a hub that its drive turns, in a tree without moving joints
  /// and loops, with their centres at the axis (docs/formulation.md, section 16).
  automatic,
  /// Linear; what rotation, gravity and loads add by tension is that of the undeformed tree
  /// (geometric_stiffening).
  linear,
  /// To second order, whatever loads the beam: tension, bending moments and torque act on its
  /// deformed shape.
  nonlinear,
};

/// Properties of a blade from root to tip: values at stations, linear between them. Each array has
/// as many values as there are stations.
struct BladeSections {
  /// Distances from the root, ascending from 0 to the length [m].
  std::vector<double> station;
  std::vector<double> mass_per_length;    ///< rhoA [kg/m]
  std::vector<double> axial_stiffness;    ///< EA [N]
  std::vector<double> bending_stiffness;  ///< EI in the plane [N m^2]

  /// Whether all values are equal.
  friend bool operator==(const BladeSections&, const BladeSections&) = default;
};

/// A small mass on the axis of a blade.
struct PointMass {
  double position = 0.0;  ///< distance from the blade's root [m]
  double mass = 0.0;      ///< [kg]
  double inertia = 0.0;   ///< moment of inertia about its centre, in the plane [kg m^2]

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
  BeamStrain strain = BeamStrain::automatic;
  /// Reference frame of each of its bodies.
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  double azimuth = 0.0;  ///< direction of the undeformed blade in the hub frame [rad]
  /// Sections of a blade that is not uniform; density, area, second_moment and youngs_modulus are
  /// then 0.
  BladeSections sections{};
  std::vector<PointMass> point_masses{};  ///< point masses besides its own mass
  /// Closed loops. Their vectors lie in the plane: the third component of a point or axis is 0, and
  /// rotations are about z.
  std::vector<Loop> loops{};
};

/// The support of the hub.
enum class HubSupport {
  axle,  ///< rotates about a fixed point
  free,  ///< moves in the plane
};

/// The hub, to which the blades are fixed.
struct Hub {
  HubSupport support = HubSupport::axle;  ///< how it is held
  double radius = 0.0;                    ///< distance from the hub's axis to the blade roots [m]
  double mass = 0.0;                      ///< mass [kg]; > 0 for a free hub
  double inertia = 1.0;                   ///< moment of inertia about the hub's axis [kg m^2]
  Drive drive{};                          ///< drive of the hub; SpinUp unless set
};

/// Frame in which a load's force is resolved.
enum class LoadFrame {
  inertial,  ///< keeps its direction in space
  hub,       ///< turns with the hub
  section,   ///< follows the loaded cross section
};

/// A force and a moment at a point of a blade, scaled by a function of time.
struct PointLoad {
  BladeChoice blade = BladeChoice::all();  ///< blades on which it acts
  /// Distance from the blade's root [m], anywhere on the blade; none: the tip of each blade loaded.
  std::optional<double> position = std::nullopt;
  LoadFrame frame = LoadFrame::hub;  ///< frame in which the force is resolved
  Position force{0.0, 0.0};          ///< [N]
  double moment = 0.0;               ///< moment about z [N m]
  /// Duration of the smooth rise from 0, calc_rise() [s]; 0: at once.
  double ramp = 0.0;
  Curve factor{1.0};  ///< dimensionless function of time
  /// Name by which solve_critical() varies it; loads of one name go together. May be empty.
  std::string name{};
};

/// A force and a moment per length of a blade, between two stations, scaled by a function of time.
struct DistributedLoad {
  BladeChoice blade = BladeChoice::all();  ///< blades on which it acts
  double from = 0.0;                       ///< distance of its inner end from the root [m]
  /// Distance of its outer end from the root [m]; none: the tip.
  std::optional<double> to = std::nullopt;
  LoadFrame frame = LoadFrame::hub;     ///< frame in which the force is resolved
  Position force_per_length{0.0, 0.0};  ///< [N/m]
  double moment_per_length = 0.0;       ///< moment about z per length [N]
  double ramp = 0.0;                    ///< duration of the smooth rise, as in PointLoad [s]
  Curve factor{1.0};                    ///< dimensionless function of time
  std::string name{};                   ///< as in PointLoad
};

/// The frame relative to which drag takes velocities.
enum class DragFrame {
  inertial,  ///< air at rest
  hub,       ///< air that turns and moves with the hub
};

/// Drag at a point of a blade, and per length between two stations: with u the velocity of a
/// section relative to the frame, the force is -(linear + quadratic |u|) u, on the blade alone. It
/// has no moment.
struct Drag {
  BladeChoice blade = BladeChoice::all();  ///< blades on which it acts
  DragFrame relative_to = DragFrame::inertial;
  /// Distance of the point from the root [m]; none: the tip of each blade loaded.
  std::optional<double> position = std::nullopt;
  double linear = 0.0;     ///< linear coefficient at the point [N s/m]
  double quadratic = 0.0;  ///< quadratic coefficient at the point [N s^2/m^2]
  /// Distance of the inner end of the part per length from the root [m].
  double from = 0.0;
  /// Distance of its outer end from the root [m]; none: the tip.
  std::optional<double> to = std::nullopt;
  double linear_per_length = 0.0;     ///< [N s/m^2]
  double quadratic_per_length = 0.0;  ///< [N s^2/m^3]
  double ramp = 0.0;                  ///< duration of the smooth rise, as in PointLoad [s]
  Curve factor{1.0};                  ///< dimensionless function of time
  std::string name{};                 ///< as in PointLoad
};

/// A force at a point that is fixed to the hub, and a torque, scaled by a function of time.
struct HubLoad {
  Position position{0.0, 0.0};       ///< place of the point in the hub's frame [m]
  LoadFrame frame = LoadFrame::hub;  ///< frame in which the force is resolved: hub or inertial
  Position force{0.0, 0.0};          ///< [N]
  double torque = 0.0;               ///< torque about z, besides that of the force [N m]
  double ramp = 0.0;                 ///< duration of the smooth rise, as in PointLoad [s]
  Curve factor{1.0};                 ///< dimensionless function of time
  std::string name{};                ///< as in PointLoad
};

/// A hub with its blades, and the loads on them.
struct Rotor {
  Hub hub;                     ///< the hub in the middle
  std::vector<Blade> blades;   ///< one or more
  Position gravity{0.0, 0.0};  ///< gravitational acceleration, inertial frame [m/s^2]
  /// Duration of gravity's smooth rise from 0, calc_rise() [s]; 0: at once.
  double gravity_ramp = 0.0;
  Damping damping;  ///< damping of all bodies
  // Loads given as data; spoke::Load is for functions.
  std::vector<PointLoad> loads;                    ///< loads at points of blades
  std::vector<DistributedLoad> distributed_loads;  ///< along blades
  std::vector<Drag> drags;                         ///< drag against the motion of blades
  std::vector<HubLoad> hub_loads;                  ///< loads on the hub
  std::vector<Anchor> anchors;                     ///< places that loops may close on
};

}  // namespace spoke
