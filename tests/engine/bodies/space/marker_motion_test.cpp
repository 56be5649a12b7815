// Tests markers, reactions and section forces in space.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

/// Makes a cantilever of 2 m and 2 kg, bent by its weight to rest; turned by `twist` along its
/// length.
std::string make_cantilever(const std::string& twist) {
  return R"(world = "space"
[hub]
radius = 0.5
drive = { kind = "fixed" }
[gravity]
acceleration = [0.0, 1.0, -9.81]
ramp = 2.0
[damping]
stiffness_factor = 0.02
[blade]
count = 1
length = 2.0
bodies = 2
elements = 3
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e6
lag_stiffness = 4e4
flap_stiffness = 3e4
torsion_stiffness = 3e4
)" + twist +
         "[integration]\nduration = 4.0\n";
}

}  // namespace

TEST_CASE("a marker's velocities and accelerations in space are derivatives of its motion") {
  struct Case {
    std::string text;
    std::vector<Marker> markers;
  };
  const std::string twist = "twist = [0.5, -0.3]\nprebend = [0.0, 0.2]\n";
  const Case cases[] = {
      {make_text(kTurnedHub, kBooms + twist + kHinges, kGravity), {{0, 0, 0.3}, {1, 1, 0.8}}},
      {make_text(kFlyingHub, kTree + kMotors, kGravity),
       {{0, 0, 0.6}, {0, 4, 0.0, {0.1, 0.2, 0.3}}, {0, 5, 1.0}, {1, 1, 0.4}}}};
  for (const Case& which : cases) {
    Simulation simulation(make_scenario(which.text, 1e-5, 0.02), kSerial);
    simulation.run_until(0.01);
    for (const Marker& marker : which.markers) {
      CAPTURE(marker.body);
      const MarkerState before = simulation.marker(marker);
      simulation.step();
      const MarkerState now = simulation.marker(marker);
      simulation.step();
      const MarkerState after = simulation.marker(marker);
      const double h2 = 2.0 * simulation.step_size();
      const Eigen::Vector3d v = (after.position - before.position) / h2;
      CHECK((v - now.velocity).norm() < 1e-5 * v.norm());
      const Eigen::AngleAxisd turned(after.rotation * before.rotation.transpose());
      const Eigen::Vector3d w = turned.axis() * turned.angle() / h2;
      CHECK((w - now.angular_velocity).norm() < 1e-5 * w.norm());
      const Eigen::Vector3d a = (after.velocity - before.velocity) / h2;
      CHECK((a - now.acceleration).norm() < 2e-3 * a.norm());
      const Eigen::Vector3d alpha = (after.angular_velocity - before.angular_velocity) / h2;
      CHECK((alpha - now.angular_acceleration).norm() < 2e-3 * alpha.norm());
    }
  }
}

TEST_CASE("the deflection of the tip's marker in space is what its sensors show") {
  for (const bool is_stiffened : {true, false}) {
    const std::string stiffened = is_stiffened ? "" : "geometric_stiffening = false\n";
    std::string text = make_text(kDrivenHub, kBooms, kGravity);
    text.insert(text.find("precone"), stiffened);
    Simulation simulation(make_scenario(text, 1e-3, 0.2), kSerial);
    simulation.run_until(0.2);
    const MarkerState tip = simulation.marker({1, 1, 1.0});
    const Eigen::Vector3d shown = tip.deflection - tip.foreshortening;
    const Eigen::Vector3d sensors(simulation.sensor("blade2.tip.x"),
                                  simulation.sensor("blade2.tip.y"),
                                  simulation.sensor("blade2.tip.z"));
    CHECK(sensors.norm() > 1e-3);
    CHECK((shown - sensors).norm() < 1e-12);
    CHECK((tip.foreshortening.norm() > 0.0) == is_stiffened);
    // Half of it comes from the outer part of the blade.
    CHECK(simulation.marker({1, 1, 0.5}).foreshortening.norm() <=
          (is_stiffened ? 0.999 : 1.0) * tip.foreshortening.norm());
  }
}

TEST_CASE("a marker's frame has the section's twist") {
  Simulation simulation(make_scenario(make_cantilever("twist = [0.4, 0.0]\n"), 0.01, 4.0,
                                      IntegrationMethod::generalized_alpha),
                        kSerial);
  for (const double station : {0.0, 0.5, 1.0}) {
    const MarkerState state = simulation.marker({0, 0, station});
    const double twist = 0.4 - 0.2 * station;
    CHECK((state.rotation.col(0) - Eigen::Vector3d::UnitX()).norm() < 1e-9);
    CHECK((state.rotation.col(1) - Eigen::Vector3d(0.0, std::cos(twist), std::sin(twist))).norm() <
          1e-9);
    CHECK((state.position - Eigen::Vector3d(0.5 + station, 0.0, 0.0)).norm() < 1e-9);
  }
}

TEST_CASE("reactions and section forces of a beam at rest carry its weight") {
  Simulation simulation(make_scenario(make_cantilever("twist = [0.4, 0.0]\n"), 0.01, 4.0,
                                      IntegrationMethod::generalized_alpha),
                        kSerial);
  simulation.run_until(4.0);
  const Eigen::Vector3d g(0.0, 1.0, -9.81);
  // Moments about the root at 0.5 m and about the hub leave out the sag of some millimetres.
  const Wrench root = simulation.joint_reaction(0, 0), hub = simulation.hub_reaction();
  CHECK((root.force + 2.0 * g).norm() < 1e-4);
  CHECK((root.moment + Eigen::Vector3d(1.0, 0.0, 0.0).cross(2.0 * g)).norm() < 0.02);
  CHECK((hub.force + 2.0 * g).norm() < 1e-4);
  CHECK((hub.moment + Eigen::Vector3d(1.5, 0.0, 0.0).cross(2.0 * g)).norm() < 0.02);
  // Half the blade is outboard of the second body's joint.
  const Wrench joint = simulation.joint_reaction(0, 1);
  CHECK((joint.force + g).norm() < 1e-4);
  CHECK((joint.moment + Eigen::Vector3d(0.5, 0.0, 0.0).cross(g)).norm() < 0.02);
  // The section is in the middle of an element, where strains are most exact, in its own axes.
  const double x = 0.5, outboard = 2.0 - x;
  const Marker marker{0, 0, x};
  const Wrench load = simulation.section_force(marker);
  const Eigen::Matrix3d R = simulation.marker(marker).rotation;
  CHECK((R * load.force - outboard * g).norm() < 0.02);
  const Eigen::Vector3d moment = Eigen::Vector3d(0.5 * outboard, 0.0, 0.0).cross(outboard * g);
  CHECK((R * load.moment - moment).norm() < 0.02 * moment.norm());
}

TEST_CASE("views in space of places that do not exist are refused") {
  Simulation simulation(make_scenario(make_text(kFlyingHub, kTree), 1e-3, 0.1), kSerial);
  CHECK(message_of([&] {
          simulation.marker({1, 0, 0.0});
        }) == "the marker: blade index 1, expected 0");
  CHECK(message_of([&] { simulation.joint_reaction(0, 6); }) ==
        "the marker: body index 6, expected 0 to 5");
  CHECK(message_of([&] {
          simulation.section_force({0, 4, 0.0});
        }) == "section_force(): the marker is on a rigid body, expected one on a beam");
}
