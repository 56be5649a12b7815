#pragma once

// The description of a solid: a flexible body from a finite-element mesh, as an engineer gives it.
// docs/solids.md is its tutorial; its mathematics is in docs/formulation.md, section 13.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/mount_motion.h"
#include "spoke/export.h"

namespace spoke::solid {
struct KeptGeometry;
}

namespace spoke::spatial {

/// The kinds of elements. Numbers of nodes stand in the order of Abaqus.
enum class ElementKind {
  tet4,   ///< C3D4, linear: too stiff, for comparison
  tet10,  ///< C3D10, quadratic, straight or curved; mid nodes (12)(23)(31)(14)(24)(34)
  hex8,   ///< C3D8, linear: too stiff, for comparison
  hex20,  ///< C3D20, quadratic
};
/// Returns the number of nodes of an element: 4, 10, 8 or 20.
SPOKE_EXPORT int count_nodes(ElementKind kind);
/// Returns "tet4", "tet10", "hex8" or "hex20".
SPOKE_EXPORT std::string_view name_of(ElementKind kind);

/// An element of a mesh.
struct SolidElement {
  ElementKind kind = ElementKind::tet10;
  std::array<int, 20> nodes{};  ///< indices of its nodes from 0; the first count_nodes(kind) count
  int line = 0;                 ///< line of the mesh's file; 0: there is none
};

/// A face of elements: 3 or 6 nodes of a triangle, 4 or 8 of a quadrilateral; corners first, then
/// the middle of the sides 12, 23, ...
struct SolidFace {
  int count = 0;
  std::array<int, 8> nodes{};
};

/// A named set of nodes. One of a surface has faces, by which loads are spread and averages taken.
struct SolidNodeSet {
  std::string name{};
  std::vector<int> nodes{};  ///< indices from 0, ascending, each once
  std::vector<SolidFace> faces{};
};

/// A mass without extent that moves with a node.
struct SolidNodeMass {
  int node = 0;       ///< index from 0
  double mass = 0.0;  ///< [kg]
};

/// A finite-element mesh. Its axes are those of the body's frame.
struct SolidMesh {
  std::vector<Vector> nodes{};  ///< places [m]
  std::vector<SolidElement> elements{};
  std::vector<SolidNodeSet> sets{};
  std::vector<int> labels{};            ///< numbers of the nodes in their file; empty: index + 1
  std::string file{};                   ///< file it was read from, for messages; empty: none
  std::vector<SolidNodeMass> masses{};  ///< point masses; several at one node add up
  /// What its file says and the mesh has not, as people look for it: "*BOUNDARY (line 12)".
  std::vector<std::string> left_out{};
  /// Why its file has no material for the whole mesh, a clause: "has 2 materials, ..."; empty: it
  /// has one, or none at all.
  std::string material_fault{};
};

/// Linear isotropic material.
struct SolidMaterial {
  double youngs_modulus = 0.0;  ///< [Pa]
  double poissons_ratio = 0.0;  ///< above -1, below 0.5
  double density = 0.0;         ///< [kg/m^3]

  friend bool operator==(const SolidMaterial&, const SolidMaterial&) = default;
};

/// Nodes within `tolerance` of a plane.
struct PlaneNodes {
  Vector point = Vector::Zero();    ///< [m]
  Vector normal = Vector::UnitX();  ///< of any length but zero
  double tolerance = 1e-6;          ///< [m]

  friend bool operator==(const PlaneNodes&, const PlaneNodes&) = default;
};
/// Nodes within `tolerance` of the mantle of a cylinder of infinite length: a bore.
struct CylinderNodes {
  Vector point = Vector::Zero();  ///< on its axis [m]
  Vector axis = Vector::UnitX();  ///< of any length but zero
  double radius = 0.0;            ///< [m]
  double tolerance = 1e-6;        ///< [m]

  friend bool operator==(const CylinderNodes&, const CylinderNodes&) = default;
};
/// Nodes in a box, its sides included.
struct BoxNodes {
  Vector from = Vector::Zero();  ///< least coordinates [m]
  Vector to = Vector::Zero();    ///< greatest coordinates [m]

