#pragma once

// The description of a model in space, as an engineer gives it: a hub with blades, and trees of
// bodies for what is no blade. build_trees() (models/tree/tree.h) makes one kind of tree of
// both. Vectors are of three components; frames are right-handed.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/blade_choice.h"
#include "models/curve.h"
#include "models/drive.h"
#include "models/rotor.h"
#include "spoke/export.h"

/// Models in space, as data. A rotor in the plane is a spoke::Rotor.
namespace spoke::spatial {

/// Three components x, y, z.
using Vector = Eigen::Vector3d;
/// Three by three components: an inertia tensor, or a rotation.
using Tensor = Eigen::Matrix3d;
/// Two components in a cross section, along its y and its z axis.
using Offset = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
/// Six by six components in section axes, in the order (x, y, z, about x, about y, about z).
using SectionMatrix = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// What a beam is made of from root to tip: values at stations, linear between them (the axis: a
/// natural cubic spline). As many of each as there are stations; what is optional may be empty.
///
/// A beam's frame has x along the undeformed beam from the root, for a blade y in the plane of
/// rotation and z along the axis of rotation. Stations are x coordinates. The section axes are the
/// normal of the section, and two axes in the section, y and z: those of the beam turned about +x
/// by `twist`. "Lag" is bending that moves the beam along the section's y, "flap" along its z.
struct Sections {
  std::vector<double> station;  ///< from the root, ascending from 0 to the length [m]

  // The stiffness: either these ...
  std::vector<double> axial_stiffness;    ///< EA [N]
  std::vector<double> flap_stiffness;     ///< EI, int E z^2 dA about the tension centre [N m^2]
  std::vector<double> lag_stiffness;      ///< EI, int E y^2 dA about the tension centre [N m^2]
  std::vector<double> torsion_stiffness;  ///< GJ [N m^2]
  std::vector<double> flap_shear_stiffness{};  ///< GA along z [N]; empty: no shear deformation
  std::vector<double> lag_shear_stiffness{};   ///< GA along y [N]; empty: no shear deformation
  std::vector<Offset> tension_center{};  ///< from the axis, section axes [m]; empty: on the axis
  std::vector<Offset> shear_center{};    ///< likewise
  /// ... or this, which maps strains (stretch, two shears, twist, two curvatures: about y, about z)
  /// to the force and moment of the section about its point of the axis [N, N m, N m^2].
  std::vector<SectionMatrix> stiffness_6x6{};

  // The mass, per length along the axis: either these ...
  std::vector<double> mass_per_length;  ///< [kg/m]
  /// int rho z^2 dA and int rho y^2 dA, about the mass centre [kg m]. Empty: as of sections of one
  /// material, mass_per_length EI/EA.
  std::vector<double> flap_inertia{};
  std::vector<double> lag_inertia{};  ///< likewise
  std::vector<Offset> mass_center{};  ///< from the axis, section axes [m]; empty: on the axis
  /// ... or this, of a slice of unit length about its point of the axis [kg/m, kg, kg m].
  std::vector<SectionMatrix> mass_6x6{};

  // The shape.
  std::vector<double> twist{};    ///< about +x, from the beam's y to the section's [rad]; empty: 0
  std::vector<double> sweep{};    ///< y coordinate of the axis [m]; empty: 0
  std::vector<double> prebend{};  ///< z coordinate of the axis [m]; empty: 0
  std::vector<double> chord{};    ///< along the section's y, to be shown [m]; may be empty
  std::vector<double> thickness{};  ///< along the section's z, to be shown [m]; may be empty

  /// Whether all values are equal.
  friend bool operator==(const Sections&, const Sections&) = default;
};

/// A small body fixed to a cross section of a beam.
struct PointMass {
  double position = 0.0;            ///< station on the beam [m]
  double mass = 0.0;                ///< [kg]
  Vector offset = Vector::Zero();   ///< of its centre from the beam's axis, beam frame [m]
  Tensor inertia = Tensor::Zero();  ///< about its centre, beam axes [kg m^2]; may be zero

