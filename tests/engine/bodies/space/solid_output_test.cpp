#include "engine/bodies/space/solid_output.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/engine/output/scene/solid_bars.h"

using namespace spoke;
using namespace spoke::test;
using space::NodeRecovery;
using spatial::ElementKind;

namespace {

std::shared_ptr<space::SolidConstants> make_bar(ElementKind kind) {
  const GridMesh grid{{4, 2, 2}, {1.0, 0.2, 0.1}, kind, {0.0, -0.1, -0.05}};
  return make_solid_of_fields(std::make_shared<spatial::SolidMesh>(make_grid_mesh(grid)),
                              {stretch, bend, shear});
}

}  // namespace

TEST_CASE("von Mises stress of simple states") {
  CHECK(space::calc_von_mises({3.0, 0.0, 0.0, 0.0, 0.0, 0.0}) == doctest::Approx(3.0));
  CHECK(space::calc_von_mises({5.0, 5.0, 5.0, 0.0, 0.0, 0.0}) == doctest::Approx(0.0));
  CHECK(space::calc_von_mises({0.0, 0.0, 0.0, 0.0, 2.0, 0.0}) ==
        doctest::Approx(2.0 * std::sqrt(3.0)));
  // Principal stresses 4, 1, -2: sqrt((9 + 9 + 36)/2).
  CHECK(space::calc_von_mises({4.0, 1.0, -2.0, 0.0, 0.0, 0.0}) == doctest::Approx(std::sqrt(27.0)));
}

TEST_CASE("a bar has F/A in tension, M z/I in bending and sqrt(3) of its shear stress") {
  for (const ElementKind kind : {ElementKind::tet10, ElementKind::hex20}) {
    const auto bar = make_bar(kind);
    const NodeRecovery recovery(*bar);
    REQUIRE(recovery.size() == static_cast<int>(bar->nodes.size()));
    // F = 1 kN on 0.2 x 0.1 m; M = 5 N m with I = 0.2 x 0.1^3 / 12.
    const double tension = 1000.0 / 0.02, per_z = 5.0 / (0.2 * 1e-3 / 12.0), sheared = 3e4;
    const double q_tension[] = {tension, 0.0, 0.0}, q_bending[] = {0.0, per_z, 0.0},
                 q_shear[] = {0.0, 0.0, sheared};
    for (int k = 0; k < recovery.size(); ++k) {
      const double z = bar->nodes[static_cast<std::size_t>(k)].z();
      CHECK(recovery.von_mises(k, q_tension) == doctest::Approx(tension).epsilon(1e-9));
      CHECK(std::abs(recovery.von_mises(k, q_bending) - per_z * std::abs(z)) < 1e-9 * per_z * 0.05);
      CHECK(recovery.von_mises(k, q_shear) ==
            doctest::Approx(std::sqrt(3.0) * sheared).epsilon(1e-9));
    }
    const NodeRecovery::Largest largest = recovery.largest_von_mises(q_bending);
    CHECK(largest.value == doctest::Approx(15000.0).epsilon(1e-9));  // 6 M / (b h^2)
    CHECK(std::abs(bar->nodes[static_cast<std::size_t>(largest.at)].z()) == doctest::Approx(0.05));
  }
}

TEST_CASE("some nodes have what all have, and a nodal solid what its reduced one has") {
  const auto bar = make_bar(ElementKind::tet10);
  const std::vector<int> some = {3, 17, 40};
  const NodeRecovery all(*bar), chosen(*bar, some);
  const double q[] = {1e5, -2e6, 3e4};
  // The same displacements as coordinates of all nodes.
  space::SolidConstants nodal = *bar;
  const Eigen::VectorXd u = bar->reduced()->shapes * Eigen::Map<const Eigen::VectorXd>(q, 3);
  space::NodalSolid matrices;
  matrices.Xi.resize(u.size(), u.size());
  matrices.Xi.setIdentity();
  nodal.coordinates = static_cast<int>(u.size());
  nodal.matrices = matrices;
  const NodeRecovery other(nodal, some);
  CHECK(!other.is_reduced());
  for (int k = 0; k < chosen.size(); ++k) {
    const int node = some[static_cast<std::size_t>(k)];
    CHECK((chosen.displacement(k, q) - all.displacement(node, q)).norm() == 0.0);
    CHECK((other.displacement(k, u.data()) - u.segment<3>(3 * node)).norm() == 0.0);
    CHECK(chosen.von_mises(k, q) == doctest::Approx(all.von_mises(node, q)).epsilon(1e-12));
    CHECK(other.von_mises(k, u.data()) == doctest::Approx(all.von_mises(node, q)).epsilon(1e-9));
  }
}
