#pragma once

// The description of a model in space, as an engineer gives it: a hub with blades, and subsystems,
// which are other trees of bodies. build_trees() (models/tree/tree.h) makes trees of both. Vectors
// are of three components; frames are right-handed.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/air.h"
#include "models/blade_choice.h"
#include "models/control.h"
#include "models/coupling.h"
#include "models/curve.h"
#include "models/drive.h"
#include "models/drive_train.h"
#include "models/event.h"
#include "models/loop.h"
#include "models/mount_motion.h"
#include "models/rotor.h"
#include "models/solid_body.h"
#include "spoke/export.h"

/// Models in space, as data. A rotor in the plane is a spoke::Rotor.
namespace spoke::spatial {

/// Three by three components: an inertia tensor, or a rotation.
using Tensor = Eigen::Matrix3d;
/// Two components in a cross section, along its y and its z axis.
using Offset = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
/// Six by six components in section axes, in the order (x, y, z, about x, about y, about z).
using SectionMatrix = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// Properties of a beam from root to tip: values at stations, linear between them (the axis: a
/// natural cubic spline). Each array has as many values as there are stations; optional ones may be
/// empty.
///
/// A beam's frame has x along the undeformed beam from the root, for a blade y in the plane of
/// rotation and z along the axis of rotation. Stations are x coordinates. The section axes are the
/// normal of the section, and two axes in the section, y and z: those of the beam turned about +x
/// by `twist`. "Lag" is bending that moves the beam along the section's y, "flap" along its z.
struct Sections {
  std::vector<double> station;  ///< stations from the root, ascending from 0 to the length [m]

  // The stiffness, either by these arrays ...
  std::vector<double> axial_stiffness;    ///< EA [N]
  std::vector<double> flap_stiffness;     ///< EI, int E z^2 dA about the tension centre [N m^2]
  std::vector<double> lag_stiffness;      ///< EI, int E y^2 dA about the tension centre [N m^2]
  std::vector<double> torsion_stiffness;  ///< GJ [N m^2]
  std::vector<double> flap_shear_stiffness{};  ///< GA along z [N]; empty: no shear deformation
  std::vector<double> lag_shear_stiffness{};   ///< GA along y [N]; empty: no shear deformation
  /// Place from the axis, section axes [m]; empty: on the axis.
  std::vector<Offset> tension_center{};
  /// Place from the axis, section axes [m]; empty: on the axis.
  std::vector<Offset> shear_center{};
  /// ... or by this one, which maps strains (stretch, two shears, twist, two curvatures: about y,
  /// about z) to the force and moment of the section about its point of the axis [N, N m, N m^2].
  std::vector<SectionMatrix> stiffness_6x6{};

  // The mass per length along the axis, either by these arrays ...
  std::vector<double> mass_per_length;  ///< [kg/m]
  /// int rho z^2 dA about the mass centre [kg m]. Empty: mass_per_length EI/EA, the value for
  /// sections of one material.
  std::vector<double> flap_inertia{};
  /// int rho y^2 dA about the mass centre [kg m]. Empty: by the rule of flap_inertia.
  std::vector<double> lag_inertia{};
  std::vector<Offset> mass_center{};  ///< place from the axis, section axes [m]; empty: on the axis
  /// ... or by this one, the mass matrix of a slice of unit length about its point of the axis
  /// [kg/m, kg, kg m].
  std::vector<SectionMatrix> mass_6x6{};

  // The shape.
  /// Angle about +x from the beam's y to the section's [rad]; empty: 0.
  std::vector<double> twist{};
  std::vector<double> sweep{};    ///< y coordinate of the axis [m]; empty: 0
  std::vector<double> prebend{};  ///< z coordinate of the axis [m]; empty: 0
  /// Extent along the section's y, for drawings only [m]; may be empty.
  std::vector<double> chord{};
  /// Extent along the section's z, for drawings only [m]; may be empty.
  std::vector<double> thickness{};

  /// Whether all values are equal.
  friend bool operator==(const Sections&, const Sections&) = default;
};

/// A small body fixed to a cross section of a beam.
struct PointMass {
  double position = 0.0;            ///< station on the beam [m]
  double mass = 0.0;                ///< [kg]
  Vector offset = Vector::Zero();   ///< offset of its centre from the beam's axis, beam frame [m]
  Tensor inertia = Tensor::Zero();  ///< inertia about its centre, beam axes [kg m^2]; may be zero