  friend bool operator==(const PointMass&, const PointMass&) = default;
};

/// A slender beam, straight or not, cut into flexible bodies.
struct Beam {
  double length = 0.0;  ///< along its x axis [m]
  /// Flexible bodies along the beam; where joints part it, each part has as many as keep bodies as
  /// short as that, and one or more.
  int bodies = 4;
  /// Finite elements per body; more where a body carries many other ones, as these are at nodes.
  int elements = 4;
  Sections sections{};  ///< what it is made of
  /// Of each of its bodies.
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  bool geometric_stiffening = true;       ///< whether rotation stiffens bending within a body
  std::vector<PointMass> point_masses{};  ///< that it carries besides its own mass

  friend bool operator==(const Beam&, const Beam&) = default;
};

/// A rigid body. Its frame is that of the joint that carries it, at joint coordinates of zero.
struct RigidBody {
  double mass = 0.0;                ///< [kg]
  Vector center = Vector::Zero();   ///< of mass, body frame [m]
  Tensor inertia = Tensor::Zero();  ///< about the centre of mass, body axes [kg m^2]
};

/// What a joint lets move.
enum class JointKind {
  fixed,        ///< nothing
  revolute,     ///< rotation about an axis
  universal,    ///< rotation about a first axis, then about a second one that turns with it
  spherical,    ///< rotation
  prismatic,    ///< translation along an axis
  cylindrical,  ///< rotation about an axis, and translation along it, in this order
};

/// How many coordinates a joint of this kind has: 0 to 3.
SPOKE_EXPORT int count_coordinates(JointKind kind);
/// How many axes it has: 0 to 2.
SPOKE_EXPORT int count_axes(JointKind kind);

/// What keeps a coordinate of a joint within bounds, smoothly: with d the distance beyond a bound,
/// the force towards it is stiffness d^2/(2 width) up to d = width, stiffness (d - width/2) beyond;
/// the damper sets in by the same law.
struct Stop {
  double lower = 0.0;      ///< [rad, m]
  double upper = 0.0;      ///< [rad, m]
  double stiffness = 0.0;  ///< [N m/rad, N/m]
  double damping = 0.0;    ///< [N m s/rad, N s/m]
  double width = 0.0;      ///< over which it sets in [rad, m]
};

/// The coordinate follows a curve over time [rad, m]; a curve of one point is a constant.
struct MotionTable {
  Curve value;  ///< over time
};

/// The coordinate is mean + cosine cos(psi) + sine sin(psi), with psi the azimuth: the hub's angle,
/// of a blade's joints the blade's azimuth added. Collective and cyclic pitch.
struct AzimuthMotion {
  double mean = 0.0;    ///< [rad, m]
  double cosine = 0.0;  ///< [rad, m]
  double sine = 0.0;    ///< [rad, m]
};

/// The coordinate follows what the embedding program says while it simulates.
struct ProgramMotion {
  double initial = 0.0;  ///< until it has said something [rad, m]
};

/// A motion that is prescribed.
using Motion = std::variant<MotionTable, AzimuthMotion, ProgramMotion>;

/// One coordinate of a joint: an angle [rad], or a way [m]; of a spherical joint a component, in
/// the child's axes, of the rotation vector from parent to child. It is free, with what acts on it,
/// or its motion is prescribed and nothing else is given.
struct JointCoordinate {
  double stiffness = 0.0;  ///< of a spring [N m/rad, N/m]; of a spherical joint equal in all three
  double damping = 0.0;    ///< [N m s/rad, N s/m]; likewise
  double rest = 0.0;       ///< where the spring is at rest [rad, m]; spherical: 0
  double initial = 0.0;    ///< at t = 0 [rad, m]
  double initial_speed = 0.0;                   ///< at t = 0 [rad/s, m/s]
  Curve effort{};                               ///< torque or force that acts, over time [N m, N]
  std::optional<Stop> stop = std::nullopt;      ///< none of a spherical joint
  std::optional<Motion> motion = std::nullopt;  ///< none of a spherical joint
};

/// What joins a body, the child, to a place of another one, the parent, or to the hub.
///
/// The joint's frame is the parent's frame (of a beam: its axes at the place on the undeformed
/// beam, which move with the section there), moved by `offset` and turned by `orientation`. The
/// child's frame is the joint's where all coordinates are zero.
struct Joint {
  std::string name{};                   ///< of sensors and messages; may be empty
  JointKind kind = JointKind::fixed;    ///< what it lets move
  Vector offset = Vector::Zero();       ///< parent's frame [m]
  Vector orientation = Vector::Zero();  ///< rotation vector, parent's frame [rad]
  /// Those in use are the first count_axes(kind); joint frame, of any length but zero.
  std::array<Vector, 2> axes{Vector::Zero(), Vector::Zero()};
  /// Those in use are the first count_coordinates(kind).
  std::array<JointCoordinate, 3> coordinates{};
};

/// A joint of a blade; what lies outboard of it is its child.
struct BladeJoint {
  double station = 0.0;  ///< distance from the root, less than the length [m]
  Joint joint{};         ///< what moves there
};

/// A blade of the rotor. Blades stand around the hub's axis: with z' along that axis and x', y' the
/// hub's x and y taken along by the smallest rotation of z to z', the blade's frame is x' y' z'
/// turned about z' by the azimuth, then about -y by the precone.
struct Blade {
  Beam beam{};                       ///< what it is made of
  double azimuth = 0.0;              ///< of the undeformed blade in the hub's frame [rad]
  double precone = 0.0;              ///< angle that lifts the tip along the hub's axis [rad]
  std::vector<BladeJoint> joints{};  ///< in order from root to tip
};

/// A body of a subsystem.
struct Body {
  std::string name{};                     ///< unlike that of any other of the subsystem
  std::variant<Beam, RigidBody> shape{};  ///< what it is
};

/// A joint of a subsystem. Every body is the child of one joint.
struct SubsystemJoint {
  std::string parent = "hub";  ///< name of a body, or "hub"
  std::string child{};         ///< name of a body; joined at its root
  /// Where on a parent that is a beam [m]; none: its tip.
  std::optional<double> station = std::nullopt;
  Joint joint{};  ///< what moves there
};

/// Bodies that are no blade: a tree on the hub, by names.
struct Subsystem {
  std::string name{};                    ///< unlike that of any other
  std::vector<Body> bodies{};            ///< one or more
  std::vector<SubsystemJoint> joints{};  ///< as many
};

/// The prescribed motion of what holds the hub's axle: a table of components over time.
struct VectorTable {
  std::array<Curve, 3> components{};  ///< x, y, z [m, rad]
};

/// constant + rate t + amplitude sin(frequency t + phase).
struct VectorHarmonic {
  Vector constant = Vector::Zero();   ///< [m, rad]
  Vector rate = Vector::Zero();       ///< [m/s, rad/s]
  Vector amplitude = Vector::Zero();  ///< [m, rad]
  double frequency = 0.0;             ///< [rad/s]
  double phase = 0.0;                 ///< [rad]
};

/// A vector that is a function of time.
using VectorCourse = std::variant<VectorTable, VectorHarmonic>;

/// How the axle's mount moves: a ship, a helicopter in manoeuvre, a shake table.
struct MountMotion {
  VectorCourse translation{};  ///< of the hub's origin, inertial frame [m]
  VectorCourse rotation{};     ///< rotation vector, inertial frame [rad]
};

/// What blades and subsystems are fixed to. Its frame is the inertial one at t = 0, but for the
/// mount's motion.
struct Hub {
  HubSupport support = HubSupport::axle;  ///< how it is held: turns about an axis, or free in space
  Vector axis = Vector::UnitZ();        ///< of the drive and of the blades, of any length but zero
  double radius = 0.0;                  ///< from the hub's origin to the blades' roots [m]
  double mass = 0.0;                    ///< [kg]; > 0 if free
  Vector center = Vector::Zero();       ///< of mass, hub frame [m]
  Tensor inertia = Tensor::Identity();  ///< about the centre of mass, hub axes [kg m^2]
  Drive drive = FreeDrive{};            ///< what turns it about its axis; a free hub: no motion
  std::optional<MountMotion> mount = std::nullopt;  ///< of an axle; none: at rest
  Vector velocity = Vector::Zero();                 ///< of a free hub at t = 0 [m/s]
  Vector angular_velocity = Vector::Zero();         ///< of a free hub at t = 0 [rad/s]
};

/// Frame in which a load is resolved.
enum class LoadFrame {
  inertial,  ///< keeps its direction in space
  hub,       ///< turns with the hub
  body,      ///< turns with the frame of the body
  section,   ///< follows the loaded cross section of a beam
};

/// Where a load is: on blades, or on a body of a subsystem.
struct LoadPlace {
  BladeChoice blade = BladeChoice::all();  ///< if there is no subsystem
  std::string subsystem{};                 ///< its name; empty: on blades
  std::string body{};                      ///< of the subsystem
};

/// A force and a moment at a point of a beam or of a rigid body, scaled by a function of time.
struct PointLoad {
  LoadPlace place{};  ///< on which it acts
  /// On a beam: distance from its root [m]; none: the tip of each.
  std::optional<double> position = std::nullopt;
  Vector point = Vector::Zero();     ///< on a rigid body: in its frame [m]
  LoadFrame frame = LoadFrame::hub;  ///< in which force and moment are resolved
  Vector force = Vector::Zero();     ///< [N]
  Vector moment = Vector::Zero();    ///< besides that of the force [N m]
  double ramp = 0.0;                 ///< of the smooth rise from 0, calc_rise() [s]; 0: at once
  Curve factor{1.0};                 ///< dimensionless function of time
};

/// A force and a moment per length of a beam, between two stations.
struct DistributedLoad {
  LoadPlace place{};                          ///< on which it acts: beams
  double from = 0.0;                          ///< its inner end, distance from the root [m]
  std::optional<double> to = std::nullopt;    ///< its outer end [m]; none: the tip
  LoadFrame frame = LoadFrame::hub;           ///< in which force and moment are resolved
  Vector force_per_length = Vector::Zero();   ///< [N/m]
  Vector moment_per_length = Vector::Zero();  ///< [N]
  double ramp = 0.0;                          ///< as in PointLoad [s]
  Curve factor{1.0};                          ///< dimensionless function of time
};

/// A force at a point that is fixed to the hub, and a torque: a thruster, a reaction wheel.
struct HubLoad {
  Vector position = Vector::Zero();  ///< of the point in the hub's frame [m]
  LoadFrame frame = LoadFrame::hub;  ///< in which force and torque are resolved: hub or inertial
  Vector force = Vector::Zero();     ///< [N]
  Vector torque = Vector::Zero();    ///< besides that of the force [N m]
  double ramp = 0.0;                 ///< as in PointLoad [s]
  Curve factor{1.0};                 ///< dimensionless function of time
};

/// A hub with what it carries, and what acts on all.
struct Model {
  Hub hub{};                            ///< in the middle
  std::vector<Blade> blades{};          ///< of the rotor
  std::vector<Subsystem> subsystems{};  ///< what is no blade; there is a blade or a subsystem
  Vector gravity = Vector::Zero();      ///< acceleration, inertial frame [m/s^2]
  double gravity_ramp = 0.0;            ///< of its smooth rise from 0, calc_rise() [s]
  Damping damping{};                    ///< of all flexible bodies
  std::vector<PointLoad> loads{};       ///< at points
  std::vector<DistributedLoad> distributed_loads{};  ///< along beams
  std::vector<HubLoad> hub_loads{};                  ///< on the hub
};

/// The names that scenario files use: "fixed", "revolute", ...
SPOKE_EXPORT std::string_view name_of(JointKind kind);
/// "inertial", "hub", "body", "section".
SPOKE_EXPORT std::string_view name_of(LoadFrame frame);

}  // namespace spoke::spatial
