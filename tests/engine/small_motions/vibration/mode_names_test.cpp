// Tests that modes of equal roots are told apart by one rule, whatever a solver finds, and that
// there are as many modes as asked for.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/campbell.h"
#include "engine/modes.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "models/scenario.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

/// A round shaft along the axis of rotation with a thin disc at its end.
Scenario make_round_shaft(double angle) {
  return parse_scenario(
      "world = \"space\"\n[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
      "[[subsystem]]\nname = \"shaft\"\n"
      "[[subsystem.body]]\nname = \"rod\"\nkind = \"beam\"\nlength = 0.5\nbodies = 1\n"
      "elements = 4\n"
      "[subsystem.body.sections]\nmass_per_length = 0.01\nlag_stiffness = 1000.0\n"
      "flap_stiffness = 1000.0\nlag_inertia = 1e-9\nflap_inertia = 1e-9\n"
      "axial_stiffness = 1e9\ntorsion_stiffness = 1e7\n"
      "[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 2.0\n"
      "inertia = [0.05, 0.03, 0.03]\n"
      "[[subsystem.joint]]\nname = \"root\"\nparent = \"hub\"\nchild = \"rod\"\n"
      "kind = \"fixed\"\norientation = [0.0, -1.5707963267948966, 0.0]\n"
      "[[subsystem.joint]]\nname = \"end\"\nparent = \"rod\"\nchild = \"disc\"\n"
      "kind = \"fixed\"\norientation = [" +
          std::to_string(angle) + ", 0.0, 0.0]\n[integration]\nduration = 1.0\n",
      "shaft.toml");
}

std::vector<std::string> list_names(const ModesResult& result) {
  std::vector<std::string> names;
  for (const Mode& mode : result.modes) names.push_back(mode.name);
  return names;
}

/// Blades on a hub that turns freely, which does not feel their flapping.
Scenario make_driven(int blades) {
  Scenario scenario = test::make_spatial({.bodies = 2, .elements = 2});
  for (double& value : scenario.space->blades[0].beam.sections.lag_stiffness) value = 5.0;
  for (int b = 1; b < blades; ++b) {
    scenario.space->blades.push_back(scenario.space->blades[0]);
    scenario.space->blades.back().azimuth += b * 2.0 * std::acos(-1.0) / blades;
  }
  scenario.space->hub.drive = FreeDrive{};
  return scenario;
}

}  // namespace

TEST_CASE("mode names: a pair of equal stiffnesses is flap and lag, at rest along these") {
  // The orientation of the disc changes nothing but round-off.
  for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
    CAPTURE(angle);
    const ModesResult result = solve_modes(make_round_shaft(angle), {.count = 4});
    CHECK(list_names(result) == std::vector<std::string>{"flap 1", "lag 1", "flap 2", "lag 2"});
    CHECK(result.modes[0].frequency == doctest::Approx(result.modes[1].frequency).epsilon(1e-9));
    // The root of the shaft has its z along -x or x of the hub, its y along y of the hub.
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3cd tip = result.modes[k].shape[0].back();
      CHECK(std::abs(tip[k % 2 == 0 ? 1 : 0]) < 1e-6 * std::abs(tip[k % 2 == 0 ? 0 : 1]));
    }
    CHECK(list_names(solve_modes(make_round_shaft(angle), {.count = 1}))[0] == "flap 1");
  }
}

TEST_CASE("mode names: the whirls of a pair are flap and lag in ascending order") {
  for (const double speed : {1.0, 20.0, 60.0}) {
    CAPTURE(speed);
    for (const double angle : {0.0, 0.3, 2.5})
      CHECK(list_names(
                solve_modes(make_round_shaft(angle), {.state = {.speed = speed}, .count = 4})) ==
            std::vector<std::string>{"flap 1", "lag 1", "flap 2", "lag 2"});
  }
}

