// Strains of second order in the plane against closed forms, and against the same mechanics said in
// another way: see nonlinear_strain_test.cpp for beams in space.

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/engine/small_motions/vibration/critical_load.h"

namespace spoke::in_plane {
namespace {

using doctest::Approx;

/// How a beam is cut: bodies, and elements of each.
struct Cut {
  int bodies, elements;
};
constexpr Cut kOneOfEight{1, 8}, kFourOfFour{4, 4};

/// A beam of 1 m and 1 kg on a hub: its stiffness EA and EI, its drive, and all else.
std::string make_beam(const Cut& cut, double EA, double EI, const std::string& drive,
                      const std::string& rest, const std::string& strain = "nonlinear") {
  // Of an area of 1 m^2.
  return "[hub.drive]\n" + drive + "\n[integration]\nstep = 1e-3\nduration = 1\n[blade]\ncount = " +
         "1\nlength = 1\nstrain = \"" + strain + "\"\nbodies = " + std::to_string(cut.bodies) +
         "\nelements = " + std::to_string(cut.elements) +
         "\ndensity = 1\narea = 1\nyoungs_modulus = " + std::to_string(EA) +
         "\nsecond_moment = " + std::to_string(EI / EA * 1e9) + "e-9\n" + rest;
}
const std::string kFixed = "kind = \"fixed\"";

double find_lag(const std::string& text, std::size_t number = 0) {
  const ModesResult result = solve_modes(parse_scenario(text, "beam.toml"));
  REQUIRE(result.modes.size() > number);
  return result.modes[number].frequency;
}

std::string push(const std::string& frame) {
  return "[[load]]\nname = \"push\"\nforce = [-1, 0]\nframe = \"" + frame + "\"\n";
}

}  // namespace

TEST_CASE("a column in the plane buckles as Euler's, and flutters as Beck's") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const auto& [cut, euler, beck] :
         {std::tuple(kOneOfEight, 2.5e-6, 2e-4), {kFourOfFour, 5e-7, 3e-5}}) {
      const auto column = [&, cut = cut](const std::string& load) {
        return make_beam(cut, 1e7, 1.0, kFixed,
                         "reference_frame = \"" + std::string(name_of(frame)) + "\"\n" + load);
      };
      CHECK(test::find_critical_load(column(push("inertial")), 5.0) ==
            Approx(2.4674011).epsilon(euler));
      CHECK(test::find_critical_load(column(push("section")), 30.0) ==
            Approx(20.0509).epsilon(beck));
    }
}

TEST_CASE("tension changes the frequencies of a beam in the plane, whatever makes it") {
  const std::string turning = "kind = \"constant\"\nspeed = 12.0";
  const std::string weight = "[gravity]\nacceleration = [9.81, 0]\n";
  const std::string cable =
      "[[blade.loop]]\nname = \"cable\"\nkind = \"distance\"\nfrom = {}\nto = \"hub\"\nlength = "
      "0.1\nstiffness = 10\n";
  for (const auto& [cut, tolerance] :
       {std::pair(kOneOfEight, 2e-4), std::pair(kFourOfFour, 3e-5)}) {
    // By rotation, by its own weight, and by a soft cable from tip to root that pulls with 9 N:
    // the beam's differential equations.
    CHECK(find_lag(make_beam(cut, 1e7, 1.0, turning, "")) == Approx(5.4272).epsilon(tolerance));
    CHECK(find_lag(make_beam(cut, 1e7, 2.0, kFixed, weight)) == Approx(6.3325).epsilon(tolerance));
    const std::string cabled = make_beam(cut, 1e7, 1.0, kFixed, cable);
    CHECK(find_lag(cabled) == Approx(1.46496).epsilon(tolerance));
    CHECK(find_lag(cabled, 1) == Approx(14.917).epsilon(tolerance));
  }
}

