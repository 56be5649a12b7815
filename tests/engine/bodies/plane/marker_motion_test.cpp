// Markers, reactions and section forces, and changes between steps.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "models/error.h"
#include "tests/approx.h"
#include "tests/engine/load_rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

TEST_CASE("a marker of a nearly rigid blade moves as a rigid body") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.1, 1e-3);
  for (Blade& blade : scenario.rotor.blades) blade.youngs_modulus = 1e16;
  Simulation simulation(scenario);
  simulation.run_until(0.1);
  const HubMotion hub = simulation.hub();
  for (const Marker& marker : {Marker{0, 0, 0.0}, Marker{0, 1, 0.3}, Marker{1, 1, 1.0}}) {
    const double angle = hub.position[kRotation] + marker.blade * std::numbers::pi;
    const double r = 0.1 + marker.body + marker.station, w = hub.velocity[kRotation];
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0.0);
    const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
    const MarkerState state = simulation.marker(marker);
    CHECK((state.position - r * along).norm() < 1e-6);
    CHECK((state.rotation.col(0) - along).norm() < 1e-6);
    CHECK((state.velocity - r * w * across).norm() < 1e-6);
    CHECK(state.angular_velocity.z() == approx(w));
    CHECK(state.deflection.norm() < 1e-6);
    const Eigen::Vector3d a = r * hub.acceleration[kRotation] * across - r * w * w * along;
    CHECK((state.acceleration - a).norm() < 1e-3 * a.norm() + 1e-12);
  }
}

TEST_CASE("the deflection of the tip's marker is what its sensors show") {
  for (const bool is_stiffened : {true, false}) {
    Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.2);
    for (Blade& blade : scenario.rotor.blades) blade.geometric_stiffening = is_stiffened;
    Simulation simulation(scenario);
    simulation.run_until(0.2);
    for (const int blade : {0, 1}) {
      const MarkerState tip = simulation.marker({blade, 1, 1.0});
      const Eigen::Vector3d shown = tip.deflection - tip.foreshortening;
      const std::string name = "blade" + std::to_string(blade + 1) + ".tip.";
      CHECK(std::abs(shown.y()) > 1e-3);
      CHECK(shown.x() == approx(simulation.sensor(name + "x")).epsilon(1e-9));
      CHECK(shown.y() == approx(simulation.sensor(name + "y")).epsilon(1e-9));
      CHECK((tip.foreshortening.norm() > 0.0) == is_stiffened);
    }
  }
}

TEST_CASE("a marker's velocity and acceleration are the derivatives of its place") {
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    Scenario scenario = soft_scenario(method, 0.05, 1e-5);
    scenario.rotor.hub.support = HubSupport::free;
    scenario.rotor.hub.drive = TorqueDrive{Curve(1.0), 2.0};
    scenario.rotor.gravity = Position{1.0, -9.81};
    Simulation simulation(scenario);
    simulation.run_until(0.04);
    for (const Marker& marker : {Marker{0, 0, 0.6}, Marker{1, 1, 0.2}, Marker{1, 1, 1.0}}) {
      const MarkerState before = simulation.marker(marker);
      simulation.step();
      const MarkerState now = simulation.marker(marker);
      simulation.step();
      const MarkerState after = simulation.marker(marker);
      const double h2 = 2.0 * simulation.step_size();
      const Eigen::Vector3d v = (after.position - before.position) / h2;
      const Eigen::Vector3d a = (after.velocity - before.velocity) / h2;
      CHECK((v - now.velocity).norm() < 1e-5 * v.norm());
      CHECK((a - now.acceleration).norm() < 2e-3 * a.norm());
      const double alpha = (after.angular_velocity - before.angular_velocity).z() / h2;
      CHECK(now.angular_acceleration.z() == approx(alpha).epsilon(0.01));
    }
  }
}