  friend bool operator==(const BoxNodes&, const BoxNodes&) = default;
};
/// A choice of nodes of a mesh: a set by its name, or where they are, in the mesh's axes and
/// metres. Chosen by place, only nodes on the surface of the mesh count.
using NodeChoice = std::variant<std::string, PlaneNodes, CylinderNodes, BoxNodes>;

/// What ties an interface to its nodes.
enum class InterfaceKind {
  rigid,    ///< its nodes move as a rigid body (RBE2)
  average,  ///< it follows their weighted mean and does not stiffen them (RBE3)
};

/// A place of a solid at which joints, loops, loads and sensors act.
struct SolidInterface {
  std::string name{};  ///< name, unlike that of any other interface of the body
  NodeChoice nodes{};
  InterfaceKind kind = InterfaceKind::rigid;
  /// Its point, in the mesh's axes [m]; none: the mean of its nodes, by area if they have faces.
  std::optional<Vector> point = std::nullopt;

  friend bool operator==(const SolidInterface&, const SolidInterface&) = default;
};

/// The deformation coordinates of a solid.
enum class SolidCoordinates {
  reduced,  ///< modes of vibration and of its interfaces (Craig-Bampton)
  nodal,    ///< displacements of all nodes
};

/// The conditions that tie a solid's floating frame to it.
enum class SolidFrame {
  clamped,    ///< the frame is that of the first interface
  mean_axis,  ///< deformation has neither momentum nor moment of momentum (Tisserand)
};

/// Mass and stiffness that another program has assembled, in place of the elements of a mesh: three
/// coordinates a node, not constrained anywhere.
struct SolidMatrices {
  std::string format{};     ///< "calculix", "abaqus" or "matrix_market"
  std::string mass{};       ///< file
  std::string stiffness{};  ///< file
  std::string nodes{};      ///< file of the nodes' places
  /// Files of geometric stiffness matrices, all or none: of the stresses under the accelerations of
  /// own[k] (wx^2, wy^2, wz^2, wy wz, wx wz, wx wy) and of translation along x, y, z.
  std::array<std::string, 6> own{};
  std::array<std::string, 3> translation{};

  friend bool operator==(const SolidMatrices&, const SolidMatrices&) = default;
};

/// Vibration modes of a solid that does not say how many, if it has as many.
inline constexpr int kUsualModes = 20;

/// A flexible body from a mesh. Its frame has the axes of the mesh and, with the frame `clamped`,
/// its origin at the point of the first interface; with `mean_axis` as well, at rest.
struct SolidBody {
  std::string file{};                       ///< mesh file; empty: `mesh` or `matrices`
  std::shared_ptr<const SolidMesh> mesh{};  ///< the mesh, read or made in code
  std::optional<SolidMatrices> matrices{};  ///< matrices of another program in place of a mesh
  /// None: that of an .inp file.
  std::optional<SolidMaterial> material{};
  double length_scale = 1.0;  ///< metres by the file's unit of length
  SolidCoordinates coordinates = SolidCoordinates::reduced;
  /// Number of vibration modes; none: kUsualModes, or as many as there are.
  std::optional<int> modes{};
  std::optional<double> up_to{};     ///< highest frequency of these, in place of a number [Hz]
  bool geometric_stiffening = true;  ///< whether tension of rotation and loads stiffens it
  /// Damping ratio of all modes, or by mode; empty: 0. Only of reduced coordinates.
  std::vector<double> damping{};
  SolidFrame frame = SolidFrame::clamped;
  std::vector<SolidInterface> interfaces{};  ///< the first one carries the frame
  /// What follows from the mesh, kept by what reads it, so that it is made once; of use as long as
  /// nothing that it was made of has been changed. May be null.
  std::shared_ptr<const solid::KeptGeometry> kept{};
};

/// Returns the index of a node by its number in the mesh's file; none if there is no such node.
SPOKE_EXPORT std::optional<int> find_node(const SolidMesh& mesh, int label);

/// Whether two descriptions have one shape: mesh, material and interfaces are equal.
SPOKE_EXPORT bool has_same_shape(const SolidBody& a, const SolidBody& b);
/// Whether two descriptions are equal: one mesh, and all else that is said of it.
SPOKE_EXPORT bool is_same_solid(const SolidBody& a, const SolidBody& b);
/// Returns the index of an interface by its name. Without a name it is the second one where there
/// are two: the only one that does not carry the frame. None if there is no such interface.
SPOKE_EXPORT std::optional<std::size_t> find_interface(const SolidBody& body,
                                                       std::string_view name);

/// Returns "rigid" or "average".
SPOKE_EXPORT std::string_view name_of(InterfaceKind kind);
/// Returns "reduced" or "nodal".
SPOKE_EXPORT std::string_view name_of(SolidCoordinates coordinates);
/// Returns "clamped" or "mean_axis".
SPOKE_EXPORT std::string_view name_of(SolidFrame frame);

}  // namespace spoke::spatial
