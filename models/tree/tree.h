#pragma once

// Trees of bodies, each joined to one parent: the common form of blades and subsystems.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/spatial_model.h"
#include "models/tree/mass_properties.h"
#include "models/tree/solid_part.h"

namespace spoke::spatial {

/// A part of a beam that is one flexible body. Point masses of the beam belong to the part that
/// holds their station, at a boundary to the inner one. Its frame has the beam's axes and its
/// origin on the undeformed axis at the first node; node k has the same axes and its origin on the
/// axis there.
struct FlexibleBody {
  std::size_t beam = 0;         ///< index of its beam in the tree
  std::vector<double> nodes{};  ///< stations of its nodes on the beam, ascending [m]; 2 or more
};

/// A body of a tree, and the joint that carries it.
struct TreeBody {
  std::string name{};                                        ///< name for people
  std::variant<FlexibleBody, RigidBody, SolidPart> shape{};  ///< part of a beam, rigid, or a solid
  /// Index of the body that carries it; -1: the hub.
  int parent = -1;
  /// Node of a part of a beam, or index of an interface of a solid, that carries it; 0 on other
  /// parents.
  std::size_t parent_node = 0;
  /// The body's frame at joint coordinates of zero: in the parent's frame, or that of its node or
  /// interface.
  Placement placement{};
  Joint joint{};  ///< its axes are in the body's frame; offset and orientation are in `placement`
  /// Number of the rotor whose hub it is: its frame has z along the drive's axis, and its joint is
  /// the axle, which the drive turns; -1: it is no hub.
  int rotor = -1;

  bool is_hub() const { return rotor >= 0; }
  /// Number of the rotor whose drive turns the joint: the axle, or that of a generator; -1: none.
  int driven_by = -1;
  double drive_ratio = 1.0;  ///< turns of the joint for one of the drive
  /// Whether it is the generator of a drive train: a rigid body of no mass, whose inertia is that
  /// about its axis, z.
  bool is_generator() const { return driven_by >= 0 && !is_hub(); }
};

/// A place of a loop in its tree.
struct TreePlace {
  LoopPlace::Carrier carrier = LoopPlace::Carrier::body;
  int body = -1;           ///< index of the body of the tree that carries it, if one does
  std::size_t node = 0;    ///< its node, or interface of a solid
  std::size_t anchor = 0;  ///< index of the anchor that carries it, if one does
  /// The place's frame in that of its body, its node or its interface, of the hub, the mount or the
  /// anchor. In these it stands where the azimuth of the blade has turned it about the hub's axis.
  Placement placement{};
  /// Whether `anchor` moves against the body that carries it: `placement` is then in its frame.
  bool is_moved = false;
};

/// A loop of a tree.
struct TreeLoop {
  Loop loop{};  ///< as it is described; its places are in `from` and `to`
  TreePlace from{}, to{};
};

/// The end on a tree of a loop that is another tree's; on a tree that carries a rotor also the hub
/// through which a loop comes that ends on a tree of that rotor, or on one beyond it.
struct LoopEnd {
  std::size_t tree = 0;    ///< whose loop it is
  std::size_t number = 0;  ///< of its loops, and of its couplings behind these
  std::string owner{};     ///< name of that tree
  Loop loop{};             ///< as it is described
  TreePlace place{};       ///< none of a coupling's joints
  bool is_on_hub = false;  ///< whether it is such a hub
  /// As it is described, if it is of a coupling, not of a loop.
  std::optional<Coupling> coupling = std::nullopt;

  const std::string& name() const { return coupling ? coupling->name : loop.name; }
  /// Whether it is at a place, on which a wrench acts, rather than at joints.
  bool has_place() const { return !coupling || is_on_hub; }
};

/// Bodies on the hub, or of a support on its base; parents stand before their children.
struct Tree {
  std::string name{};  ///< "blade 1", or the name of the subsystem
  std::string key{};   ///< in a scenario: "blades.1", "subsystem.2", "support"
  /// Azimuth of a blade or subsystem, added to the hub's angle for AzimuthMotion [rad].
  double azimuth = 0.0;
  int rotor = 0;                   ///< number of the rotor whose hub carries it; of a support 0
  std::vector<Beam> beams{};       ///< beams whose parts are the flexible bodies
  std::vector<TreeBody> bodies{};  ///< one or more
  std::vector<TreeLoop> loops{};   ///< closures between bodies, and of bodies on what carries them
  std::vector<LoopEnd> ends{};     ///< where loops of other trees end
  std::vector<Coupling> couplings{};  ///< of joints of the bodies, by their names
};

/// Return the index among the trees of a model of the blade, by its number from 1, or the subsystem
/// that a place or a joint elsewhere says. Precondition: there is one.
std::size_t find_tree(const Model& model, int blade, const std::string& subsystem);
std::size_t find_tree(const Model& model, const LoopPlace& place);

/// A loop that ends on a tree that is not its own, by its number among those of its tree.
struct LoopFromElsewhere {
  std::size_t tree = 0, number = 0;
  const Loop* loop = nullptr;
};
/// Returns those that end on a tree, in the order of trees and loops.
std::vector<LoopFromElsewhere> find_loops_from_elsewhere(const Model& model, std::size_t tree);

/// Returns the number of coordinates of a tree: those of its joints, free or prescribed, of its
/// beams' nodes and of its solids.
std::int64_t count_coordinates(const Tree& tree);

/// Makes one tree for each blade, then one for each subsystem. Precondition: check_model() accepts
/// it. The tree of a support is the last. The last bodies of a tree are the hubs of the rotors that
/// it carries, by the names "hub" on the joint "axle", and "tail.hub" on "tail.axle".
///
/// A blade's joints part it, and each part is cut into equally long bodies, none longer than
/// length/bodies; beams of subsystems are cut by the same rule. A body has as many equally long
/// elements as the beam says, unless children or loops within it need nodes: then there is at least
/// one element between two of these, and lengths are as equal as that allows. Where a joint parts a
/// blade, a loop is fixed to the part outboard of it.
std::vector<Tree> build_trees(const Model& model);

/// Returns the frame of the blades in the hub's frame, its z axis along the hub's axis.
Placement rotor_placement(const Hub& hub);

/// Whether a body of a tree is the one that is described by a name, or a part of that beam.
bool is_part_of(const TreeBody& body, const std::string& name);

/// Returns the index of the body of a tree that is the hub of a rotor.
std::size_t find_hub(const Tree& carrier, int rotor);

/// A body by its tree and its index there.
struct BodyAt {
  std::size_t tree = 0, body = 0;
};
/// Returns where the hub of a rotor is among the trees of a model with a support.
BodyAt find_hub(const std::vector<Tree>& trees, int rotor);
/// Returns where the frame of a rotor's hub is in that of the support's base, z along its axis, at
/// joint coordinates of zero.
Placement find_hub_placement(const Model& model, const std::vector<Tree>& trees, int rotor);

/// Returns where each body's frame is in the hub's frame, at joint coordinates of zero.
std::vector<Placement> calc_placements(const Tree& tree);

/// Returns the mass properties of a body in its own frame.
MassProperties calc_mass_properties(const Tree& tree, const TreeBody& body);

/// Returns the mass properties of a tree in the hub's frame, at joint coordinates of zero.
MassProperties calc_mass_properties(const Tree& tree);

/// Returns the mass properties of the hub and all trees in the hub's frame, at joint coordinates of
/// zero.
MassProperties calc_mass_properties(const Hub& hub, const std::vector<Tree>& trees);

}  // namespace spoke::spatial
