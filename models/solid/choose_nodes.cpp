// Nodes by name or place, and their weights: integrals of shape functions over faces.

#include "models/solid/choose_nodes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <sstream>
#include <string_view>

#include "models/count_text.h"
#include "models/error.h"
#include "models/solid/element_faces.h"
#include "models/support/gauss_rule.h"
#include "models/support/nearest_name.h"

namespace spoke::solid {
namespace {

using spatial::BoxNodes;
using spatial::CylinderNodes;
using spatial::PlaneNodes;
using spatial::SolidFace;
using spatial::SolidMesh;
using spatial::SolidNodeSet;
using spatial::Vector;

[[noreturn]] void refuse_choice(const std::string& what) { throw InputError(what); }

const SolidNodeSet& find_set(const SolidMesh& mesh, const std::string& name) {
  std::vector<std::string_view> names;
  for (const SolidNodeSet& set : mesh.sets) {
    if (set.name == name) return set;
    names.push_back(set.name);
  }
  if (names.empty())
    refuse_choice("is \"" + name +
                  "\", but the mesh has no sets, expected a plane, a cylinder or a box, or a mesh "
                  "with physical groups (gmsh) or *NSET");
  refuse_choice(describe_unknown(name, names));
}

void check_place(const std::string& what, const Vector& place) {
  if (!place.allFinite()) refuse_choice("has a " + what + " that is not finite, expected numbers");
}
void check_direction(const std::string& what, const Vector& direction) {
  if (!direction.allFinite() || !(direction.norm() > 0.0))
    refuse_choice("has a " + what + " of length zero, expected a direction");
}
void check_tolerance(double tolerance) {
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance))
    refuse_choice("has a tolerance below zero, expected a distance in metres");
}

/// Whether a node counts, by its place.
struct IsChosen {
  const Vector& x;

  bool operator()(const std::string&) const { return false; }
  bool operator()(const PlaneNodes& plane) const {
    return std::abs((x - plane.point).dot(plane.normal.normalized())) <= plane.tolerance;
  }
  bool operator()(const CylinderNodes& cylinder) const {
    const double distance = (x - cylinder.point).cross(cylinder.axis.normalized()).norm();
    return std::abs(distance - cylinder.radius) <= cylinder.tolerance;
  }
  bool operator()(const BoxNodes& box) const {
    return (x.array() >= box.from.array()).all() && (x.array() <= box.to.array()).all();
  }
};

struct CheckChoice {
  void operator()(const std::string&) const {}
  void operator()(const PlaneNodes& plane) const {
    check_place("point", plane.point);
    check_direction("normal", plane.normal);
    check_tolerance(plane.tolerance);
  }
  void operator()(const CylinderNodes& cylinder) const {
    check_place("point", cylinder.point);
    check_direction("axis", cylinder.axis);
    check_tolerance(cylinder.tolerance);
    if (!(cylinder.radius > 0.0) || !std::isfinite(cylinder.radius))
      refuse_choice("has a radius that is not positive, expected one in metres");
  }
  void operator()(const BoxNodes& box) const {
    check_place("corner \"from\"", box.from);
    check_place("corner \"to\"", box.to);
    if (!(box.from.array() <= box.to.array()).all())
      refuse_choice("has a box that ends before it begins, expected from <= to in x, y and z");
  }
};

/// Shape functions of a face and their derivatives by its two parameters, by node.
struct FaceShapes {
  std::array<double, 8> N{}, dr{}, ds{};
};

FaceShapes shapes_of_triangle(int count, double r, double s) {
  FaceShapes shape;
  const std::array<double, 3> L{1.0 - r - s, r, s}, Lr{-1.0, 1.0, 0.0}, Ls{-1.0, 0.0, 1.0};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    if (count == 3) {
      shape.N[a] = L[a], shape.dr[a] = Lr[a], shape.ds[a] = Ls[a];
      continue;
    }
    shape.N[a] = L[a] * (2.0 * L[a] - 1.0);
    shape.dr[a] = (4.0 * L[a] - 1.0) * Lr[a];
    shape.ds[a] = (4.0 * L[a] - 1.0) * Ls[a];
    shape.N[3 + a] = 4.0 * L[a] * L[b];
    shape.dr[3 + a] = 4.0 * (Lr[a] * L[b] + L[a] * Lr[b]);
    shape.ds[3 + a] = 4.0 * (Ls[a] * L[b] + L[a] * Ls[b]);
  }
  return shape;
}

