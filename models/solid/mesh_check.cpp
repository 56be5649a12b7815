// Checks of a mesh: arrays, nodes, elements, faces, connection.

#include "models/solid/mesh_check.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <sstream>
#include <vector>

#include "models/error.h"
#include "models/solid/element_faces.h"
#include "models/solid/elements.h"
#include "models/solid/surface.h"

namespace spoke::solid {
namespace {

using spatial::SolidElement;
using spatial::SolidFace;
using spatial::SolidMesh;
using spatial::SolidNodeSet;
using spatial::Vector;

constexpr double kGreatestExtent = 1e4;  // [m]
constexpr double kLeastExtent = 1e-5;    // [m]

std::span<const int> nodes_of_element(const SolidElement& element) {
  return {element.nodes.data(), static_cast<std::size_t>(count_nodes(element.kind))};
}

class MeshCheck {
 public:
  explicit MeshCheck(const SolidMesh& mesh) : mesh_(mesh) {}

  void check() const {
    check_sizes();
    check_indices();
    check_extent();
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) check_shape(e);
    check_faces();
    check_connection();
    for (const SolidNodeSet& set : mesh_.sets) check_set(set);
    check_masses();
  }

 private:
  /// Throws at the line of an element, 0: of none.
  [[noreturn]] void refuse(const std::string& what, int line = 0) const {
    std::string place = mesh_.file;
    if (line > 0) place += ':' + std::to_string(line);
    throw InputError(place.empty() ? what : place + ": " + what,
                     {.file = mesh_.file, .line = line, .key = "mesh"});
  }
  /// Throws: "the tet10 (volume element 7) WHAT".
  [[noreturn]] void refuse_element(std::size_t e, const std::string& what) const {
    const SolidElement& element = mesh_.elements[e];
    refuse("the " + std::string(name_of(element.kind)) + " (volume element " +
               std::to_string(e + 1) + ") " + what,
           element.line);
  }
  std::string name(int node) const { return name_of_node(mesh_, node); }
  const Vector& place(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }

  void check_sizes() const {
    if (mesh_.elements.empty())
      refuse(
          "has no volume elements, expected tetrahedra or hexahedra (gmsh writes those of physical "
          "volumes, or all by Mesh.SaveAll = 1)");
    if (mesh_.nodes.size() > INT_MAX / 3)
      refuse("has " + std::to_string(mesh_.nodes.size()) + " nodes, expected fewer than " +
             std::to_string(INT_MAX / 3));
    if (!mesh_.labels.empty() && mesh_.labels.size() != mesh_.nodes.size())
      refuse("has " + std::to_string(mesh_.labels.size()) + " labels of " +
             std::to_string(mesh_.nodes.size()) + " nodes, expected as many or none");
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n)
      if (!mesh_.nodes[n].allFinite())
        refuse(name(static_cast<int>(n)) + " has a place that is not finite, expected numbers");
  }

