// Compares equilibria and frequencies of blades in space with published values and with solutions
// by other methods.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using Eigen::Vector3d;

/// One clamped blade along x: `sections` and `more` are TOML.
Scenario make_blade(double length, int bodies, int elements, const std::string& sections,
                    const std::string& more) {
  return parse_scenario(
      "world = \"space\"\n[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
      "[[blades]]\nazimuth = 0.0\nlength = " +
          std::to_string(length) + "\nbodies = " + std::to_string(bodies) +
          "\nelements = " + std::to_string(elements) + "\n[blades.sections]\n" + sections + more +
          "[integration]\nduration = 1.0\n",
      "blade.toml");
}

Vector3d find_tip(const Scenario& scenario, double speed) {
  return solve_equilibrium(scenario, {.speed = speed}).blades.at(0).nodes.back();
}

/// A dimensionless blade: length, mass and bending stiffness 1, hardly extensible, thin.
const std::string kUnit =
    "mass_per_length = 1.0\naxial_stiffness = 1e6\nlag_stiffness = 1.0\nflap_stiffness = 1.0\n"
    "torsion_stiffness = 0.77\nlag_inertia = 1e-9\nflap_inertia = 1e-9\n";

}  // namespace

TEST_CASE("published: a twisted cantilever under a large force at its tip") {
  // Wang et al. 2017, Wind Energy 20, doi 10.1002/we.2101; values of BeamDyn's regression test
  // bd_static_twisted_with_k1 of OpenFAST, 2022. A quarter turn from root to tip.
  const Vector3d known(-1.14114462, -1.71810805, -3.59245231);
  const auto displace = [](int bodies) {
    const Scenario scenario = make_blade(
        10.0, bodies, 2,
        "station = [0.0, 10.0]\nmass_per_length = [1.0, 1.0]\naxial_stiffness = [25e9, 25e9]\n"
        "flap_shear_stiffness = [8.2604167e9, 8.2604167e9]\n"
        "lag_shear_stiffness = [8.2604167e9, 8.2604167e9]\n"
        "flap_stiffness = [0.520833e9, 0.520833e9]\n"
        "lag_stiffness = [0.130208333e9, 0.130208333e9]\n"
        "torsion_stiffness = [0.141872656e9, 0.141872656e9]\n"
        "twist = [0.0, 1.5707963267948966]\n",
        "[[load]]\nforce = [0.0, 0.0, -4e6]\n");
    return solve_equilibrium(scenario).blades.at(0).tip_displacement;
  };
  const Vector3d coarse = displace(8), middle = displace(16), fine = displace(32);
  for (int i = 0; i < 3; ++i) CHECK(fine[i] == doctest::Approx(known[i]).epsilon(1e-3));
  CHECK((coarse - middle).norm() / (middle - fine).norm() > 3.0);  // order 2: 4 in the limit
}

TEST_CASE("published: steady rotation with a flap of half the length") {
  // Legendre-Galerkin solution of the inextensible elastica in rotation, error below 1e-7.
  struct Known {
    const char* load;
    Vector3d tip;
  };
  for (const Known& known : {Known{"[0.0, 0.0, 20.0]", {0.846496699, 0.0, 0.511126803}},
                             Known{"[0.0, 10.0, 20.0]", {0.68658103, 0.52092083, 0.45523851}}}) {
    const auto calc_tip = [&](int bodies) {
      const Scenario scenario = make_blade(
          1.0, bodies, 2, kUnit,
          "[[distributed_load]]\nframe = \"hub\"\nforce_per_length = " + std::string(known.load) +
              "\n");
      return find_tip(scenario, 6.0);
    };
    const Vector3d coarse = calc_tip(10), fine = calc_tip(20);
    const double error = (fine - known.tip).norm();
    CHECK(error < 1.28e-3);                            // 5e-4 with 32 bodies
    CHECK((coarse - known.tip).norm() / error > 3.5);  // order 2
  }
}

TEST_CASE("published: frequencies of a hanging cantilever") {
  // Legendre-Galerkin at g rhoA L^3/EI = 20.
  const Scenario scenario =
      make_blade(1.0, 4, 4, kUnit, "[gravity]\nacceleration = [20.0, 0.0, 0.0]\n");
  const ModesResult result = solve_modes(scenario, {.state = {.speed = 0.0}, .count = 4});
  for (const std::size_t k : {0, 1})
    CHECK(result.modes.at(k).frequency == doctest::Approx(6.59777204).epsilon(2e-5));
  for (const std::size_t k : {2, 3})
    CHECK(result.modes.at(k).frequency == doctest::Approx(25.64465812).epsilon(2e-5));
}

TEST_CASE("published: torsion of a flat section at speed") {
  // Propeller moments alone: with a small radius of gyration tension stiffens torsion by 1e-5.
  const double GJ = 0.004, flat = 2e-4, thin = 2e-5;
  const Scenario scenario = make_blade(
      1.0, 4, 8,
      "mass_per_length = 1.0\naxial_stiffness = 1e9\nlag_stiffness = 10.0\nflap_stiffness = 10.0\n"
      "torsion_stiffness = 0.004\nlag_inertia = 2e-4\nflap_inertia = 2e-5\n",
      "");
  const double at_rest = 0.5 * std::acos(-1.0) * std::sqrt(GJ / (flat + thin));
  for (const double speed : {0.0, 5.0, 10.0}) {
    const ModesResult result = solve_modes(scenario, {.state = {.speed = speed}, .count = 3});
    const auto torsion = std::find_if(result.modes.begin(), result.modes.end(),
                                      [](const Mode& mode) { return mode.name == "torsion 1"; });
    REQUIRE(torsion != result.modes.end());
    const double square = at_rest * at_rest + speed * speed * (flat - thin) / (flat + thin);
    CHECK(torsion->frequency == doctest::Approx(std::sqrt(square)).epsilon(3e-4));
  }
}

}  // namespace spoke