TEST_CASE("markers and reactions leave the steps as they are, and stand after a restore") {
  const Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.04);
  for (const Formulation formulation : {Formulation::structured, Formulation::augmented}) {
    Simulation watched(scenario, {formulation, ExecutorKind::flow_graph, 2, 10});
    Simulation unseen(scenario, {formulation, ExecutorKind::flow_graph, 2, 10});
    for (const double t : {0.01, 0.02, 0.03, 0.04}) {
      watched.run_until(t);
      unseen.run_until(t);
      watched.marker({0, 1, 0.5});
    }
    CHECK(watched.state_hash() == unseen.state_hash());
    CHECK(watched.sensor("energy.residual") == unseen.sensor("energy.residual"));
    const SavedState end = unseen.save();
    Simulation other(scenario, {formulation, ExecutorKind::serial, 1, 1});
    other.restore(end);
    CHECK(other.joint_reaction(1, 1).force == watched.joint_reaction(1, 1).force);
    CHECK(other.hub_reaction().moment == watched.hub_reaction().moment);
  }
}

TEST_CASE("the axial force of a steadily rotating blade is the centrifugal one") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 4), 0.01);
  Simulation simulation(scenario);
  simulation.run_until(20.0);
  const Blade& blade = scenario.rotor.blades[0];
  const double per_length = blade.density * blade.area, w = 4.0;
  for (int body = 0; body < 2; ++body)
    for (int e = 0; e < 4; ++e) {
      const double r = 4.0 * body + e + 0.5;  // the middle of an element of 1 m
      const double tension = per_length * w * w * (64.0 - r * r - 1.0 / 12.0) / 2.0;
      const Marker marker{0, body, (e + 0.5) / 4.0};
      CHECK(simulation.section_force(marker).force.x() == approx(tension).epsilon(2e-3));
    }
}

TEST_CASE("the hub's reaction carries the roots of the blades and the hub") {
  for (const Formulation formulation : formulations())
    for (const bool is_driven : {true, false}) {
      Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.1);
      scenario.rotor.gravity = Position{0.0, -9.81};
      scenario.rotor.blades[1].length = 1.5;
      // With geometric stiffening the hub feels the foreshortened mass beside the joints.
      for (Blade& blade : scenario.rotor.blades) blade.geometric_stiffening = false;
      if (!is_driven) scenario.rotor.hub.drive = TorqueDrive{Curve(0.5), 1.0};
      Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1});
      simulation.run_until(0.1);
      const Wrench reaction = simulation.hub_reaction();
      Eigen::Vector3d force = reaction.force + 0.3 * Eigen::Vector3d(0.0, -9.81, 0.0);
      double moment = reaction.moment.z();
      for (const int blade : {0, 1}) {
        const Wrench root = simulation.joint_reaction(blade, 0);
        force -= root.force;
        moment -=
            root.moment.z() + simulation.marker({blade, 0, 0.0}).position.cross(root.force).z();
      }
      CHECK(force.norm() < 1e-8 * reaction.force.norm());  // the axle stands still
      const double inertia = scenario.rotor.hub.inertia * simulation.hub().acceleration[kRotation];
      CHECK(moment == approx(inertia).epsilon(1e-6));
      CHECK(reaction.force.norm() > 1.0);
    }
}

TEST_CASE("a cantilever under a tip load bears F and F (L - x)") {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 2), 1);
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.damping.stiffness_factor = 0.5;  // near critical
  scenario.integration.duration = 16.0;
  scenario.integration.step = 0.01;
  constexpr double force = 0.02;
  Simulation simulation(scenario, {}, {steady_load({0, 1, 1.0}, 0.0, force, 0.0)});
  simulation.run_until(16.0);
  for (const Marker& marker : {Marker{0, 0, 0.0}, Marker{0, 0, 0.4}, Marker{0, 1, 0.7}}) {
    const Wrench inner = simulation.section_force(marker);
    const double x = 4.0 * (marker.body + marker.station);
    CHECK(inner.force.y() == approx(force).epsilon(1e-3));
    CHECK(inner.moment.z() == approx(force * (8.0 - x)).epsilon(1e-3));
  }
  for (const int joint : {0, 1}) {
    const Wrench reaction = simulation.joint_reaction(0, joint);
    CHECK(reaction.force.y() == approx(-force).epsilon(1e-3));
    CHECK(reaction.moment.z() == approx(-force * (8.0 - 4.0 * joint)).epsilon(1e-3));
  }
  CHECK(simulation.marker({0, 1, 1.0}).deflection.y() ==
        approx(force * 512.0 / (3.0 * 6.895e10 * 8.214e-9)).epsilon(1e-3));
}