  void check_indices() const {
    std::vector<char> is_used(mesh_.nodes.size(), 0);
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const auto nodes = nodes_of_element(mesh_.elements[e]);
      std::array<int, 20> sorted{};
      std::copy(nodes.begin(), nodes.end(), sorted.begin());
      std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(nodes.size()));
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n] < 0 || static_cast<std::size_t>(nodes[n]) >= mesh_.nodes.size())
          refuse_element(e, "has a node of index " + std::to_string(nodes[n]) + ", expected 0 to " +
                                std::to_string(mesh_.nodes.size() - 1));
        if (n > 0 && sorted[n] == sorted[n - 1])
          refuse_element(e, "has " + name(sorted[n]) + " twice, expected different nodes");
        is_used[static_cast<std::size_t>(nodes[n])] = 1;
      }
    }
    const auto unused = std::find(is_used.begin(), is_used.end(), 0);
    if (unused != is_used.end())
      refuse(name(static_cast<int>(unused - is_used.begin())) +
             " belongs to no element, expected nodes of elements only");
  }

  void check_extent() const {
    Vector least = place(0), greatest = place(0);
    for (const Vector& x : mesh_.nodes) {
      least = least.cwiseMin(x);
      greatest = greatest.cwiseMax(x);
    }
    const double extent = (greatest - least).maxCoeff();
    std::ostringstream text;
    text << "extends over " << extent << " m, expected ";
    if (!(extent <= kGreatestExtent)) {
      text << "at most " << kGreatestExtent << " m (of a file in mm: scale = { length = 1e-3 })";
      refuse(text.str());
    }
    if (extent < kLeastExtent) {
      text << "at least " << kLeastExtent << " m (lengths are metres after scale.length)";
      refuse(text.str());
    }
  }

  /// Mid nodes near the middles of their edges, volumes positive.
  void check_shape(std::size_t e) const {
    const SolidElement& element = mesh_.elements[e];
    const NodeColumns x = places_of(mesh_, element);
    check_mid_nodes(e);
    const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
    const double ratio = least_volume_ratio(element.kind, x);
    const double least = 1e-9 * size * size * size;
    if (ratio > least) return check_at_nodes(e, x, least);
    const bool is_flat = std::abs(ratio) <= least;
    refuse_element(e, std::string(is_flat ? "is degenerate" : "is inverted") + " at " +
                          name(element.nodes[0]) +
                          (is_flat ? ", expected a positive volume everywhere in it"
                                   : ", expected a positive volume everywhere in it and nodes in "
                                     "the order of the format"));
  }

  /// No fold within an element whose points of integration are all well: a quarter-point node, with
  /// no volume at the corner, is just allowed.
  void check_at_nodes(std::size_t e, const NodeColumns& x, double least) const {
    const SolidElement& element = mesh_.elements[e];
    const NodeVolume found = least_volume_at_nodes(element.kind, x);
    if (found.ratio >= -least) return;
    refuse_element(e, "is inverted near " +
                          name(element.nodes[static_cast<std::size_t>(found.node)]) +
                          ", expected a positive volume everywhere in it: mid nodes within a "
                          "quarter of their edge from its middle, and nodes in the order of the "
                          "format");
  }

  void check_mid_nodes(std::size_t e) const {
    const SolidElement& element = mesh_.elements[e];
    for (const SolidFace& face : faces_of(element)) {
      const auto corners = static_cast<std::size_t>(count_corners(face));
      for (std::size_t n = corners; n < static_cast<std::size_t>(face.count); ++n) {
        const Vector& a = place(face.nodes[n - corners]);
        const Vector& b = place(face.nodes[(n - corners + 1) % corners]);
        if ((place(face.nodes[n]) - 0.5 * (a + b)).norm() > 0.45 * (b - a).norm())
          refuse_element(e, "has its mid " + name(face.nodes[n]) +
                                " far from the middle of its edge, expected it within 0.45 of the "
                                "edge's length");
      }
    }
  }

  /// Two elements at most share a face, on its two sides, with the same mid nodes.
  void check_faces() const {
    const std::vector<ElementFace> faces = sort_faces(mesh_);
    for (std::size_t k = 1; k < faces.size(); ++k) {
      if (faces[k].corners != faces[k - 1].corners) continue;
      const auto e = static_cast<std::size_t>(faces[k].element);
      const SolidFace a = face_of(faces[k - 1]), b = face_of(faces[k]);
      const std::string other =
          "volume element " + std::to_string(faces[k - 1].element + 1) + " at " + name(a.nodes[0]);
      if (k > 1 && faces[k - 2].corners == faces[k].corners)
        refuse_element(e, "has a face of two other elements, one of them " + other +
                              ", expected a face of two elements at most");
      if (a.count != b.count || !are_opposite(a, b))
        refuse_element(e, "does not fit the face of " + other +
                              ", expected elements on both sides of it, with the same mid nodes");
    }
  }
  SolidFace face_of(const ElementFace& face) const {
    return faces_of(
        mesh_
            .elements[static_cast<std::size_t>(face.element)])[static_cast<std::size_t>(face.side)];
  }
  static bool are_opposite(const SolidFace& a, const SolidFace& b) {
    const auto corners = static_cast<std::size_t>(count_corners(a));
    const auto first = static_cast<std::size_t>(
        std::find(b.nodes.begin(), b.nodes.begin() + static_cast<std::ptrdiff_t>(corners),
                  a.nodes[0]) -
        b.nodes.begin());
    for (std::size_t n = 0; n < corners; ++n)
      if (a.nodes[n] != b.nodes[(first + corners - n) % corners]) return false;
    if (static_cast<std::size_t>(a.count) == corners) return true;
    for (std::size_t n = 0; n < corners; ++n)  // edge n of a is edge first - n - 1 of b
      if (a.nodes[corners + n] != b.nodes[corners + (first + 2 * corners - n - 1) % corners])
        return false;
    return true;
  }

  /// All nodes hang together by elements.
  void check_connection() const {
    std::vector<int> root(mesh_.nodes.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find_root = [&](int node) {
      while (root[static_cast<std::size_t>(node)] != node) {
        int& up = root[static_cast<std::size_t>(node)];
        up = root[static_cast<std::size_t>(up)];
        node = up;
      }
      return node;
    };
    for (const SolidElement& element : mesh_.elements)
      for (const int node : nodes_of_element(element)) {
        const int a = find_root(element.nodes[0]), b = find_root(node);
        root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    for (const SolidElement& element : mesh_.elements)
      if (find_root(element.nodes[0]) != find_root(0))
        refuse("is of several parts: " + name(element.nodes[0]) + " does not hang together with " +
                   name(0) + ", expected one body",
               element.line);
  }

  void check_set(const SolidNodeSet& set) const {
    const auto is_node = [&](int node) {
      return node >= 0 && static_cast<std::size_t>(node) < mesh_.nodes.size();
    };
    const std::string start = "has a set \"" + set.name + "\" ";
    for (std::size_t n = 0; n < set.nodes.size(); ++n)
      if (!is_node(set.nodes[n]) || (n > 0 && set.nodes[n] <= set.nodes[n - 1]))
        refuse(start + "with a node of index " + std::to_string(set.nodes[n]) +
               ", expected ascending indices of nodes");
    for (const SolidFace& face : set.faces) {
      if (face.count != 3 && face.count != 4 && face.count != 6 && face.count != 8)
        refuse(start + "with a face of " + std::to_string(face.count) +
               " nodes, expected 3, 4, 6 or 8");
      for (std::size_t n = 0; n < static_cast<std::size_t>(face.count); ++n)
        if (!std::binary_search(set.nodes.begin(), set.nodes.end(), face.nodes[n]))
          refuse(start + "with a face at a node of index " + std::to_string(face.nodes[n]) +
                 ", expected nodes of the set");
    }
  }

  void check_masses() const {
    for (const auto& [node, mass] : mesh_.masses) {
      if (node < 0 || static_cast<std::size_t>(node) >= mesh_.nodes.size())
        refuse("has a mass at a node of index " + std::to_string(node) + ", expected 0 to " +
               std::to_string(mesh_.nodes.size() - 1));
      if (mass >= 0.0 && std::isfinite(mass)) continue;
      std::ostringstream text;
      text << "has a mass of " << mass << " kg at " << name(node) << ", expected 0 or more";
      refuse(text.str());
    }
  }

  const SolidMesh& mesh_;
};

}  // namespace

std::string name_of_node(const SolidMesh& mesh, int node) {
  const auto at = static_cast<std::size_t>(node);
  return "node " + std::to_string(at < mesh.labels.size() ? mesh.labels[at] : node + 1);
}

bool has_locking_elements(const SolidMesh& mesh) {
  return std::any_of(mesh.elements.begin(), mesh.elements.end(), [](const auto& element) {
    return element.kind == spatial::ElementKind::tet4 || element.kind == spatial::ElementKind::hex8;
  });
}

void check_mesh(const SolidMesh& mesh) { MeshCheck(mesh).check(); }

}  // namespace spoke::solid