TEST_CASE("mode names: blades that do not feel one another are named by patterns") {
  for (const double speed : {0.0, 3.0})
    for (const int count : {2, 3, 4, 6}) {
      CAPTURE(speed);
      CAPTURE(count);
      std::vector<std::string> names;
      for (const Mode& mode :
           solve_modes(make_driven(3), {.state = {.speed = speed}, .count = count}).modes)
        if (mode.kind == "flap") names.push_back(mode.name);
      const std::vector<std::string> known = {"collective flap 1", "cosine flap 1", "sine flap 1"};
      for (std::size_t k = 0; k < std::min(known.size(), names.size()); ++k)
        CHECK(names[k] == known[k]);
      CHECK_FALSE(names.empty());
    }
}

TEST_CASE("modes: without a number there are as many as the model has") {
  const Scenario top = test::read_shipped("heavy_top");
  CHECK(solve_modes(top, {.state = {.speed = 0.0}}).modes.size() == 3);
  CHECK(solve_modes(top, {.state = {.speed = 3.0}}).modes.size() == 3);
  CHECK(solve_campbell(top, {.speeds = {1.0, 2.0, 3.0}}).branches.size() <= 3);
  CHECK(solve_modes(test::make_planar({.bodies = 1, .elements = 1})).modes.size() == 3);
  CHECK(solve_modes(test::make_planar({})).modes.size() == 10);
  CHECK(solve_campbell(test::make_planar({}), {.speeds = {0.0, 1.0}}).branches.size() == 6);
  // More than there are is said.
  const ModesResult more = solve_modes(top, {.state = {.speed = 0.0}, .count = 4});
  CHECK(more.modes.size() == 3);
  CHECK(more.notes == std::vector<std::string>{"4 modes are asked for, top has 3"});
  CHECK(solve_campbell(top, {.speeds = {0.0, 1.0}, .count = 4}).branches.size() <= 3);
  CHECK(test::message_of([&] {
          solve_campbell(top, {.speeds = {0.0, 1.0}, .count = 0});
        }) == "0 modes, expected 1 or more");
}

TEST_CASE("mode names: what creeps back is overdamped, and a kind of its own") {
  // J s^2 + c s + k = 0 with J = 1/3 + 1e-8: real roots at 4 k J < c^2.
  const Scenario blade =
      test::make_spatial({.bodies = 1,
                          .elements = 2,
                          .joint = "[[blades.joint]]\nname = \"hinge\"\nkind = \"revolute\"\naxis "
                                   "= [0, 1, 0]\nstation = 0.0\n"
                                   "stiffness = 0.01\ndamping = 0.3\n"});
  const ModesResult found = solve_modes(blade, {.state = {0.0}, .count = 6});
  std::vector<double> real;
  bool has_lag_1 = false;
  for (const Mode& mode : found.modes) {
    const bool creeps = mode.name.starts_with("overdamped ");
    CHECK(creeps == (mode.frequency == 0.0));
    CHECK(creeps == mode.kind.starts_with("overdamped "));
    if (creeps) real.push_back(mode.eigenvalue.real());
    has_lag_1 = has_lag_1 || mode.name == "lag 1";
  }
  REQUIRE(real.size() >= 2);
  CHECK(real[0] ==
        doctest::Approx((-0.3 + std::sqrt(0.09 - 4.0 * 0.01 / 3.0)) * 1.5).epsilon(0.02));
  CHECK(has_lag_1);
}

TEST_CASE("mode names: a vibration is numbered behind overdamped ones of its kind") {
  vibration::Numbering numbering;
  numbering.count_root("flap");  // the slow root; the fast one is not among the lowest
  Mode mode;
  numbering.name("flap", mode);
  CHECK(mode.name == "flap 2");
  numbering.count_root("lag");
  numbering.count_root("lag");
  numbering.name("lag", mode);
  CHECK(mode.name == "lag 2");
  numbering.name("overdamped lag", mode);
  CHECK(mode.name == "overdamped lag 1");
  CHECK(vibration::kind_with_damping("flap", {-2.0, 0.05}, 0.05) == "overdamped flap");
  CHECK(vibration::kind_with_damping("flap", {-2.0, 1.0}, 1.0) == "flap");
  CHECK(vibration::kind_with_damping("flap", {2.0, 0.0}, 0.0) == "flap");  // diverges
}

}  // namespace spoke
