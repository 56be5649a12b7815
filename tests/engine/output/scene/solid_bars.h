#pragma once

// Bars from meshes whose deformations are known fields.

#include <functional>
#include <memory>
#include <vector>

#include "models/solid/assembly.h"
#include "models/space/solid.h"
#include "tests/models/solid/grid_mesh.h"

namespace spoke::test {

inline constexpr spatial::SolidMaterial kBarMaterial{2e11, 0.3, 7800.0};

/// A displacement as a function of place.
using Field = std::function<spatial::Vector(const spatial::Vector&)>;

/// Makes a reduced solid whose coordinates are the amplitudes of fields. Its frame is at the mesh's
/// origin; only what output needs is set.
inline std::shared_ptr<space::SolidConstants> make_solid_of_fields(
    std::shared_ptr<const spatial::SolidMesh> mesh, const std::vector<Field>& fields) {
  auto solid = std::make_shared<space::SolidConstants>();
  solid->coordinates = static_cast<int>(fields.size());
  solid->nodes.assign(mesh->nodes.begin(), mesh->nodes.end());
  solid->stress = solid::make_stress_operator(*mesh, kBarMaterial);
  space::ReducedSolid reduced;
  reduced.shapes.resize(3 * std::ssize(mesh->nodes), std::ssize(fields));
  for (std::size_t k = 0; k < mesh->nodes.size(); ++k)
    for (std::size_t c = 0; c < fields.size(); ++c)
      reduced.shapes.block<3, 1>(3 * static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)) =
          fields[c](mesh->nodes[k]);
  solid->matrices = std::move(reduced);
  solid->mesh = std::move(mesh);
  return solid;
}

/// The field of a tension of 1 Pa along x.
inline spatial::Vector stretch(const spatial::Vector& p) {
  const double e = 1.0 / kBarMaterial.youngs_modulus, nu = kBarMaterial.poissons_ratio;
  return {e * p.x(), -nu * e * p.y(), -nu * e * p.z()};
}
/// The field of the stress xx = z [Pa]: pure bending (Timoshenko, Goodier, article 102).
inline spatial::Vector bend(const spatial::Vector& p) {
  const double e = 1.0 / kBarMaterial.youngs_modulus, nu = kBarMaterial.poissons_ratio;
  return {e * p.x() * p.z(), -nu * e * p.y() * p.z(),
          -0.5 * e * (p.x() * p.x() + nu * (p.z() * p.z() - p.y() * p.y()))};
}
/// The field of the stress xy = 1 Pa.
inline spatial::Vector shear(const spatial::Vector& p) {
  const double G = kBarMaterial.youngs_modulus / (2.0 * (1.0 + kBarMaterial.poissons_ratio));
  return {p.y() / G, 0.0, 0.0};
}

}  // namespace spoke::test