TEST_CASE("places that do not exist are refused") {
  Simulation simulation(soft_scenario(IntegrationMethod::generalized_alpha, 0.01));
  CHECK_THROWS_AS(simulation.marker({0, 0, -0.1}), InputError);
  CHECK_THROWS_AS(simulation.section_force({2, 0, 0.5}), InputError);
  CHECK_THROWS_AS(simulation.joint_reaction(0, 2), InputError);
}

TEST_CASE("a drive that is set at the start is the drive of the scenario") {
  Scenario scenario = soft_scenario(IntegrationMethod::rk4, 0.05);
  scenario.rotor.hub.drive = TorqueDrive{Curve(3.0), 1.0};
  Simulation given(scenario);
  scenario.rotor.hub.drive = TorqueDrive{Curve(1.0), 1.0};
  Simulation changed(scenario);
  changed.set_drive(TorqueDrive{Curve(3.0), 1.0});
  for (Simulation* simulation : {&given, &changed}) simulation->run_until(0.05);
  CHECK(given.state_hash() == changed.state_hash());
  CHECK(given.sensor("energy.work") == changed.sensor("energy.work"));
}

TEST_CASE("a torque that jumps between steps does its work, on every executor, after a restore") {
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    Scenario scenario = soft_scenario(method, 0.1);
    scenario.rotor.hub.drive = TorqueDrive{Curve(0.5), 1.0};
    const auto run = [&](Simulation& simulation) {
      for (int k = 0; k < 10; ++k) {
        simulation.set_drive(TorqueDrive{Curve(k % 2 == 0 ? 2.0 : -1.0), 0.0});
        simulation.run_until(0.01 * (k + 1));
      }
      return simulation.state_hash();
    };
    Simulation serial(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
    const SavedState start = serial.save();
    const std::uint64_t hash = run(serial);
    // generalized_alpha feels a jump over about a step.
    const double slack = method == IntegrationMethod::rk4 ? 1e-7 : 1e-3;
    CHECK(std::abs(serial.sensor("energy.residual")) < slack * serial.sensor("energy.kinetic"));
    Simulation parallel(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2, 5});
    CHECK(run(parallel) == hash);
    serial.restore(start);
    CHECK(run(serial) == hash);
  }
}

TEST_CASE("a drive that cannot take over is refused") {
  Simulation driven(soft_scenario(IntegrationMethod::generalized_alpha, 0.1));
  driven.run_until(0.05);
  const std::uint64_t hash = driven.state_hash();
  CHECK_THROWS_AS(driven.set_drive(SpinUp{4.0, 0.2}), InputError);
  CHECK_THROWS_AS(driven.set_drive(FreeDrive{}), InputError);
  driven.set_drive(SpinUp{3.0, 0.2});
  CHECK(driven.state_hash() == hash);
}

TEST_CASE("a load is replaced between steps") {
  const Scenario scenario = soft_scenario(IntegrationMethod::rk4, 0.04);
  const Marker marker{0, 1, 1.0};
  Simulation given(scenario, {}, {steady_load(marker, 0.0, 0.3, 0.0)});
  Simulation changed(scenario, {}, {steady_load(marker, 0.0, -0.3, 0.0)});
  changed.set_load(0, steady_load(marker, 0.0, 0.3, 0.0));
  const auto broken =
      make_load("broken", {marker}, [](double, std::span<const MarkerMotion>, std::span<Wrench>) {
        throw std::runtime_error("no");
      });
  CHECK_THROWS_AS(changed.set_load(0, broken), LoadError);
  CHECK_THROWS_AS(changed.set_load(1, broken), InputError);
  CHECK_THROWS_AS(changed.set_load(0, steady_load({0, 1, 0.9}, 0.0, 0.3, 0.0)), InputError);
  for (Simulation* simulation : {&given, &changed}) simulation->run_until(0.04);
  CHECK(given.state_hash() == changed.state_hash());
}
