// Mass and moments of a solid at rest.

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

#include "models/error.h"
#include "models/solid/elements.h"
#include "models/solid/import.h"
#include "models/solid/interfaces.h"
#include "models/solid/mesh_check.h"
#include "models/solid/solid.h"

namespace spoke::solid {
namespace {

using spatial::SolidBody;
using spatial::SolidMaterial;
using spatial::Vector;

constexpr double kGreatestMass = 1e9;      // [kg]
constexpr double kLeastDensity = 1e-3;     // [kg/m^3]
constexpr double kGreatestDensity = 1e12;  // [kg/m^3]

void check_material(const SolidMaterial& material) {
  const auto require = [](bool holds, const std::string& key, double value,
                          const std::string& expected) {
    if (!holds || !std::isfinite(value))
      refuse_field("material." + key, "is " + show_number(value) + ", expected " + expected);
  };
  require(material.youngs_modulus > 0.0, "youngs_modulus", material.youngs_modulus,
          "a positive number [Pa]");
  require(material.poissons_ratio > -1.0 && material.poissons_ratio < 0.5, "poissons_ratio",
          material.poissons_ratio, "above -1 and below 0.5");
  require(material.density >= kLeastDensity && material.density <= kGreatestDensity, "density",
          material.density, "0.001 to 1e12 kg/m^3 (not t/mm^3)");
}

/// Adds mass and moments about a point near the mesh: the far origin of a file would cost digits.
void add_moments(const spatial::SolidMesh& mesh, double density, const Vector& about,
                 SolidGeometry& geometry) {
  for (const spatial::SolidElement& element : mesh.elements) {
    const NodeColumns x = places_of(mesh, element);
    NodeColumns gradients(3, x.cols());
    double mass = 0.0;
    Vector first = Vector::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const ShapePoint& point : mass_rule(element.kind, is_curved(element.kind, x))) {
      const double dm = density * point.weight * calc_gradients(point, x, gradients);
      const Vector r = x * point.N - about;
      mass += dm;
      first += dm * r;
      second += dm * r * r.transpose();
    }
    geometry.mass += mass;
    geometry.first_moment += first;
    geometry.second_moment += second;
  }
  for (const auto& [node, mass] : mesh.masses) {
    const Vector r = mesh.nodes[static_cast<std::size_t>(node)] - about;
    geometry.mass += mass;
    geometry.first_moment += mass * r;
    geometry.second_moment += mass * r * r.transpose();
  }
}

/// Reads the mesh, if it is not there, and the material, if the body has none.
void take_mesh(const SolidBody& body, SolidGeometry& geometry) {
  std::optional<SolidMaterial> material;
  geometry.mesh = body.mesh;
  if (!geometry.mesh) {
    if (body.file.empty()) refuse_field("mesh", "is missing, expected the file of a mesh");
    check_length_scale(body.length_scale);
    try {
      geometry.mesh = read_mesh(body.file, body.length_scale, &material);
    } catch (const InputError& error) {
      throw InputError(error.what(),
                       {.file = error.place().file, .line = error.place().line, .key = "mesh"});
    }
  }
  if (body.material) material = body.material;
  const std::string& fault = geometry.mesh->material_fault;
  if (!material)
    refuse_field("material",
                 "is missing, " + (fault.empty() ? "" : "and the mesh's file " + fault + "; ") +
                     "expected youngs_modulus, poissons_ratio and density (or an .inp file "
                     "with one isotropic material)");
  geometry.material = *material;
}

}  // namespace

SolidGeometry make_geometry(const SolidBody& body) {
  if (body.matrices) {
    check_length_scale(body.length_scale);
    return make_geometry_of_matrices(body, read_matrices(*body.matrices, body.length_scale));
  }
  SolidGeometry geometry;
  take_mesh(body, geometry);
  check_material(geometry.material);
  check_mesh(*geometry.mesh);
  const Vector about = geometry.mesh->nodes.front();
  add_moments(*geometry.mesh, geometry.material.density, about, geometry);
  if (!(geometry.mass <= kGreatestMass))
    refuse_field("mesh", "has a mass of " + show_number(geometry.mass) +
                             " kg, expected at most 1e9 kg (of a file in mm: scale = { length = "
                             "1e-3 })");
  find_interfaces(body, geometry);
  move_moments_to_first(geometry, about);
  return geometry;
}

}  // namespace spoke::solid
