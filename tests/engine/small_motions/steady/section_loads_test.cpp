// Compares loads of sections in equilibrium with the sensors of a simulation that stands there, and
// tests how far bodies bend.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/engine/small_motions/steady/blades.h"

namespace spoke {
namespace {

const std::string kFromEquilibrium = "[initial]\nstate = \"equilibrium\"\n";

/// A sensor where each of `bodies` bodies of a blade of unit length begins.
std::string cut_sensors(int bodies) {
  std::string text;
  for (int j = 0; j < bodies; ++j)
    text += "[[sensor]]\nname = \"cut" + std::to_string(j) +
            "\"\nquantity = \"section_force\"\nposition = " +
            std::to_string(static_cast<double>(j) / bodies) + '\n';
  return text;
}

double read_cut(const Simulation& simulation, std::size_t body, const std::string& component) {
  return simulation.sensor("blade1.cut" + std::to_string(body) + component);
}

/// Checks all loads of blade 1 against the sensors of the same scenario at its start.
void check_loads(const Scenario& scenario) {
  const EquilibriumResult found = solve_equilibrium(scenario);
  const Simulation simulation(scenario);
  const std::vector<SectionLoad>& loads = found.blades.at(0).loads;
  const double force = 1e-7 * loads.front().force.norm();
  const double moment = 1e-7 * (loads.front().moment.norm() + loads.front().force.norm());
  for (std::size_t j = 0; j < loads.size(); ++j) {
    CAPTURE(j);
    const auto check = [&](double expected, const std::string& component, double accepted) {
      CHECK(std::abs(read_cut(simulation, j, component) - expected) < accepted);
    };
    if (!scenario.space) {
      check(loads[j].force.x(), ".x", force);
      check(loads[j].force.y(), ".y", force);
      check(loads[j].moment.z(), ".moment", moment);
      continue;
    }
    const char* kAxes[] = {".x", ".y", ".z"};
    for (int c = 0; c < 3; ++c) {
      check(loads[j].force[c], std::string(".force") + kAxes[c], force);
      check(loads[j].moment[c], std::string(".moment") + kAxes[c], moment);
    }
  }
}

std::string with_frame(const std::string& frame) {
  return "[[blades]]\nlength = 1.0\nazimuth = 0.4\nbodies = 4\nelements = 2\nreference_frame = \"" +
         frame + "\"\n";
}

const std::string kTurning = "[hub.drive]\nkind = \"constant\"\nspeed = 2.0\n";
const std::string kEnd = "[integration]\nduration = 0.1\nstep = 1e-3\n";

Scenario make_plane(const std::string& frame) {
  return parse_scenario(kTurning + with_frame(frame) +
                            "density = 1.0\narea = 1.0\nsecond_moment = 1e-4\n"
                            "youngs_modulus = 1e4\n[[load]]\nforce = [0.3, 0.8]\n" +
                            cut_sensors(4) + kFromEquilibrium + kEnd,
                        "plane.toml");
}

/// Makes a twisted and swept blade.
Scenario make_space(const std::string& frame) {
  return parse_scenario("world = \"space\"\n" + kTurning + with_frame(frame) +
                            "[blades.sections]\nstation = [0.0, 1.0]\n"
                            "mass_per_length = [1.0, 0.5]\naxial_stiffness = [1e5, 1e5]\n"
                            "lag_stiffness = [3.0, 2.0]\nflap_stiffness = [1.5, 1.0]\n"
                            "torsion_stiffness = [1.0, 1.0]\ntwist = [0.7, 0.2]\n"
                            "sweep = [0.0, 0.1]\n[[load]]\nforce = [0.2, 0.5, -0.4]\n" +
                            cut_sensors(4) + kFromEquilibrium + kEnd,
                        "space.toml");
}

/// A beam that moments at its ends bend to a circle, or an arc of another angle, of 8 bodies; in
/// space with these strains.
Scenario make_circle(bool is_spatial, const std::string& more = "",
                     const std::string& beam = "elements = 1\nstrain = \"linear\"\n",
                     double angle = 2.0 * std::numbers::pi) {
  const std::string moment = std::to_string(angle);
  const std::string begin = std::string(is_spatial ? "world = \"space\"\n" : "") +
                            "[hub.drive]\nkind = \"fixed\"\n"
                            "[[blades]]\nlength = 1.0\nbodies = 8\nazimuth = 0.0\n" +
                            (is_spatial ? beam : "elements = 1\n");
  if (!is_spatial)
    return parse_scenario(begin +
                              "density = 1.0\narea = 1.0\nsecond_moment = 1e-8\n"
                              "youngs_modulus = 1e8\n[[load]]\nmoment = " +
                              moment + "\nframe = \"section\"\n" + more + kEnd,
                          "circle.toml");
  return parse_scenario(begin +
                            "[blades.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e8\n"
                            "lag_stiffness = 1.0\nflap_stiffness = 1.0\ntorsion_stiffness = 1.0\n"
                            "[[load]]\nmoment = [0.0, 0.0, " +
                            moment + "]\nframe = \"section\"\n" + more + kEnd,
                        "circle.toml");
}

}  // namespace

TEST_CASE("section loads: an equilibrium has those of the sensors") {
  for (const char* frame : {"clamped", "chord"}) {
    CAPTURE(frame);
    check_loads(make_plane(frame));
    check_loads(make_space(frame));
  }
}

TEST_CASE("section loads: tension is positive, m w^2 r at the root") {
  for (const Scenario& scenario :
       {test::make_planar({.radius = 0.5}), test::make_spatial({.radius = 0.5})}) {
    const SectionLoad root = solve_equilibrium(scenario, {.speed = 3.0}).blades.at(0).loads.at(0);
    CHECK(root.force.x() == doctest::Approx(9.0).epsilon(1e-6));
  }
}

TEST_CASE("equilibrium: a circle of bodies that bend by an eighth of it is right, and warned of") {
  for (const bool is_spatial : {false, true}) {
    CAPTURE(is_spatial);
    const EquilibriumResult result = solve_equilibrium(make_circle(is_spatial));
    const BladeEquilibrium& blade = result.blades.at(0);
    CHECK((blade.nodes.back() - blade.nodes.front()).norm() < 1e-5);
    REQUIRE(blade.bending.size() == 8);
    // Linear bending of a body by an angle a leaves its axis by a/2 of its length.
    for (const double ratio : blade.bending)
      CHECK(ratio == doctest::Approx(std::numbers::pi / 8.0).epsilon(1e-3));
    REQUIRE(result.warnings.size() == 1);
    CHECK(result.warnings[0].kind == WarningKind::linear_range);
    CHECK(result.warnings[0].text.starts_with("blade 1 / body 1 bends by "));
    CHECK(result.warnings[0].text.find("more than 10 %") != std::string::npos);
    CHECK(solve_modes(make_circle(is_spatial), {.count = 1}).equilibrium.warnings.size() == 1);
    // As in a run, the limit is that of the scenario.
    const std::string wide = "[limits]\ndeflection = 0.4\n", none = "[limits]\ndeflection = 0.0\n";
    CHECK(solve_equilibrium(make_circle(is_spatial, wide)).warnings.empty());
    CHECK(solve_equilibrium(make_circle(is_spatial, none)).warnings.empty());
  }
}

TEST_CASE("equilibrium: with nonlinear strains the deflection of elements is warned of") {
  const EquilibriumResult one = solve_equilibrium(make_circle(true, "", "elements = 1\n"));
  REQUIRE(one.warnings.size() == 1);
  CHECK(one.warnings[0].text.find("of the length of an element, more than 10 %") !=
        std::string::npos);
  // Half a circle by 16 elements, each of which leaves its axis by (1 - cos)/(angle) of its length.
  const EquilibriumResult half =
      solve_equilibrium(make_circle(true, "", "elements = 2\n", std::numbers::pi));
  CHECK(half.warnings.empty());
  const double angle = std::numbers::pi / 16.0;
  for (const double ratio : half.blades.at(0).bending)
    CHECK(ratio == doctest::Approx((1.0 - std::cos(angle)) / angle).epsilon(5e-3));
  const double width = (half.blades[0].nodes.back() - half.blades[0].nodes.front()).norm();
  CHECK(width == doctest::Approx(2.0 / std::numbers::pi).epsilon(5e-3));
}

}  // namespace spoke
