// Strains of second order against closed forms and against the same mechanics said in another way:
// whatever makes the tension or the moment in a beam, its small motions feel it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/engine/small_motions/vibration/critical_load.h"

namespace spoke {
namespace {

using doctest::Approx;

/// How a beam is cut: bodies, and elements of each.
struct Cut {
  int bodies, elements;
};
constexpr Cut kOneOfEight{1, 8}, kFourOfFour{4, 4};

std::string text_of(const Cut& cut) {
  return "kind = \"beam\", strain = \"nonlinear\", bodies = " + std::to_string(cut.bodies) +
         ", elements = " + std::to_string(cut.elements) + ", ";
}

/// Returns the frequency of the first mode of a kind [rad/s].
double find_frequency(const std::string& text, const std::string& name) {
  const ModesResult result = solve_modes(parse_scenario(text, "beam.toml"));
  for (const Mode& mode : result.modes)
    if (mode.name == name) return mode.frequency;
  FAIL("no mode " << name);
  return 0.0;
}

/// A beam of 1 m on a hub at 10 rad/s that points inward from 1.5 m, folded by a joint or mounted
/// so.
std::string make_folded(const Cut& cut, bool by_joint) {
  const std::string joint =
      by_joint
          ? "{ parent = \"arm\", child = \"b\", kind = \"revolute\", axis = [0, 0, 1], offset = "
            "[1.5, 0, 0], motion = { constant = 3.141592653589793 } }"
          : "{ parent = \"arm\", child = \"b\", kind = \"fixed\", offset = [1.5, 0, 0], "
            "orientation = [0, 0, 3.141592653589793] }";
  return "world = \"space\"\n[hub.drive]\nkind = \"constant\"\nspeed = 10.0\n[[subsystem]]\nname "
         "= \"s\"\nbody = [ { name = \"arm\", kind = \"rigid\", mass = 1, inertia = 1.0 }, { name "
         "= \"b\", " +
         text_of(cut) +
         "length = 1.0, sections = { mass_per_length = 1.0, axial_stiffness = 1e7, flap_stiffness "
         "= 10.0, lag_stiffness = 40.0, torsion_stiffness = 1e3, flap_inertia = 1e-7, lag_inertia "
         "= 1e-7 } } ]\njoint = [ { parent = \"hub\", child = \"arm\", kind = \"fixed\" }, " +
         joint + " ]\n[integration]\nduration = 1\n";
}

/// A cantilever, with a soft cable from its tip to its root that pulls with 9 N.
std::string make_cabled(const Cut& cut) {
  return "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[[subsystem]]\nname = \"c\"\nbody = [ "
         "{ name = \"b\", " +
         text_of(cut) +
         "length = 1.0, sections = { mass_per_length = 1.0, axial_stiffness = 1e7, flap_stiffness "
         "= 1.0, lag_stiffness = 3.0, torsion_stiffness = 10.0, flap_inertia = 1e-9, lag_inertia = "
         "1e-9 } } ]\njoint = [ { parent = \"hub\", child = \"b\", kind = \"fixed\" } ]\nloop = [ "
         "{ "
         "name = \"cable\", kind = \"distance\", from = { body = \"b\" }, to = { body = \"hub\" }, "
         "length = 0.1, stiffness = 10.0 } ]\n[integration]\nduration = 1\n";
}

/// A cantilever of soft flap and torsion with a load at its tip along the stiff direction, or
/// along its axis.
std::string make_loaded(const Cut& cut, const std::string& force) {
  return "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[blade]\ncount = 1\nlength = "
         "1.0\nstrain = \"nonlinear\"\nbodies = " +
         std::to_string(cut.bodies) + "\nelements = " + std::to_string(cut.elements) +
         "\n[blade.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e9\nflap_stiffness = "
         "100.0\nlag_stiffness = 1e7\ntorsion_stiffness = 80.0\n[[load]]\nname = \"push\"\nframe = "
         "\"inertial\"\nforce = " +
         force + "\n[integration]\nduration = 1\n";
}

/// A turning beam whose centres lie on its axis, or 0.3 m beside it.
std::string make_beside(const Cut& cut, double offset) {
  std::ostringstream text;
  text << "world = \"space\"\n[hub.drive]\nkind = \"constant\"\nspeed = 15.0\n[[subsystem]]\nname "
          "= \"b\"\nbody = [ { name = \"beam\", "
       << text_of(cut)
       << "length = 20.0, sections = { mass_per_length = 25.0, axial_stiffness = 1e9, "
          "flap_stiffness = 2e7, lag_stiffness = 8e7, torsion_stiffness = 5e6, flap_inertia = 0.5, "
          "lag_inertia = 5.0";
  for (const char* centre : {"mass_center", "tension_center", "shear_center"})
    text << ", " << centre << " = [[" << -offset << ", 0], [" << -offset << ", 0]]";
  text << " } } ]\njoint = [ { parent = \"hub\", child = \"beam\", kind = \"fixed\", offset = [1, "
       << offset << ", 0] } ]\n[integration]\nduration = 1\n";
  return text.str();
}

/// A beam on a table that turns at 30 rad/s, by the hub or by a joint; released under its weight.
std::string make_turned(const Cut& cut, bool by_joint) {
  const std::string table = "{ name = \"table\", kind = \"rigid\", mass = 1, inertia = 1.0 }, ";
  const std::string motor =
      "{ parent = \"hub\", child = \"table\", kind = \"revolute\", axis = [0, 0, 1], motion = { "
      "time = [0, 10], value = [0, 300.0] } }, ";
  return "world = \"space\"\n[hub.drive]\n" +
         std::string(by_joint ? "kind = \"fixed\"\n" : "kind = \"constant\"\nspeed = 30.0\n") +
         "[gravity]\nacceleration = [0, 0, -0.5]\n[[subsystem]]\nname = \"s\"\nbody = [ " +
         (by_joint ? table : "") + "{ name = \"b\", " + text_of(cut) +
         "length = 1.0, sections = { mass_per_length = 1.0, axial_stiffness = 1e7, flap_stiffness "
         "= 10.0, lag_stiffness = 1e4, torsion_stiffness = 1e3, flap_inertia = 1e-7, lag_inertia = "
         "1e-7 } } ]\njoint = [ " +
         (by_joint ? motor : "") + "{ parent = \"" + (by_joint ? "table" : "hub") +
         "\", child = \"b\", kind = \"fixed\" } ]\n[integration]\nstep = 1e-3\nduration = "
         "0.5\n[output]\ninterval = 1e-3\n";
}

double find_lowest_tip(const std::string& text) {
  Simulation simulation(parse_scenario(text, "beam.toml"));
  double lowest = 0.0;
  for (int n = 0; n < 500; ++n) {
    simulation.step();
    lowest = std::min(lowest, simulation.sensor("s.tip.z"));
  }
  return lowest;
}

}  // namespace

TEST_CASE("a beam that a joint has folded inward is as soft as one that is mounted so") {
  // The first flap by the beam's differential equation, whose tension is compression here.
  for (const auto& [cut, tolerance] :
       {std::pair(kOneOfEight, 5e-4), std::pair(kFourOfFour, 1e-4)}) {
    const double by_joint = find_frequency(make_folded(cut, true), "flap 1");
    CHECK(by_joint == Approx(2.6595).epsilon(tolerance));
    CHECK(by_joint == Approx(find_frequency(make_folded(cut, false), "flap 1")).epsilon(1e-8));
  }
}

TEST_CASE("the force of a loop along a cantilever changes its frequency") {
  CHECK(find_frequency(make_cabled(kOneOfEight), "flap 1") == Approx(1.46496).epsilon(2e-4));
  CHECK(find_frequency(make_cabled(kFourOfFour), "flap 1") == Approx(1.46496).epsilon(5e-5));
}

TEST_CASE("a cantilever buckles sideways and along its axis, within one body too") {
  // Lateral: 4.0126 sqrt(EI GJ)/L^2 (Timoshenko); Euler: pi^2/4 EI/L^2.
  const double lateral = 4.0126 * std::sqrt(100.0 * 80.0);
  CHECK(test::find_critical_load(make_loaded(kOneOfEight, "[0, 1, 0]"), 1000.0) ==
        Approx(lateral).epsilon(5e-3));
  CHECK(test::find_critical_load(make_loaded(kFourOfFour, "[0, 1, 0]"), 1000.0) ==
        Approx(lateral).epsilon(1.3e-3));
  CHECK(test::find_critical_load(make_loaded(kOneOfEight, "[-1, 0, 0]"), 500.0) ==
        Approx(100.0 * 2.4674011).epsilon(5e-6));
}

TEST_CASE("a turning beam has the torsion of its centres, wherever its axis lies") {
  const double at_centre = find_frequency(make_beside(kFourOfFour, 0.0), "torsion 1");
  CHECK(at_centre == Approx(2.0 * 3.14159265 * 12.237).epsilon(4e-4));
  CHECK(find_frequency(make_beside(kFourOfFour, 0.3), "torsion 1") ==
        Approx(at_centre).epsilon(1e-4));
  CHECK(find_frequency(make_beside(kOneOfEight, 0.3), "torsion 1") ==
        Approx(at_centre).epsilon(5e-3));
}

TEST_CASE("a beam that a joint turns sags as one that the hub turns") {
  const double by_hub = find_lowest_tip(make_turned(kFourOfFour, false));
  CHECK(by_hub == Approx(-1.29e-3).epsilon(3e-3));
  CHECK(find_lowest_tip(make_turned(kFourOfFour, true)) == Approx(by_hub).epsilon(1e-6));
  CHECK(find_lowest_tip(make_turned(kOneOfEight, true)) == Approx(by_hub).epsilon(3e-3));
}

}  // namespace spoke