  friend bool operator==(const PointMass&, const PointMass&) = default;
};

using spoke::BeamStrain;

/// A slender beam, straight or not, cut into flexible bodies.
struct Beam {
  double length = 0.0;  ///< length along its x axis [m]
  /// Flexible bodies along the beam. Where joints part it, each part has one or more, as many as
  /// keep each no longer than length/bodies.
  int bodies = 4;
  /// Finite elements per body; more where a body carries many others, since each is at a node.
  int elements = 4;
  Sections sections{};  ///< properties along the beam
  /// Reference frame of each of its bodies.
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  bool geometric_stiffening = true;  ///< whether rotation stiffens bending within a body
  BeamStrain strain = BeamStrain::automatic;
  std::vector<PointMass> point_masses{};  ///< point masses besides its own mass

  friend bool operator==(const Beam&, const Beam&) = default;
};

/// A rigid body. Its frame is that of the joint that carries it, at joint coordinates of zero.
struct RigidBody {
  double mass = 0.0;                ///< [kg]
  Vector center = Vector::Zero();   ///< centre of mass, body frame [m]
  Tensor inertia = Tensor::Zero();  ///< inertia about the centre of mass, body axes [kg m^2]
  /// Angular momentum of what spins inside, relative to the body, body axes [kg m^2/s]: a motor
  /// keeps it. Mass and inertia are those of all.
  Vector spin = Vector::Zero();
};

/// The kind of motion that a joint allows.
enum class JointKind {
  fixed,        ///< no motion
  revolute,     ///< rotation about an axis
  universal,    ///< rotation about a first axis, then about a second one that turns with it
  spherical,    ///< any rotation
  prismatic,    ///< translation along an axis
  cylindrical,  ///< rotation about an axis, and translation along it, in this order
  /// Translation along x, y and z of the joint's frame, then rotation about x, y and z of the frame
  /// that these have reached; directions that are held have a prescribed motion of zero.
  bushing,
};

/// Returns the number of coordinates of a joint of this kind: 0 to 3, of a bushing 6.
SPOKE_EXPORT int count_coordinates(JointKind kind);
/// Returns whether a coordinate of a joint is a displacement; otherwise it is an angle.
SPOKE_EXPORT bool slides(JointKind kind, int coordinate);
/// Returns the number of its axes: 0 to 2.
SPOKE_EXPORT int count_axes(JointKind kind);
/// Names of the directions of a bushing, in the order of its coordinates.
inline constexpr std::array<std::string_view, 6> kBushingDirections{
    "x", "y", "z", "about x", "about y", "about z"};

/// A stop that keeps a coordinate of a joint within bounds, smoothly: with d the distance beyond a
/// bound, the force towards it is stiffness d^2/(2 width) up to d = width, stiffness (d - width/2)
/// beyond; the damper sets in by the same law.
struct Stop {
  double lower = 0.0;      ///< [rad, m]
  double upper = 0.0;      ///< [rad, m]
  double stiffness = 0.0;  ///< [N m/rad, N/m]
  double damping = 0.0;    ///< [N m s/rad, N s/m]
  double width = 0.0;      ///< distance over which it sets in [rad, m]
};

/// Friction of a joint's coordinate with the velocity v: a force against it of F(v) tanh(v/speed),
/// with F(v) = force, or by Stribeck's law force + (static - force) exp(-(v/stribeck)^2).
struct Friction {
  double force = 0.0;  ///< of sliding [N m, N], > 0
  double speed =
      0.0;  ///< over which it sets in, much less than those of interest [rad/s, m/s], > 0
  /// Force at the start of sliding [N m, N], at least `force`; none: `force`.
  std::optional<double> static_force = std::nullopt;
  /// Velocity over which it falls to `force` [rad/s, m/s]; given along with static_force.
  std::optional<double> stribeck = std::nullopt;
};

/// A spring and a damper in series (Maxwell) on a coordinate q: the force -z on it, with z' =
/// stiffness q' - z/time, relaxed at the start.
struct Relaxation {
  double stiffness = 0.0;  ///< of the spring; at once it is this stiff [N m/rad, N/m]
  double time = 0.0;       ///< damper's constant by the spring's [s]
};

/// The coordinate follows a curve over time [rad, m]; a curve of one point is a constant.
struct MotionTable {
  Curve value;  ///< coordinate over time
};

/// The coordinate is mean + cosine cos(psi) + sine sin(psi), with psi the azimuth: the hub's angle
/// plus the azimuth of the blade or subsystem. It describes collective and cyclic pitch.
struct AzimuthMotion {
  double mean = 0.0;    ///< [rad, m]
  double cosine = 0.0;  ///< [rad, m]
  double sine = 0.0;    ///< [rad, m]
};

/// The coordinate follows values that the embedding program sets while it simulates.
struct ProgramMotion {
  double initial = 0.0;  ///< value until the program sets one [rad, m]
};

/// A prescribed motion.
using Motion = std::variant<MotionTable, AzimuthMotion, ProgramMotion>;

/// One coordinate of a joint: an angle [rad], a displacement [m], or for a spherical joint a
/// component, in the child's axes, of the rotation vector from parent to child. It is free, with
/// the springs, dampers and efforts given, or its motion is prescribed and nothing else is given.
struct JointCoordinate {
  double stiffness = 0.0;  ///< spring [N m/rad, N/m]; equal in all three of a spherical joint
  double damping = 0.0;    ///< damper [N m s/rad, N s/m]; equal in all three of a spherical joint
  double rest = 0.0;       ///< coordinate at which the spring is relaxed [rad, m]; spherical: 0
  double initial = 0.0;    ///< coordinate at t = 0 [rad, m]
  double initial_speed = 0.0;  ///< its rate at t = 0 [rad/s, m/s]
  /// Torque or force on the coordinate over time [N m, N].
  Curve effort{};
  std::optional<Stop> stop = std::nullopt;  ///< stop; none for a spherical joint
  /// Friction; none for a spherical joint and a bushing.
  std::optional<Friction> friction = std::nullopt;
  std::optional<Motion> motion = std::nullopt;  ///< prescribed motion; none for a spherical joint
  /// Spring that relaxes; none for a spherical joint.
  std::optional<Relaxation> relaxation = std::nullopt;
  /// Of a bushing, whether it moves without a spring and a damper, which else hold it.
  bool moves_freely = false;
};

/// A joint, which joins a body, the child, to a place on another one, the parent, or on the hub.
///
/// The joint's frame is the parent's frame (on a beam: its axes at the place on the undeformed
/// beam, which move with the section there; on a solid: the axes of its mesh at the point of the
/// interface, which move with it), moved by `offset` and turned by `orientation`. The child's frame
/// is the joint's where all coordinates are zero.
struct Joint {
  std::string name{};                   ///< name in sensors and messages; may be empty
  JointKind kind = JointKind::fixed;    ///< kind of motion that it allows
  Vector offset = Vector::Zero();       ///< offset in the parent's frame [m]
  Vector orientation = Vector::Zero();  ///< rotation vector, parent's frame [rad]
  /// Axes in the joint frame, of any length but zero; the first count_axes(kind) are in use.
  std::array<Vector, 2> axes{Vector::Zero(), Vector::Zero()};
  /// Coordinates: 3, of a bushing 6; the first count_coordinates(kind) are in use.
  std::vector<JointCoordinate> coordinates = std::vector<JointCoordinate>(3);
  /// Whether closing loops at the start leaves its coordinates and their rates as they are given.
  bool hold = false;
};

/// A joint of a blade; the part outboard of it is its child.
struct BladeJoint {
  double station = 0.0;  ///< distance from the root, less than the length [m]
  Joint joint{};         ///< the joint at that station
};

/// A blade of the rotor. Blades stand around the hub's axis: with z' along that axis and x', y' the
/// hub's x and y taken along by the smallest rotation of z to z', the blade's frame is x' y' z'
/// turned about z' by the azimuth, then about -y by the precone.
struct Blade {
  Beam beam{};                       ///< the beam along the blade
  double azimuth = 0.0;              ///< direction of the undeformed blade in the hub's frame [rad]
  double precone = 0.0;              ///< angle that lifts the tip along the hub's axis [rad]
  std::vector<BladeJoint> joints{};  ///< joints in order from root to tip
  std::vector<Loop> loops{};         ///< closed loops, as of subsystems
  std::vector<Coupling> couplings{};  ///< gears and the like between its joints
  /// What air does to it, if there is any (Model::air); none: air does nothing.
  std::optional<BladeAerodynamics> aerodynamics{};
  int rotor = 0;  ///< number of the rotor whose hub carries it, see hub_of()
};

/// A body of a subsystem.
struct Body {
  std::string name{};  ///< name, unlike that of any other body of the subsystem
  std::variant<Beam, RigidBody, SolidBody> shape{};  ///< a beam, a rigid body or a solid
  std::optional<BodyDrag> drag = std::nullopt;       ///< of a beam or a rigid body, in air
};

/// A joint of a subsystem. Every body is the child of one joint.
struct SubsystemJoint {
  std::string parent = "hub";  ///< name of a body, or "hub"
  std::string child{};  ///< name of a body; joined at its root, a solid at its first interface
  /// Station on a parent that is a beam [m]; none: its tip.
  std::optional<double> station = std::nullopt;
  Joint joint{};  ///< the joint at that place
  /// Name of an interface of a parent that is a solid; empty: the only one that does not carry its
  /// frame.
  std::string interface {};
};

/// A subsystem that is no blade: a tree of named bodies on the hub.
struct Subsystem {
  std::string name{};                    ///< name, unlike that of any other subsystem
  std::vector<Body> bodies{};            ///< one or more
  std::vector<SubsystemJoint> joints{};  ///< joints, one for each body
  std::vector<Loop> loops{};             ///< closures of loops that the joints leave open
  std::vector<Coupling> couplings{};     ///< gears and the like between its joints
  /// Angle about the hub's axis by which its joints on the hub and what its loops have on the hub,
  /// the mount and anchors are turned; added to the hub's angle for AzimuthMotion [rad].
  double azimuth = 0.0;
  int rotor = 0;  ///< number of the rotor whose hub carries it, see hub_of(); of a support 0
};

/// Springs and dampers between the mount and the axle, and what stands on them: the short form of a
/// support, see suspend(). Directions are those of the mount's frame, which stands in space where
/// nothing moves it, in the order x, y, z, about x, about y, about z. One whose stiffness and
/// damping both are zero does not move.
struct Suspension {
  std::array<double, 6> stiffness{};  ///< [N/m, N m/rad]
  std::array<double, 6> damping{};    ///< [N s/m, N m s/rad]
  double mass = 0.0;                  ///< mass that stands on the springs beside the rotor [kg]
  Vector center = Vector::Zero();     ///< its centre from the hub's origin, mount's axes [m]
  Tensor inertia = Tensor::Zero();    ///< its inertia about that centre, mount's axes [kg m^2]

