#pragma once

// What blades and subsystems reduce to: bodies, each joined to one parent.

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "models/spatial_model.h"
#include "models/tree/mass_properties.h"

namespace spoke::spatial {

/// A part of a beam that is one flexible body. Point masses of the beam belong to the part that
/// holds their station, at a boundary to the inner one. Its frame has the beam's axes and its
/// origin on the undeformed axis at the first node; node k has the same axes and its origin on the
/// axis there.
struct FlexibleBody {
  std::size_t beam = 0;         ///< which beam of the tree it is of
  std::vector<double> nodes{};  ///< stations of its nodes on the beam, ascending [m]; 2 or more
};

/// A body of a tree, and the joint that carries it.
struct TreeBody {
  std::string name{};                             ///< for people
  std::variant<FlexibleBody, RigidBody> shape{};  ///< what it is
  int parent = -1;                                ///< index of the body that carries it; -1: hub
  std::size_t parent_node = 0;                    ///< of a flexible parent, else 0
  /// The body's frame at joint coordinates of zero: in the parent's frame, or that of its node.
  Placement placement{};
  Joint joint{};  ///< its axes are in the body's frame; offset and orientation are in `placement`
};

/// Bodies on the hub; parents stand before their children.
struct Tree {
  std::string name{};              ///< "blade 1", or that of a subsystem
  double azimuth = 0.0;            ///< of a blade, added to the hub's for AzimuthMotion [rad]
  std::vector<Beam> beams{};       ///< that its flexible bodies are parts of
  std::vector<TreeBody> bodies{};  ///< one or more
};

/// Coordinates of a tree: those of its joints, free or prescribed, and of its beams' nodes.
std::int64_t count_coordinates(const Tree& tree);

/// One tree for each blade, then one for each subsystem. Precondition: check_model() accepts it.
///
/// A blade's joints part it, and each part is cut into equally long bodies, none longer than
/// length/bodies; likewise a beam of a subsystem. A body has as many equally long elements as the
/// beam says, unless children within it need nodes: then as many, or one between two of these at
/// least, as equal as that allows.
std::vector<Tree> build_trees(const Model& model);

/// The frame of blades in the hub's: z along its axis.
Placement rotor_placement(const Hub& hub);

/// Where each body's frame is in the hub's frame, at joint coordinates of zero.
std::vector<Placement> calc_placements(const Tree& tree);

/// Mass properties of a body in its own frame.
MassProperties calc_mass_properties(const Tree& tree, const TreeBody& body);

/// Mass properties of a tree in the hub's frame, at joint coordinates of zero.
MassProperties calc_mass_properties(const Tree& tree);

/// Of hub and trees, likewise.
MassProperties calc_mass_properties(const Hub& hub, const std::vector<Tree>& trees);

}  // namespace spoke::spatial
