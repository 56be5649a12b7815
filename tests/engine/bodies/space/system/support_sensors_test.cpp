// Sensors of a rotor on a support: wrenches of the axle and of the ground against weight and
// momentum, motions against what the views show.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using Eigen::Vector3d;

const SimulationOptions kSensorOptions{Formulation::structured, ExecutorKind::serial, 1};

const std::string kWrenchSensors = R"(
[[sensor]]
name = "axle"
quantity = "joint_reaction"
subsystem = "support"
body = "hub"
frame = "inertial"
[[sensor]]
name = "ground"
quantity = "joint_reaction"
subsystem = "support"
body = "tower"
frame = "inertial"
[[sensor]]
name = "reaction"
quantity = "hub_reaction"
frame = "inertial"
[[sensor]]
name = "turning"
quantity = "hub_reaction"
frame = "hub"
[[sensor]]
name = "all"
quantity = "momentum"
[[sensor]]
name = "own"
quantity = "blade_momentum"
)";

Wrench wrench_of(const Simulation& simulation, const std::string& name) {
  return {vector_of(simulation, name + ".force"), vector_of(simulation, name + ".moment")};
}
Vector3d cross_of(const Vector3d& a, const Vector3d& b) { return a.cross(b); }

constexpr double kHubMass = 2.0;
const Vector3d kHubCenter(0.03, 0.02, 0.0), kField(0.5, 1.0, -9.81);

/// Linear momentum of hub and blades of kTurnedHub.
Vector3d calc_rotor_momentum(const Simulation& simulation) {
  const HubFrame hub = simulation.hub_frame();
  const Vector3d center = hub.rotation * kHubCenter;
  return kHubMass * (hub.velocity + hub.angular_velocity.cross(center)) +
         vector_of(simulation, "blade1.own") + vector_of(simulation, "blade2.own");
}

/// The rate of a vector in the middle of five samples.
Vector3d rate_of(const std::vector<Vector3d>& samples, double step) {
  REQUIRE(samples.size() == 5);
  return (samples[0] - 8.0 * samples[1] + 8.0 * samples[3] - samples[4]) / (12.0 * step);
}

}  // namespace

TEST_CASE("axle and ground of a support bear the weight at rest, and its moment") {
  // A rigid rotor that stands, on a post that is held by springs in all directions.
  const std::string text =
      "world = \"space\"\n[hub]\nmass = 2.0\ninertia = 0.5\ndrive = { kind = \"fixed\" }\n"
      "[gravity]\nacceleration = [0, 0, -9.81]\nramp = 1.0\n"
      "[integration]\nduration = 4.0\nstep = 0.01\n"
      "[support]\n[[support.body]]\nname = \"tower\"\nkind = \"rigid\"\nmass = 3.0\n"
      "center = [0.2, 0.0, 0.4]\ninertia = 0.3\n[[support.joint]]\nchild = \"tower\"\n"
      "kind = \"bushing\"\nstiffness = [1e6, 1e6, 1e6, 1e6, 1e6, 1e6]\n"
      "damping = [2e3, 2e3, 2e3, 2e3, 2e3, 2e3]\n"
      "[support.axle]\nbody = \"tower\"\noffset = [-0.5, 0.3, 1.0]\n" +
      kWrenchSensors.substr(0, kWrenchSensors.find("[[sensor]]\nname = \"own\""));
  Simulation simulation(parse_scenario(text, "test.toml"), kSensorOptions);
  simulation.run_until(4.0);
  const Wrench axle = wrench_of(simulation, "support.axle"),
               ground = wrench_of(simulation, "support.ground");
  CHECK((axle.force - Vector3d(0, 0, 2.0 * 9.81)).norm() < 1e-6);
  CHECK(axle.moment.norm() < 1e-6);
  CHECK((ground.force - Vector3d(0, 0, 5.0 * 9.81)).norm() < 1e-6);
  // Springs let it sink and tilt by some 1e-5.
  const Vector3d moment = 9.81 * (cross_of({0.6, 0.0, 1.2}, Vector3d::UnitZ()) +
                                  cross_of({-1.0, 0.6, 2.0}, Vector3d::UnitZ()));
  CHECK((ground.moment - moment).norm() < 1e-4 * moment.norm());
  CHECK(vector_of(simulation, "all").norm() < 1e-6);
}