  /// Returns whether a direction moves.
  bool moves(std::size_t direction) const {
    return stiffness[direction] > 0.0 || damping[direction] > 0.0;
  }
};

/// What a support stands on.
enum class SupportBase {
  ground,  ///< the inertial frame, or the mount that moves in it
  free,    ///< a fuselage, which is free in space
};

/// A rigid body that is free in space and carries a support.
struct Fuselage {
  double mass = 0.0;                         ///< [kg], > 0
  Vector center = Vector::Zero();            ///< centre of mass, its frame [m]
  Tensor inertia = Tensor::Identity();       ///< inertia about that centre, its axes [kg m^2]
  Vector position = Vector::Zero();          ///< place of its origin at t = 0, inertial frame [m]
  Vector attitude = Vector::Zero();          ///< rotation vector of its frame at t = 0 [rad]
  Vector velocity = Vector::Zero();          ///< of its origin at t = 0, inertial frame [m/s]
  Vector angular_velocity = Vector::Zero();  ///< at t = 0, its axes [rad/s]
};

/// Where the axle of the hub stands: on a support, or on a blade or a subsystem of another rotor.
struct Axle {
  /// Name of the subsystem whose body carries it, one on the hub of a rotor of a lower number, or
  /// of such a blade, "blade 2"; empty: the support. A hub that is but a place there has next to no
  /// inertia, not the default.
  std::string subsystem{};
  /// Name of the body that carries it; empty: what the support stands on, or a blade.
  std::string body{};
  /// Station on a beam [m]; none: its tip.
  std::optional<double> station = std::nullopt;
  /// Name of an interface of a solid; empty: the only one that does not carry its frame.
  std::string interface {};
  /// Place and rotation vector of the hub's frame at angle 0 in the carrier's frame, as of a joint
  /// [m, rad].
  Vector offset = Vector::Zero(), orientation = Vector::Zero();
  /// What is between hub and drive; none: the drive turns the hub. With one on a body that bends
  /// the hub has mass.
  std::optional<DriveTrain> train = std::nullopt;
};

/// The name of the subsystem that is the tree of a support.
inline constexpr std::string_view kSupportName = "support";

/// The name of the generator behind a drive train and of its joint, after prefix_of_rotor().
inline constexpr std::string_view kGeneratorName = "generator";

/// What carries the axle of the hub: from the ground, or from a fuselage, a tree of bodies to the
/// axle. The tree is the last subsystem of the model, and has the name "support"; a joint on its
/// base has the parent base_name(). Where the support is a fuselage alone, that subsystem is empty.
struct Support {
  SupportBase from = SupportBase::ground;  ///< what it stands on
  Fuselage fuselage{};                     ///< the base of one that is free
  Axle axle{};                             ///< where it carries the hub
};

/// Returns the name of what a support stands on, as joints call it: "ground" or "fuselage".
SPOKE_EXPORT std::string_view base_name(SupportBase base);

/// The hub, to which blades and subsystems are fixed. Its frame is the inertial one at t = 0, but
/// for the motions of mount and support.
struct Hub {
  /// Name of its rotor, unlike that of any other; may be empty where there is one rotor.
  std::string name{};
  HubSupport support = HubSupport::axle;  ///< how it is held: an axle, or free in space
  /// Axis of the drive and of the blades, of any length but zero.
  Vector axis = Vector::UnitZ();
  double radius = 0.0;                  ///< distance from the hub's axis to the blades' roots [m]
  double mass = 0.0;                    ///< mass [kg]; > 0 if free
  Vector center = Vector::Zero();       ///< centre of mass, hub frame [m]
  Tensor inertia = Tensor::Identity();  ///< inertia about the centre of mass, hub axes [kg m^2]
  Drive drive = FreeDrive{};            ///< drive about its axis; FreeDrive for a free hub
  std::optional<MountMotion> mount = std::nullopt;  ///< motion of an axle's mount; none: at rest
  Vector velocity = Vector::Zero();                 ///< velocity of a free hub at t = 0 [m/s]
  /// Angular velocity of a free hub at t = 0 [rad/s].
  Vector angular_velocity = Vector::Zero();
};

/// A rotor besides the one of Model::hub: a hub on an axle of its own. Blades, subsystems and loads
/// name it by its number.
struct Rotor {
  Hub hub{};    ///< its name is not empty; it is on an axle, and has no mount
  Axle axle{};  ///< what carries it
};

/// Frame in which a load is resolved.
enum class LoadFrame {
  inertial,  ///< keeps its direction in space
  hub,       ///< turns with the hub
  body,      ///< turns with the frame of the body
  section,   ///< follows the loaded cross section of a beam, or the loaded place of a solid
};

/// The place of a load: on blades, or on a body of a subsystem.
struct LoadPlace {
  BladeChoice blade = BladeChoice::all();  ///< blades on which it acts, if it names no subsystem
  std::string subsystem{};                 ///< name of the subsystem; empty: on blades
  std::string body{};                      ///< name of the body of the subsystem
};

/// A force and a moment at a point of a beam or of a rigid body, or at a place of a solid, scaled
/// by a function of time.
struct PointLoad {
  LoadPlace place{};  ///< place where it acts
  /// Distance from the root of a beam [m]; none: the tip of each beam.
  std::optional<double> position = std::nullopt;
  Vector point = Vector::Zero();     ///< point in the frame of a rigid body [m]
  LoadFrame frame = LoadFrame::hub;  ///< frame in which force and moment are resolved
  Vector force = Vector::Zero();     ///< [N]
  Vector moment = Vector::Zero();    ///< moment besides that of the force [N m]
  /// Duration of the smooth rise from 0, calc_rise() [s]; 0: at once.
  double ramp = 0.0;
  Curve factor{1.0};  ///< dimensionless function of time
  /// Interface of a solid; empty, and no `nodes`: the only one that does not carry its frame.
  std::string interface {};
  /// Nodes of a solid over which the load is spread, by area, in place of an interface.
  std::optional<NodeChoice> nodes = std::nullopt;
  /// Force per area, in place of `force`, on nodes or an interface that have faces [Pa].
  std::optional<Vector> traction = std::nullopt;
  /// Name by which solve_critical() varies it; loads of one name go together. May be empty.
  std::string name{};
};

/// A force and a moment per length of a beam, between two stations.
struct DistributedLoad {
  LoadPlace place{};  ///< beams on which it acts
  double from = 0.0;  ///< distance of its inner end from the root [m]
  /// Distance of its outer end from the root [m]; none: the tip.
  std::optional<double> to = std::nullopt;
  LoadFrame frame = LoadFrame::hub;           ///< frame in which force and moment are resolved
  Vector force_per_length = Vector::Zero();   ///< [N/m]
  Vector moment_per_length = Vector::Zero();  ///< [N]
  double ramp = 0.0;                          ///< duration of the smooth rise, as in PointLoad [s]
  Curve factor{1.0};                          ///< dimensionless function of time
  std::string name{};                         ///< as in PointLoad
};

/// A force at a point that is fixed to the hub, and a torque: a thruster, a reaction wheel.
struct HubLoad {
  Vector position = Vector::Zero();  ///< place of the point in the hub's frame [m]
  /// Frame in which force and torque are resolved: hub or inertial.
  LoadFrame frame = LoadFrame::hub;
  Vector force = Vector::Zero();   ///< [N]
  Vector torque = Vector::Zero();  ///< torque besides that of the force [N m]
  double ramp = 0.0;               ///< duration of the smooth rise, as in PointLoad [s]
  Curve factor{1.0};               ///< dimensionless function of time
  std::string name{};              ///< as in PointLoad
  int rotor = 0;                   ///< number of the rotor on whose hub it acts, see hub_of()
};

/// A hub with the bodies it carries, and the loads on them.
struct Model {
  Hub hub{};                    ///< the hub in the middle
  std::vector<Blade> blades{};  ///< blades of the rotor
  /// Subsystems that are no blades; there is a blade or a subsystem.
  std::vector<Subsystem> subsystems{};
  /// What carries the hub's axle, together with the last subsystem; none: the axle is held in
  /// space, or moved by its mount.
  std::optional<Support> support = std::nullopt;
  std::vector<Rotor> rotors{};      ///< rotors on the support besides that of `hub`
  Vector gravity = Vector::Zero();  ///< gravitational acceleration, inertial frame [m/s^2]
  /// Duration of gravity's smooth rise from 0, calc_rise() [s].
  double gravity_ramp = 0.0;
  Damping damping{};                                         ///< damping of all flexible bodies
  std::vector<PointLoad> loads{};                            ///< loads at points
  std::vector<DistributedLoad> distributed_loads{};          ///< along beams
  std::vector<HubLoad> hub_loads{};                          ///< loads on the hub
  std::vector<Anchor> anchors{};                             ///< places that loops may close on
  std::optional<PitchControl> pitch_control = std::nullopt;  ///< collective pitch; none: no control
  /// A controller that a library or the program gives; not along with pitch_control.
  std::optional<OuterControl> outer_control = std::nullopt;
  std::vector<Event> events{};            ///< that happen once each
  std::optional<Air> air = std::nullopt;  ///< around the blades; none: vacuum
};

/// Returns the number of rotors: 1, or more on a support.
SPOKE_EXPORT int count_rotors(const Model& model);
/// Return the hub of a rotor, and on a support its axle, by its number: 0 is that of Model::hub,
/// others are Model::rotors[number - 1].
SPOKE_EXPORT const Hub& hub_of(const Model& model, int rotor);
/// Returns whether a drive prescribes the rotation of the hub of a rotor: none behind a drive train
/// does.
SPOKE_EXPORT bool is_hub_prescribed(const Model& model, int rotor);
SPOKE_EXPORT const Axle& axle_of(const Model& model, int rotor);
/// Returns what comes before "hub" and "axle" in the names of a rotor's hub and axle: nothing for
/// the first one, "tail." for one by the name "tail".
SPOKE_EXPORT std::string prefix_of_rotor(const Model& model, int rotor);
/// Returns whether a subsystem of a model is the tree of its support.
SPOKE_EXPORT bool is_support(const Model& model, const Subsystem& subsystem);
/// Returns the rotors whose axles a subsystem carries by its name, or a blade by that of its tree,
/// "blade 2", ascending; none of a model without a support.
SPOKE_EXPORT std::vector<int> find_rotors_on(const Model& model, const std::string& subsystem);
/// Returns the key of a subsystem in a scenario, by its index: "subsystem.2", or "support".
SPOKE_EXPORT std::string key_of_subsystem(const Model& model, std::size_t index);
/// Gives a model the support that a suspension is: a rigid body "carrier" on a bushing
/// "suspension". Precondition: it has no support, and some direction moves.
SPOKE_EXPORT void suspend(const Suspension& suspension, Model& model);

/// Returns the name that scenario files use: "fixed", "revolute", ...
SPOKE_EXPORT std::string_view name_of(JointKind kind);
/// Returns "ground" or "free".
SPOKE_EXPORT std::string_view name_of(SupportBase base);
/// Returns "inertial", "hub", "body" or "section".
SPOKE_EXPORT std::string_view name_of(LoadFrame frame);

}  // namespace spoke::spatial