TEST_CASE("a clamped beam in the plane stretches as it bends") {
  const auto solve = [](const Cut& cut) {
    return solve_equilibrium(parse_scenario(
        make_beam(cut, 1e4, 1.0, kFixed,
                  "[[blade.loop]]\nname = \"wall\"\nkind = \"fixed\"\nfrom = {}\nto = { body = "
                  "\"hub\", point = [1, 0] }\n[[distributed_load]]\nframe = "
                  "\"inertial\"\nforce_per_length = [0, 20]\n"),
        "beam.toml"));
  };
  for (const auto& [cut, middle] : {std::pair(kOneOfEight, 4), std::pair(kFourOfFour, 9)}) {
    const EquilibriumResult found = solve(cut);
    const BladeEquilibrium& beam = found.blades.front();
    // By a prototype of finite rotations; von Karman's theory has 0.03207 m and 25.13 N.
    CHECK(beam.nodes[static_cast<std::size_t>(middle)].y() == Approx(0.03215).epsilon(1e-3));
    REQUIRE(beam.loops.size() == 1);
    CHECK(beam.loops.front().force.x() == Approx(24.95).epsilon(1e-3));
  }
}

TEST_CASE("strains in the plane tell the load of a section of a beam that is bent far") {
  const std::string pull =
      "[initial]\nstate = \"equilibrium\"\n[[load]]\nframe = \"inertial\"\nforce = [40, 30]\n";
  const Simulation simulation(
      parse_scenario(make_beam({1, 8}, 1e5, 20.0, kFixed, pull), "beam.toml"));
  const Marker middle{0, 0, 0.4375}, tip{0, 0, 1.0};  // of the fourth element
  const MarkerState at = simulation.marker(middle);
  const Eigen::Vector3d force(40.0, 30.0, 0.0);
  const Eigen::Vector3d expected = at.rotation.transpose() * force;
  const Eigen::Vector3d arm = simulation.marker(tip).position - at.position;
  const double moment = arm.x() * force.y() - arm.y() * force.x();
  CHECK(at.rotation(1, 0) > 0.2);
  const Wrench found = simulation.section_force(middle);
  CHECK((found.force - expected).norm() < 1e-2 * force.norm());
  CHECK(found.moment.z() == Approx(moment).epsilon(1e-2));
}

TEST_CASE("a small mass with inertia in the plane turns with its section and makes no moment") {
  const std::string mass = "[[blade.point_mass]]\nposition = 0.6\nmass = 0.3\ninertia = 0.02\n";
  const std::string turning = "kind = \"constant\"\nspeed = 12.0";
  const double linear = find_lag(make_beam({8, 4}, 1e7, 1.0, turning, mass, "linear"));
  CHECK(find_lag(make_beam(kOneOfEight, 1e7, 1.0, turning, mass)) == Approx(linear).epsilon(3e-3));
  CHECK(find_lag(make_beam(kFourOfFour, 1e7, 1.0, turning, mass)) == Approx(linear).epsilon(3e-4));
}

TEST_CASE("a beam in the plane that is swung against a stay moves alike, however it is cut") {
  const auto run = [](const Cut& cut) {
    const std::string swing =
        "kind = \"table\"\ntime = [0, 0.1, 0.3, 0.4, 1]\nspeed = [0, 3, -3, 0, 0]";
    const std::string stay =
        "[[blade.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = {}\nto = { body = "
        "\"mount\", point = [0.5, -1] }\nstiffness = 400\ndamping = 0.2\n[damping]\n"
        "stiffness_factor = 1e-4\n";
    Simulation simulation(parse_scenario(make_beam(cut, 1e5, 20.0, swing, stay), "beam.toml"));
    std::vector<double> tips;
    for (int n = 0; n < 400; ++n) {
      simulation.step();
      if (n % 10 == 0)
        for (const char* c : {"blade1.tip.x", "blade1.tip.y"}) tips.push_back(simulation.sensor(c));
    }
    return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(tips.data(), std::ssize(tips)));
  };
  const Eigen::VectorXd one = run({1, 8}), size = one.cwiseAbs();
  CHECK(size.maxCoeff() > 0.2);
  for (const Cut& cut : {Cut{2, 4}, Cut{4, 2}, Cut{8, 1}})
    CHECK((run(cut) - one).cwiseAbs().maxCoeff() < 3e-4 * size.maxCoeff());
}

}  // namespace spoke::in_plane
