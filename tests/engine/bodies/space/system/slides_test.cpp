// A mass that slides along a flexible boom on a spring: the boom feels the spring, not the mass.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/scenario.h"

namespace spoke {
namespace {

Scenario make_slider(int bodies, int elements, const std::string& hub, const std::string& joint,
                     const std::string& more = {}) {
  return parse_scenario(
      "world = \"space\"\n" + hub +
          "[[subsystem]]\nname = \"arm\"\n[[subsystem.body]]\nname = \"boom\"\nkind = \"beam\"\n"
          "length = 1.0\nbodies = " +
          std::to_string(bodies) + "\nelements = " + std::to_string(elements) +
          "\n[subsystem.body.sections]\nmass_per_length = 0.3\naxial_stiffness = 1e4\n"
          "flap_stiffness = 2.0\nlag_stiffness = 3.0\ntorsion_stiffness = 1.0\n"
          "flap_inertia = 0.001\nlag_inertia = 0.001\n"
          "[[subsystem.body]]\nname = \"mass\"\nkind = \"rigid\"\nmass = 0.5\n"
          "inertia = [0.01, 0.01, 0.01]\n"
          "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"boom\"\nkind = \"fixed\"\n"
          "[[subsystem.joint]]\nparent = \"boom\"\nchild = \"mass\"\nkind = \"prismatic\"\n"
          "axis = [1, 0, 0]\n" +
          joint + more + "[integration]\nmethod = \"rk4\"\nstep = 4e-4\nduration = 0.4\n",
      "slider.toml");
}

const std::string kTurning = "[hub.drive]\nkind = \"constant\"\nspeed = 3.0\n";

double frequency_of(const Scenario& scenario, const std::string& name) {
  for (const Mode& mode : solve_modes(scenario, {.count = 5}).modes)
    if (mode.name == name) return mode.frequency;
  FAIL("no mode " << name);
  return 0.0;
}

double largest_residual(Scenario scenario, double step) {
  scenario.integration.step = step;
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  const std::vector<std::string>& names = simulation.sensor_names();
  const auto at = static_cast<std::size_t>(
      std::find(names.begin(), names.end(), "energy.residual") - names.begin());
  REQUIRE(at < names.size());
  double largest = 0.0;
  simulation.run_until(scenario.integration.duration, [&](double, std::span<const double> values) {
    largest = std::max(largest, std::abs(values[at]));
  });
  return largest;
}

}  // namespace

TEST_CASE(
    "a boom of one body feels the spring of what slides along it, as one of many bodies does") {
  // In rotation the spring is drawn out by s = m w^2 (1 + s)/k, by a fifth of the boom's length and
  // more: as much more is the tension than that of a mass at rest.
  for (const double stiffness : {20.0, 30.0}) {
    const std::string joint = "stiffness = " + std::to_string(stiffness) + "\n";
    const Scenario one = make_slider(1, 8, kTurning, joint);
    const Scenario many = make_slider(8, 4, kTurning, joint);
    for (const char* name : {"flap 1", "lag 1"})
      CHECK(frequency_of(one, name) == doctest::Approx(frequency_of(many, name)).epsilon(5e-4));
  }
  // A soft spring and one that is stiff differ by that tension.
  const double soft = frequency_of(make_slider(1, 8, kTurning, "stiffness = 20.0\n"), "flap 1");
  const double stiff = frequency_of(make_slider(1, 8, kTurning, "stiffness = 1e6\n"), "flap 1");
  CHECK(std::abs(soft / stiff - 1.0) > 0.02);
}

TEST_CASE("what slides along a flexible boom keeps energy, on every hub") {
  const std::string joint =
      "stiffness = 20.0\ndamping = 0.5\ninitial = 0.1\ninitial_speed = 0.5\nforce = 0.3\n";
  const std::string loads =
      "[[load]]\nsubsystem = \"arm\"\nbody = \"boom\"\nforce = [0.5, 0.2, 0.3]\n"
      "[[load]]\nsubsystem = \"arm\"\nbody = \"mass\"\nforce = [0.5, 0.2, 0.3]\n"
      "[gravity]\nacceleration = [1.0, -2.0, 3.0]\n";
  const std::string torque = "[hub.drive]\nkind = \"torque\"\ntorque = 0.1\ninitial_speed = 2.0\n";
  const std::string free =
      "[hub]\nsupport = \"free\"\nmass = 1.0\ninertia = [0.5, 0.4, 0.3]\n"
      "angular_velocity = [0.3, 0.2, 2.0]\n";
  for (const std::string& hub : {kTurning, torque, free}) {
    CAPTURE(hub);
    const Scenario scenario = make_slider(1, 2, hub, joint, loads);
    CHECK(std::log2(largest_residual(scenario, 8e-4) / largest_residual(scenario, 4e-4)) > 3.8);
    CHECK(largest_residual(scenario, 4e-4) < 1e-6);
  }
}

TEST_CASE(
    "a spring of the program's on what slides keeps its energy at the places that it is given") {
  // A spring from the sliding mass to a point in space; rk4's last evaluation is at the step's end.
  const Eigen::Vector3d anchor(1.5, 0.4, 0.3);
  constexpr double kStiffness = 4.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  const auto pull = [&](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
    place = in[0].position;
    out[0].force = kStiffness * (anchor - place);
  };
  const Scenario scenario = make_slider(1, 2, "[hub.drive]\nkind = \"fixed\"\n",
                                        "stiffness = 20.0\ninitial_speed = 1.0\n");
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                        {make_load("spring", {Marker{0, 1}}, pull)});
  const auto energy = [&] {
    return simulation.sensor("energy.kinetic") + simulation.sensor("energy.strain") +
           0.5 * kStiffness * (anchor - place).squaredNorm();
  };
  const double before = energy();
  simulation.run_until(scenario.integration.duration);
  CHECK(energy() == doctest::Approx(before).epsilon(1e-7));
}

}  // namespace spoke
