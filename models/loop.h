#pragma once

// Closed loops: cut joints that close what the tree of joints leaves open, and the anchors that
// loops may close on.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/mount_motion.h"
#include "spoke/export.h"

namespace spoke {

/// The kind of a closure: the relative motion that it leaves to its two places.
enum class LoopKind {
  fixed,        ///< none
  revolute,     ///< rotation about an axis
  prismatic,    ///< translation along an axis
  universal,    ///< rotation about an axis of `to` and one of `from`, which stay at one angle
  spherical,    ///< any rotation
  cylindrical,  ///< rotation about an axis, and translation along it
  bearing,      ///< any rotation, and translation along an axis
  distance,     ///< all but a change of the distance: a rod with a ball joint at each end
};

/// Returns the number of directions that a closure locks in space: 1 to 6. In the plane `fixed`
/// locks 3, `revolute` and `prismatic` 2, `distance` 1; there are no others.
SPOKE_EXPORT int count_locked(LoopKind kind);
SPOKE_EXPORT int count_locked_in_plane(LoopKind kind);
/// Returns the number of its axes in space: 0 to 2. In the plane a prismatic one has an axis, and
/// the others have none.
SPOKE_EXPORT int count_axes(LoopKind kind);
/// Returns the name that scenario files use: "fixed", "revolute", ...
SPOKE_EXPORT std::string_view name_of(LoopKind kind);

/// A place that a loop is fixed to: a frame on a body of its blade or subsystem, on the hub, on the
/// mount that holds the hub's axle, on an anchor, or on a body of another blade or subsystem. A
/// place of a loop on hub, mount or anchor is given as a blade or subsystem at the azimuth 0 has
/// it, and turned by its azimuth about the hub's axis.
struct LoopPlace {
  /// What carries the place; `hub` is, of a loop of a support, what the support stands on.
  /// `elsewhere`: a body of the blade or subsystem that `blade` or `subsystem` says; in space, only
  /// of `to`.
  enum class Carrier { body, hub, mount, anchor, elsewhere };

  Carrier carrier = Carrier::body;
  /// Name of a body of the subsystem, or of an anchor; empty: the blade, hub or mount.
  std::string name{};
  /// Station on a beam [m]; none: its tip. In the plane one of the ends of the blade's bodies.
  std::optional<double> station = std::nullopt;
  /// Place in the frame of a rigid body, the hub, the mount or the anchor; of a beam, from its axis
  /// at the station, in the beam's axes, which turn with the section; of a solid, from the point of
  /// the interface, in the axes of the mesh, which turn with it [m].
  spatial::Vector point = spatial::Vector::Zero();
  /// Rotation vector of the place's frame against that of its carrier [rad]. None: of `to`, no
  /// rotation; of `from`, the one by which the two frames coincide at the start.
  std::optional<spatial::Vector> orientation = std::nullopt;
  /// Interface of a solid, by its name; empty: the only one that does not carry its frame.
  std::string interface {};
  /// Elsewhere, one of these: the number of the blade, from 1; the name of the subsystem.
  int blade = 0;
  std::string subsystem{};
  /// Of a place on a body, or elsewhere: index of the anchor that moves against that place and
  /// carries this one, whose `point` and `orientation` are in the anchor's frame; -1: none. It is
  /// not given, but found of anchors on bodies when trees are built.
  int moved_by = -1;
};

/// Springs and dampers of a bearing as matrices over the two directions across its axis, which need
/// be neither symmetric nor definite: the force on `from` is -(stiffness) u - (damping) u', with u
/// its displacement, as `to` sees it. Of an axis z in the frame of `to` these directions are x and
/// y; in general the first is nearest to the axis of the frame that is the most across, and the
/// second follows it about the axis.
struct BearingMatrices {
  /// Speeds of tables, ascending: of `from` against `to` about the axis. Matrices are linear
  /// between them, and stay beyond the first and the last one. Empty: they are constant [rad/s].
  std::vector<double> speed{};
  std::vector<Eigen::Matrix2d> stiffness{};  ///< by speed, or one; empty: 0 [N/m]
  std::vector<Eigen::Matrix2d> damping{};    ///< likewise [N s/m]
};

/// A closed loop: a cut joint between two places. Its forces act on `from`, and against `to`.
///
/// The closure is at zero where both places coincide, and so do their frames, but for the motion
/// that its kind allows. At the start joints are moved until it is.
struct Loop {
  std::string name{};  ///< name, unlike that of any other loop of the blade or subsystem
  LoopKind kind = LoopKind::spherical;  ///< relative motion that is allowed
  LoopPlace from{};                     ///< one place, on a body
  LoopPlace to{};                       ///< the other one
  /// Axes in the frame of `to`, of any length but zero, as they are at the start; the first
  /// count_axes(kind) are in use. The second one of a universal closure is fixed to `from`.
  std::array<spatial::Vector, 2> axes{spatial::Vector::Zero(), spatial::Vector::Zero()};
  /// Distance of the places, of that kind [m]; none: the one at the start.
  std::optional<double> length = std::nullopt;
  /// Springs against opening, by locked direction: places along x, y, z or across the axis, then
  /// rotations likewise [N/m, N m/rad]. Empty, or 0: rigid.
  std::vector<double> stiffness{};
  /// Dampers beside the springs [N s/m, N m s/rad]; empty: none. Rigid directions have none.
  std::vector<double> damping{};
  /// Of a bearing, in place of these two; with them it is not rigid.
  std::optional<BearingMatrices> matrices = std::nullopt;
};

/// The motion of an anchor that the embedding program sets while it simulates.
struct ProgramAnchorMotion {
  spatial::Vector translation = spatial::Vector::Zero();  ///< until the program sets one [m]
  spatial::Vector rotation = spatial::Vector::Zero();     ///< rotation vector, likewise [rad]
};

/// A frame whose motion is prescribed, for loops to close on: a swashplate. What moves it takes up
/// its forces, and rests on the hub or the mount.
struct Anchor {
  /// The frame in which it moves: the hub's; that of the mount, in which the hub turns about its
  /// axle; or, of a hub on a support, the one in which it turns there: the hub's frame at angle 0,
  /// which moves with the body that carries the axle. What it takes up rests on that body. In
  /// space also that of a body: of a rigid one its own, of a beam that of the section at a station,
  /// of a solid that of an interface.
  enum class Frame { hub, mount, axle, body };

  std::string name{};          ///< name, unlike that of any other anchor
  Frame frame = Frame::mount;  ///< frame in which its motion is given
  /// Whether it turns with the hub, by the same angle about the hub's axis in its own frame; not of
  /// the frame `hub`. Its rotation tilts it as it stands: a swashplate, whose tilt does not
  /// turn.
  bool turns_with_hub = false;
  /// Motion of its frame.
  std::variant<spatial::MountMotion, ProgramAnchorMotion> motion{};
  /// Number of the rotor whose hub or axle it is beside, see spatial::hub_of(); of the frames
  /// `mount` and `body` 0.
  int rotor = 0;
  // Of the frame `body`.
  std::string subsystem{};                       ///< whose body it is; empty: the support's
  std::string body{};                            ///< name of the body
  std::optional<double> station = std::nullopt;  ///< on a beam [m]; none: its tip
  /// Interface of a solid; empty: the only one that does not carry its frame.
  std::string interface {};
};

/// Returns "hub", "mount", "axle" or "body".
SPOKE_EXPORT std::string_view name_of(Anchor::Frame frame);

}  // namespace spoke
