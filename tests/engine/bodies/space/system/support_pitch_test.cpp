// Pitch by the azimuth on a rotor that a support carries: the azimuth is the axle's coordinate.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kPitchSeconds = 0.2;

Simulation run_pitch(const std::string& hub, const std::string& support, double step,
                     Formulation formulation = Formulation::structured,
                     IntegrationMethod method = IntegrationMethod::generalized_alpha) {
  Scenario scenario =
      make_scenario(make_text(hub, kBooms + kPitch + support, kGravity), step, 1.0, method);
  scenario.integration.tolerance = 1e-12;
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1});
  simulation.run_until(kPitchSeconds);
  return simulation;
}

}  // namespace

TEST_CASE("cyclic pitch follows the axle of a rotor on a support, driven or turned by a torque") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const Simulation simulation = run_pitch(hub, kTower, 2e-3);
    const double angle = simulation.sensor("hub.angle"), speed = simulation.sensor("hub.speed");
    for (const int blade : {0, 1}) {
      const double psi = angle + 3.141592653589793 * blade;
      const double cosine = std::cos(psi), sine = std::sin(psi);
      const CoordinateMotion pitch =
          simulation.joint_motion(blade, simulation.joint_index(blade, "pitch"));
      CHECK(pitch.value == doctest::Approx(0.14 + 0.1 * cosine - 0.15 * sine).epsilon(1e-12));
      CHECK(pitch.velocity == doctest::Approx((-0.1 * sine - 0.15 * cosine) * speed));
    }
    CHECK(speed > 0.1);
  }
}

TEST_CASE("formulations agree on cyclic pitch on a support, and its energies close") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const Simulation coarse = run_pitch(hub, kTower, 4e-3);
    for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
      const Simulation other = run_pitch(hub, kTower, 4e-3, formulation);
      for (const char* name : {"blade1.tip.z", "support.tip.y", "hub.angle", "blade2.pitch"})
        CHECK(std::abs(coarse.sensor(name) - other.sensor(name)) < 1e-9);
    }
    const double large = run_pitch(hub, kTower, 2e-3).sensor("energy.residual");
    const double small = run_pitch(hub, kTower, 2.5e-4).sensor("energy.residual");
    CAPTURE(small);
    CHECK(std::abs(large / small) > 16.0);  // order two: 64, which stiff modes reach last
    CHECK(std::abs(small) < 1e-5 * coarse.sensor("energy.kinetic"));
  }
}

TEST_CASE("cyclic pitch on a support that does not give is that on an axle") {
  const std::string post =
      "[support]\n[[support.body]]\nname = \"post\"\nkind = \"rigid\"\nmass = 1.0\n"
      "inertia = 0.1\n[[support.joint]]\nchild = \"post\"\nkind = \"fixed\"\n"
      "[support.axle]\nbody = \"post\"\n";
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const Simulation held = run_pitch(hub, "", 2e-3), standing = run_pitch(hub, post, 2e-3);
    for (const char* name : {"blade1.tip.y", "blade1.tip.z", "hub.angle", "blade1.pitch"})
      CHECK(std::abs(held.sensor(name) - standing.sensor(name)) < 1e-10);
    // The last iteration leaves accelerations this uncertain.
    CHECK(std::abs(held.sensor("hub.torque") - standing.sensor("hub.torque")) < 1e-4);
    // The sums that make the work have an error of order two, 8e-6 here.
    CHECK(std::abs(held.sensor("energy.work") - standing.sensor("energy.work")) < 2e-5);
  }
}

TEST_CASE("rk4 knows the azimuth of a drive that prescribes it, on a support, too") {
  const auto residual = [](double step) {
    return run_pitch(kDrivenHub, kTower, step, Formulation::structured, IntegrationMethod::rk4)
        .sensor("energy.residual");
  };
  CHECK(std::abs(residual(1e-3)) < 1e-4);
  CHECK(std::abs(residual(1e-3) / residual(5e-4)) > 12.0);
  CHECK(message_of([] {
          run_pitch(kTurnedHub, kTower, 1e-3, Formulation::structured, IntegrationMethod::rk4);
        }).find("expected \"generalized_alpha\"") != std::string::npos);
}