/// Of the square from -1 to 1; mid nodes of the serendipity family.
FaceShapes shapes_of_quadrilateral(int count, double r, double s) {
  FaceShapes shape;
  constexpr std::array<double, 4> kR{-1.0, 1.0, 1.0, -1.0}, kS{-1.0, -1.0, 1.0, 1.0};
  for (std::size_t a = 0; a < 4; ++a) {
    const double u = kR[a] * r, v = kS[a] * s;
    if (count == 4) {
      shape.N[a] = 0.25 * (1.0 + u) * (1.0 + v);
      shape.dr[a] = 0.25 * kR[a] * (1.0 + v);
      shape.ds[a] = 0.25 * kS[a] * (1.0 + u);
      continue;
    }
    shape.N[a] = 0.25 * (1.0 + u) * (1.0 + v) * (u + v - 1.0);
    shape.dr[a] = 0.25 * kR[a] * (1.0 + v) * (2.0 * u + v);
    shape.ds[a] = 0.25 * kS[a] * (1.0 + u) * (u + 2.0 * v);
    const double side = a == 0 || a == 3 ? -1.0 : 1.0;  // of s at 4, r at 5, s at 6, r at 7
    if (a % 2 == 0) {
      shape.N[4 + a] = 0.5 * (1.0 - r * r) * (1.0 + side * s);
      shape.dr[4 + a] = -r * (1.0 + side * s);
      shape.ds[4 + a] = 0.5 * (1.0 - r * r) * side;
    } else {
      shape.N[4 + a] = 0.5 * (1.0 + side * r) * (1.0 - s * s);
      shape.dr[4 + a] = 0.5 * side * (1.0 - s * s);
      shape.ds[4 + a] = -s * (1.0 + side * r);
    }
  }
  return shape;
}

void add_integrals(const SolidMesh& mesh, const SolidFace& face, const FaceShapes& shape,
                   double weight, std::array<double, 8>& sums) {
  Vector xr = Vector::Zero(), xs = Vector::Zero();
  for (std::size_t n = 0; n < static_cast<std::size_t>(face.count); ++n) {
    const Vector& x = mesh.nodes[static_cast<std::size_t>(face.nodes[n])];
    xr += shape.dr[n] * x;
    xs += shape.ds[n] * x;
  }
  const double area = weight * xr.cross(xs).norm();
  for (std::size_t n = 0; n < 8; ++n) sums[n] += area * shape.N[n];
}

/// Sets weights, area and point from faces; without faces weights are equal.
void weigh(const SolidMesh& mesh, const std::vector<SolidFace>& faces, ChosenNodes& chosen) {
  chosen.weights.assign(chosen.nodes.size(), 0.0);
  chosen.area = 0.0;
  for (const SolidFace& face : faces) {
    const std::array<double, 8> integrals = integrate_shapes(mesh, face);
    for (std::size_t n = 0; n < static_cast<std::size_t>(face.count); ++n) {
      // check_mesh() has seen that faces have nodes of their sets only.
      const auto at = std::lower_bound(chosen.nodes.begin(), chosen.nodes.end(), face.nodes[n]);
      assert(at != chosen.nodes.end() && *at == face.nodes[n]);
      chosen.weights[static_cast<std::size_t>(at - chosen.nodes.begin())] += integrals[n];
      chosen.area += integrals[n];
    }
  }
  for (double& weight : chosen.weights)
    weight =
        chosen.area > 0.0 ? weight / chosen.area : 1.0 / static_cast<double>(chosen.nodes.size());
  chosen.point.setZero();
  for (std::size_t n = 0; n < chosen.nodes.size(); ++n)
    chosen.point += chosen.weights[n] * mesh.nodes[static_cast<std::size_t>(chosen.nodes[n])];
}

}  // namespace

bool are_on_line(const SolidMesh& mesh, const std::vector<int>& nodes) {
  Vector mean = Vector::Zero();
  for (const int node : nodes) mean += mesh.nodes[static_cast<std::size_t>(node)];
  mean /= static_cast<double>(nodes.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const int node : nodes) {
    const Vector r = mesh.nodes[static_cast<std::size_t>(node)] - mean;
    spread += r * r.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread, Eigen::EigenvaluesOnly);
  return !(solver.eigenvalues()[1] > 1e-9 * solver.eigenvalues()[2]);
}

