#pragma once

// The constants of closed loops, for plane and space: places in the frames that carry them, and one
// row for each direction that a closure locks (docs/formulation.md, section 12). A loop of the
// plane is one in space whose rows lie in the plane.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/loop.h"
#include "models/space/space.h"
#include "models/system/bearing_model.h"

namespace spoke {

/// A place of a loop. Its frame is that of its handle, of H, of the frame A in which the axle
/// turns, or of an anchor, moved and turned by a constant offset. (A handle's frame turns with its
/// section.) One elsewhere is where the end of the loop is, see SharedLoop.
struct LoopPlaceModel {
  LoopPlace::Carrier carrier = LoopPlace::Carrier::body;
  int body = -1;    ///< of the subsystem, if one carries it
  int handle = 0;   ///< its handle
  int anchor = -1;  ///< index of the anchor, if one carries it
  space::Pose offset;
  /// Of a place of a body that an anchor moves: from the handle to the frame in which that does.
  space::Pose base;

  /// Whether an anchor moves it against the body that carries both.
  bool is_moved() const { return carrier == LoopPlace::Carrier::body && anchor >= 0; }
};

/// The opening of a closure along one direction that it locks. With r the place of `from` and R its
/// orientation, as `to` sees them:
struct LoopRow {
  enum class Kind {
    displacement,  ///< axis . r
    alignment,     ///< axis . R other - rest: directions of `to` and `from` that stay at one angle
    rotation,      ///< axis . log R
    distance,      ///< |r| - rest
    coupling,      ///< of a coupling of joints: sum c q - rest
  };

  Kind kind = Kind::displacement;
  space::Position axis = space::Position::Zero();   ///< unit vector in the frame of `to`
  space::Position other = space::Position::Zero();  ///< unit vector in the frame of `from`
  double rest = 0.0;                                ///< [-, m]
  double stiffness = 0.0;                           ///< 0: rigid [N/m, N m/rad]
  double damping = 0.0;                             ///< [N s/m, N m s/rad]
  bool is_of_bearing = false;  ///< the matrices of LoopModel::bearing give it its force

  bool is_rigid() const { return stiffness == 0.0 && !is_of_bearing; }
  /// Whether it is a length; else an angle.
  bool is_length() const { return kind == Kind::displacement || kind == Kind::distance; }
};

/// A coordinate of a joint in a coupling.
struct CoupledCoordinate {
  int body = 0;            ///< of the subsystem: the one that the joint carries
  int component = 0;       ///< index of the coordinate, or of the driven component
  bool is_driven = false;  ///< whether it is driven
  bool slides = false;     ///< whether it is a length; else an angle
  double ratio = 0.0;      ///< c
};

/// A closed loop of a subsystem, or a coupling of its joints: a row of efforts c on coordinates.
struct LoopModel {
  std::string name;
  std::string owner;  ///< "blade 1", or the name of the subsystem
  std::string key;    ///< its key in a scenario, "subsystem.2.loop.1"
  LoopKind kind = LoopKind::spherical;
  LoopPlaceModel from, to;
  bool turns_to_start = false;     ///< the frame of `from` is the one of `to` at the start
  bool measures_at_start = false;  ///< the distance is that at the start
  std::vector<LoopRow> rows;
  std::optional<BearingModel> bearing;  ///< the matrices of its two rows, if it has some
  /// Coordinates of a coupling, which has one row and no places: `from` is of the first one's body,
  /// with no force on it; empty: it is a loop.
  std::vector<CoupledCoordinate> coupled;
  /// Index in System::shared_loops if the loop spans several subsystems; -1: it does not.
  int shared = -1;
  /// Whether it is but a share of such a loop, that of a subsystem whose loop it is not: `from` is
  /// its place there, or `coupled` its joints, and `to` is elsewhere.
  bool is_share = false;

  bool is_shared() const { return shared >= 0; }
  bool is_coupling() const { return !coupled.empty(); }
  /// Returns "loop" or "coupling".
  const char* word() const { return is_coupling() ? "coupling" : "loop"; }
  /// Returns the opening of a row that counts as one radian; `length`: of the model [m].
  double unit_of(const LoopRow& row, double length) const;
};

/// A loop of a subsystem.
struct LoopAt {
  int subsystem = -1;
  int loop = 0;
};

/// A loop between bodies of different subsystems, or a coupling of their joints. Each that it
/// visits has a share of it among its loops; what closes it is found where all meet, at the base of
/// the system (docs/formulation.md, section 12).
struct SharedLoop {
  LoopAt own;  ///< the loop itself, whose place `from` is of its subsystem
  /// Of a loop the share of the subsystem of its place `to`, which it has as `from`; of a coupling
  /// one for each subsystem of its joints besides its own.
  std::vector<LoopAt> ends;
  /// A share of the support, on the hub of a rotor from whose subsystems the loop comes.
  struct OnHub : LoopAt {
    int rotor = 0;
  };
  std::vector<OnHub> on_hubs;  ///< one for each of these rotors
};

/// The motion that the embedding program has set for an anchor, from a time on: value + rate s +
/// acceleration s^2/2, s = t - since, of translation and rotation vector.
struct SaidAnchorMotion {
  double since = 0.0;                                ///< [s]
  space::Twist value = space::Twist::Zero();         ///< [m, rad]
  space::Twist rate = space::Twist::Zero();          ///< [m/s, rad/s]
  space::Twist acceleration = space::Twist::Zero();  ///< [m/s^2, rad/s^2]
};

/// An anchor. Its vectors, as described, are turned to the axes of H.
struct AnchorModel {
  std::string name;
  Anchor::Frame frame = Anchor::Frame::mount;
  bool turns_with_hub = false;
  std::variant<spatial::MountMotion, SaidAnchorMotion> motion;
  space::Rotation to_axis;  ///< from the frame of the description to H
  int rotor = 0;            ///< see Anchor
};

/// Makes the rows of a closure; in the plane those that lie in it.
std::vector<LoopRow> make_loop_rows(const Loop& loop, bool in_plane);
/// Makes the constants of a loop besides its places.
LoopModel make_loop(const Loop& loop, bool in_plane);
AnchorModel make_anchor(const Anchor& anchor, const space::Rotation& to_axis);

}  // namespace spoke