TEST_CASE("axle and ground of a support give the momentum that a turning rotor has") {
  constexpr double kStep = 1e-4;
  Scenario scenario =
      make_scenario(make_text(kTurnedHub, kBooms + kTower, kGravity + kWrenchSensors), kStep, 1.0);
  Simulation simulation(scenario, kSensorOptions);
  simulation.run_until(0.05);
  std::vector<Vector3d> all, rotor;
  Wrench axle, ground, reaction, turning, of_hub;
  Eigen::Matrix3d to_space = Eigen::Matrix3d::Identity();
  for (int n = 0; n < 5; ++n) {
    simulation.step();
    all.push_back(vector_of(simulation, "all"));
    rotor.push_back(calc_rotor_momentum(simulation));
    if (n != 2) continue;
    axle = wrench_of(simulation, "support.axle");
    ground = wrench_of(simulation, "support.ground");
    reaction = wrench_of(simulation, "reaction");
    turning = wrench_of(simulation, "turning");
    of_hub = simulation.hub_reaction();
    to_space = simulation.hub_frame().rotation;
  }
  const double masses = kHubMass + 2 * 2.0 + 2.0 + 1.5;
  CHECK((ground.force - (rate_of(all, kStep) - masses * kField)).norm() <
        1e-4 * ground.force.norm());
  CHECK((axle.force - (rate_of(rotor, kStep) - (kHubMass + 2 * 2.0) * kField)).norm() <
        1e-4 * axle.force.norm());
  CHECK((of_hub.force - axle.force).norm() < 1e-9 * axle.force.norm());
  CHECK((of_hub.moment - axle.moment).norm() < 1e-9 * axle.moment.norm());
  CHECK((reaction.force - axle.force).norm() < 1e-9 * axle.force.norm());
  CHECK((reaction.moment - axle.moment).norm() < 1e-9 * axle.moment.norm());
  // The frame "hub" has z along the hub's axis, to which the drive's torque is about.
  CHECK(turning.moment.z() == doctest::Approx(3.0));
  CHECK(turning.force.norm() == doctest::Approx(axle.force.norm()));
  const Vector3d axis = to_space * Vector3d(0.2, 0.3, 1.0).normalized();
  CHECK(axle.moment.dot(axis) == doctest::Approx(3.0));
  CHECK(simulation.sensor("hub.torque") == doctest::Approx(3.0));
}

TEST_CASE("the moment at the ground is the rate of the angular momentum") {
  constexpr double kStep = 1e-4;
  Simulation simulation(
      make_scenario(make_text(kTurnedHub, kBooms + kTower, kWrenchSensors), kStep, 1.0),
      kSensorOptions);
  simulation.run_until(0.05);
  std::vector<Vector3d> about;
  Wrench ground;
  for (int n = 0; n < 5; ++n) {
    simulation.step();
    about.push_back(vector_of(simulation, "all.angular"));
    if (n == 2) ground = wrench_of(simulation, "support.ground");
  }
  CHECK(ground.moment.norm() > 1.0);
  CHECK((ground.moment - rate_of(about, kStep)).norm() < 1e-3 * ground.moment.norm());
}

TEST_CASE("motions of a rotor on a support are those of its views, at rates of each other") {
  constexpr double kStep = 1e-4;
  const std::string sensors = R"(
[[sensor]]
name = "speed"
quantity = "velocity"
frame = "inertial"
[[sensor]]
name = "push"
quantity = "acceleration"
frame = "inertial"
[[sensor]]
name = "nod"
quantity = "acceleration"
subsystem = "support"
body = "hub"
frame = "inertial"
)";
  for (const std::string& bodies : {kBooms, std::string()}) {  // a hub alone on its tower, too
    const std::string own = bodies.empty() ? sensors.substr(sensors.rfind("[[sensor]]")) : sensors;
    std::string tower = kTower;  // sensors show what bending draws in, views do not
    tower.replace(tower.find("length = 2.0"), 12, "length = 2.0\ngeometric_stiffening = false");
    Scenario scenario =
        make_scenario(make_text(kTurnedHub, bodies + tower, kGravity + own), kStep, 1.0);
    Simulation simulation(scenario, kSensorOptions);
    simulation.run_until(0.05);
    std::vector<Vector3d> places, velocities, spins;
    HubFrame middle;
    Vector3d nod;
    for (int n = 0; n < 5; ++n) {
      simulation.step();
      const HubFrame hub = simulation.hub_frame();
      places.push_back(hub.position);
      velocities.push_back(hub.velocity);
      spins.push_back(hub.angular_velocity);
      if (n != 2) continue;
      middle = hub;
      nod = vector_of(simulation, "support.nod");
      if (bodies.empty()) continue;
      const MarkerState tip = simulation.marker({0, 1, 1.0});
      CHECK((tip.velocity - vector_of(simulation, "blade1.speed")).norm() < 0.1);  // foreshortened
    }
    CHECK((rate_of(places, kStep) - middle.velocity).norm() < 1e-6);
    CHECK((rate_of(velocities, kStep) - middle.acceleration).norm() <
          1e-5 * middle.acceleration.norm());
    CHECK((rate_of(spins, kStep) - middle.angular_acceleration).norm() <
          1e-5 * middle.angular_acceleration.norm());
    CHECK((nod - middle.acceleration).norm() < 1e-9 * middle.acceleration.norm());
  }
}
