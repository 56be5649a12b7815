// Motions whose course is known: a top, and a beam that vibrates while it turns.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

// By a general solver of order 8 to 1e-8.
const Eigen::Vector3d kCentreAt1{0.17334396, 0.64008859, -0.74849079};

double top_error(const Method& method) {
  Run<Space> run(make_system(*read_model("heavy_top.toml").space), {method});
  run.advance_for(1.0);
  const space::Position centre =
      space::Position(run.sample(0).tip) + run.context.system.subsystems[0].tip;
  return (centre - space::Position(kCentreAt1)).norm();
}

}  // namespace

TEST_CASE("a heavy top moves as it should") {
  const double whole = top_error(Rk4{1e-3}), half = top_error(Rk4{5e-4});
  CHECK(half < 1e-5);
  CHECK(whole / half > 13.0);
  const double alpha = top_error(make_generalized_alpha(1.0, 1e-3));
  const double alpha_half = top_error(make_generalized_alpha(1.0, 5e-4));
  CHECK(alpha_half < 0.1);
  CHECK(alpha / alpha_half > 3.5);
}

TEST_CASE("a mass that hangs within a body puts its tension on the elements inboard of it alone") {
  // As a body of its own at an inner node, and as a point mass of the beam: the same blade.
  const std::string beam = R"(
[[subsystem]]
name = "boom"
[[subsystem.body]]
name = "beam"
kind = "beam"
length = 1.0
bodies = 1
elements = 4
sections = { mass_per_length = 1.0, axial_stiffness = 1e5, lag_stiffness = 2.0, flap_stiffness = 1.0, torsion_stiffness = 1.0 }
)";
  const std::string joint =
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"beam\"\nkind = \"fixed\"\n";
  const std::string mass = R"(
[[subsystem.body]]
name = "mass"
kind = "rigid"
mass = 2.0
inertia = [1e-3, 1e-3, 1e-3]
[[subsystem.joint]]
parent = "beam"
station = 0.5
child = "mass"
kind = "fixed"
)";
  const std::string point =
      "[[subsystem.body.point_mass]]\nposition = 0.5\nmass = 2.0\ninertia = [1e-3, 1e-3, 1e-3]\n";
  const std::string hub = "[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 12.0\n";
  const std::string load =
      "[[load]]\nsubsystem = \"boom\"\nbody = \"beam\"\nforce = [0, 0.3, 0.5]\n";
  const auto tip = [&](const std::string& bodies) {
    Scenario scenario = parse_scenario(make_text(hub, bodies, load), "test.toml");
    scenario.integration.step = 2e-3;
    scenario.integration.duration = 0.3;
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, 0});
    simulation.run_until(0.3);
    const MarkerState end = simulation.marker({0, 0, 1.0});
    return Eigen::Vector3d(end.deflection - end.foreshortening);
  };
  const Eigen::Vector3d hung = tip(beam + joint + mass), carried = tip(beam + point + joint);
  CAPTURE(hung.transpose());
  CAPTURE(carried.transpose());
  CHECK(std::abs(carried.z()) > 1e-3);
  CHECK((hung - carried).norm() < 1e-2 * carried.norm());
}

TEST_CASE("an axis that begins beside the root moves as one behind a rigid arm") {
  const auto blade = [](const std::string& shape) {
    return "[blade]\ncount = 2\nlength = 6.0\nbodies = 2\nelements = 3\n[blade.sections]\nstation "
           "= "
           "[0.0, 2.0, 6.0]\n" +
           shape +
           "mass_per_length = 4.0\naxial_stiffness = 1e7\nflap_stiffness = 2e4\nlag_stiffness = "
           "6e4\ntorsion_stiffness = 1e4\nflap_inertia = 0.01\nlag_inertia = 0.05\n";
  };
  const std::string beside = blade("sweep = [0.3, 0.35, 0.7]\nprebend = [-0.2, -0.1, 0.3]\n");
  const std::string behind =
      blade("sweep = [0.0, 0.05, 0.4]\nprebend = [0.0, 0.1, 0.5]\n") +
      "[[blade.joint]]\nstation = 0.0\nkind = \"fixed\"\noffset = [0.0, 0.3, -0.2]\n";
  for (const std::string& hub : {kTurnedHub, kDrivenHub}) {
    const RunSetup setup{make_generalized_alpha(0.8, 2e-3), 1e-9};
    Run<Space> a(make_system(parse_model(make_text(hub, beside, kGravity))), setup);
    Run<Space> b(make_system(parse_model(make_text(hub, behind, kGravity))), setup);
    a.advance(100);
    b.advance(100);
    CHECK(deformations(a).norm() > 1e-3);
    CHECK(largest_difference(a, b) < 1e-10);
  }
}
