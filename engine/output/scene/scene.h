#pragma once

// The parts of a model that are drawn: fixed to nodes that frames move, and surfaces of solids,
// which deform by their coordinates. A scene is made before anything is simulated, of a scenario
// and, where its solids are to deform, of their constants. Plane and space look alike here.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::space {
class NodeRecovery;
}

namespace spoke::scene {

using spatial::Vector;

/// A section of a beam, the frame of a rigid body, or a place of a solid (MeshBody). All places and
/// directions of a scene are those of the undeformed model with joint coordinates zero, in the
/// frame of the hub as the scenario describes it [m].
struct Node {
  int group = 0;  ///< of bodies without joints between them; 0 stands on the hub
  Vector p = Vector::Zero();
  spatial::Tensor axes = spatial::Tensor::Identity();  ///< axes of the body, see TreeNode::R
};

/// The source of a state of a node: a node in the shape of a subsystem.
struct NodeSource {
  int subsystem = 0;
  int body = 0;  ///< in the subsystem
  int node = 0;  ///< of the body
};

/// A place that nodes carry: on the element of a beam between `node` and the next one, at the share
/// `xi` of it; if xi is 0, fixed to the node. node -1: fixed to a group, 0 for the hub; of a
/// carrier in the axes of its frame.
struct Place {
  int node = -1;
  double xi = 0.0;
  Vector p = Vector::Zero();
  int group = 0;
};

/// The frame of the hub of a rotor, as the scenario describes it.
struct HubFrame {
  int group = 0;  ///< 0 of the first rotor
  /// On a support, the hub's centre on the body that carries the axle; else -1.
  int node = -1;
  /// From axes with z along the hub's axis to those of the scenario.
  spatial::Tensor to_hub = spatial::Tensor::Identity();
};

/// A group that is no body's: the motion of the mount or of an anchor, which loops close on.
struct Carrier {
  int anchor = -1;  ///< index of the anchor; -1: the mount
  int rotor = 0;    ///< whose hub or axle it is beside
  int group = 0;
};

/// An outline of a section: an ellipse.
struct Ring {
  Place at;
  Vector y = Vector::UnitY(), z = Vector::UnitZ();  ///< the section's axes
  double half_y = 0.0, half_z = 0.0;                ///< semi-axes along them [m]
};

/// A flexible body: nodes in a row, and elements between them.
struct Strip {
  std::string name;  ///< "blade 1 / body 2"
  int subsystem = 0;
  int first = 0;  ///< first node
  int nodes = 0;
  std::vector<Ring> rings;  ///< from the inboard end
};

/// A convex body with plane faces, fixed to a node, or to a group.
struct Solid {
  std::string name;
  int subsystem = -1;  ///< -1: none
  int node = -1;       ///< -1: none
  int group = 0;       ///< without a node; 0: the hub
  std::vector<Vector> vertices;
  std::vector<std::vector<int>> faces;  ///< corners, counterclockwise as seen from outside
};

/// The surface of a solid's mesh, as far as it is drawn. Equal solids share it.
struct Surface {
  std::vector<int> nodes;                     ///< nodes of the mesh that are drawn, ascending
  std::vector<Vector> places;                 ///< their places at rest in the frame of the body [m]
  std::vector<std::array<int, 3>> triangles;  ///< of drawn nodes, counterclockwise from outside
  std::vector<std::array<int, 2>> edges;      ///< sharp ones
  /// Displacements and stresses of the drawn nodes; null where only the mesh is known.
  std::shared_ptr<const space::NodeRecovery> recovery;

  /// Returns the number of coordinates that a frame of a page holds for a solid of it: those of a
  /// reduced one; displacement and von Mises stress of each node of a nodal one.
  std::size_t frame_numbers() const;
};

/// An interface of a solid.
struct InterfaceMark {
  std::string name;
  int node = 0;
};

/// A solid, whose nodes of the scene are its frame, its interfaces, and sets that loads act on.
struct MeshBody {
  std::string name;  ///< "arm / bracket"
  int subsystem = 0;
  int body = 0;     ///< in the subsystem
  int node = 0;     ///< that of its frame
  int surface = 0;  ///< index of its surface
  std::vector<InterfaceMark> interfaces;
};

/// A rigid connection within a rigid body.
struct Link {
  int subsystem = 0;
  int node = 0;
  Vector from = Vector::Zero(), to = Vector::Zero();
};

/// A joint, with the axes of its freedoms.
struct JointMark {
  std::string name;  ///< "blade 1 / flap"
  std::string kind;  ///< "revolute", ...
  int node = 0;      ///< of the child
  std::vector<Vector> axes;
  std::vector<std::string> coordinates;  ///< "free", "sprung", "prescribed"
};

/// A closed loop: a rod of kind "distance", else a joint.
struct LoopMark {
  std::string name;  ///< "blade 1 / pitch_link"
  std::string kind;  ///< "distance", "revolute", ...
  int subsystem = 0;
  Place from, to;
  std::vector<Vector> axes;  ///< that turn with `to`
  bool is_sprung = false;    ///< whether it gives
};

/// A load at a place.
struct LoadMark {
  Place at;
  /// The frame with which the vectors turn: "inertial", "hub", "body" or "section". Vectors of
  /// "inertial" are in inertial axes, all others in those of the hub.
  std::string frame;
  Vector force = Vector::Zero();   ///< [N], or [N/m] if it is distributed
  Vector moment = Vector::Zero();  ///< [N m], or [N]
  bool is_distributed = false;
};

/// A sensor at a place.
struct SensorMark {
  std::string name;
  Place at;
};

/// All parts that are drawn.
struct Scene {
  bool is_planar = false;
  Vector axis = Vector::UnitZ();    ///< of the hub
  Vector gravity = Vector::Zero();  ///< inertial axes [m/s^2]
  int groups = 1;
  /// Index of the subsystem that is the support, whose undeformed nodes are in the frame of its
  /// base; and the group that is the motion of that frame, behind which are those of its bodies, of
  /// the hubs of rotors besides the first, and of what these carry. -1: none.
  int support = -1, base_group = -1;
  std::vector<HubFrame> hubs;           ///< by rotor, in space
  std::vector<std::string> subsystems;  ///< names
  std::vector<int> roots;               ///< by subsystem, the group of what carries it
  std::vector<int> tips;                ///< last node, by subsystem
  std::vector<Node> nodes;
  std::vector<NodeSource> sources;  ///< by node
  std::vector<Strip> strips;
  std::vector<Solid> solids;
  std::vector<Surface> surfaces;
  std::vector<MeshBody> meshes;
  std::vector<Link> links;
  std::vector<JointMark> joints;
  std::vector<LoopMark> loops;
  std::vector<Carrier> carriers;
  std::vector<LoadMark> loads;
  std::vector<SensorMark> sensors;

  /// Returns the number of elements of all strips.
  std::size_t element_count() const;
  /// Returns the largest distance of a node from the origin of the hub [m].
  double radius() const;
};

}  // namespace spoke::scene