std::array<double, 8> integrate_shapes(const SolidMesh& mesh, const SolidFace& face) {
  using Rule = GaussRule<4>;
  std::array<double, 8> sums{};
  // The triangle's rule is that of the square with one side drawn together: r = a, s = b (1 - a).
  for (std::size_t i = 0; i < Rule::kPoints; ++i)
    for (std::size_t j = 0; j < Rule::kPoints; ++j) {
      const double a = Rule::places[i], b = Rule::places[j];
      const double weight = Rule::weights[i] * Rule::weights[j];
      if (count_corners(face) == 3)
        add_integrals(mesh, face, shapes_of_triangle(face.count, a, b * (1.0 - a)),
                      weight * (1.0 - a), sums);
      else
        add_integrals(mesh, face, shapes_of_quadrilateral(face.count, 2.0 * a - 1.0, 2.0 * b - 1.0),
                      4.0 * weight, sums);
    }
  return sums;
}

const std::vector<SurfaceFace>& NodeChooser::surface() {
  if (!surface_) surface_ = find_surface(mesh_);
  return *surface_;
}

std::vector<int> NodeChooser::surface_nodes() {
  if (!mesh_.elements.empty()) return nodes_of(surface());
  std::vector<int> all(mesh_.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<int> NodeChooser::find_on_surface(const spatial::NodeChoice& choice) {
  std::visit(CheckChoice(), choice);
  std::vector<int> nodes;
  Vector least = Vector::Constant(std::numeric_limits<double>::infinity()), greatest = -least;
  for (const int node : surface_nodes()) {
    const Vector& x = mesh_.nodes[static_cast<std::size_t>(node)];
    least = least.cwiseMin(x);
    greatest = greatest.cwiseMax(x);
    if (std::visit(IsChosen{x}, choice)) nodes.push_back(node);
  }
  if (nodes.empty()) {
    std::ostringstream text;
    text << "chooses no nodes, expected some of the surface, which lies from (" << least.x() << ", "
         << least.y() << ", " << least.z() << ") to (" << greatest.x() << ", " << greatest.y()
         << ", " << greatest.z() << ") m";
    refuse_choice(text.str());
  }
  return nodes;
}

std::vector<SolidFace> NodeChooser::find_whole_faces(const std::vector<int>& nodes) {
  std::vector<char> is_chosen(mesh_.nodes.size(), 0);
  for (const int node : nodes) is_chosen[static_cast<std::size_t>(node)] = 1;
  std::vector<SolidFace> faces;
  for (const SurfaceFace& face : surface()) {
    bool is_whole = true;
    for (std::size_t n = 0; n < static_cast<std::size_t>(face.face.count); ++n)
      is_whole = is_whole && is_chosen[static_cast<std::size_t>(face.face.nodes[n])] != 0;
    if (is_whole) faces.push_back(face.face);
  }
  return faces;
}

ChosenNodes NodeChooser::choose(const spatial::NodeChoice& choice) {
  ChosenNodes chosen;
  if (const auto* name = std::get_if<std::string>(&choice)) {
    const SolidNodeSet& set = find_set(mesh_, *name);
    if (set.nodes.empty())
      refuse_choice("chooses no nodes: set \"" + *name +
                    "\" has none of volume elements, expected nodes of tetrahedra or hexahedra");
    chosen.nodes = set.nodes;
    weigh(mesh_, set.faces.empty() ? find_whole_faces(chosen.nodes) : set.faces, chosen);
  } else {
    chosen.nodes = find_on_surface(choice);
    weigh(mesh_, find_whole_faces(chosen.nodes), chosen);
  }
  return chosen;
}

ChosenNodes NodeChooser::choose_interface(const spatial::SolidInterface& interface) {
  ChosenNodes chosen = choose(interface.nodes);
  const std::string count = "chooses " + counted(std::ssize(chosen.nodes), "node");
  if (chosen.nodes.size() < 3)
    refuse_choice(count + ", expected three or more that are not on one line");
  if (are_on_line(mesh_, chosen.nodes))
    refuse_choice(count + " on one line, expected three or more that are not on one line");
  if (interface.point) chosen.point = *interface.point;
  return chosen;
}

ChosenNodes choose_nodes(const SolidMesh& mesh, const spatial::NodeChoice& choice) {
  return NodeChooser(mesh).choose(choice);
}

}  // namespace spoke::solid
