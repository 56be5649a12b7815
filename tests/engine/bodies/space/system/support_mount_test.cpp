// A mount that moves the ground end of a support: as the field of gravity that its acceleration is,
// as a drive, as a support that stands elsewhere.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kGroundSeconds = 0.1;

Simulation run_ground(const std::string& text, Formulation formulation = Formulation::structured,
                      IntegrationMethod method = IntegrationMethod::rk4) {
  Scenario scenario = make_scenario(text, 1e-3, kGroundSeconds, method);
  scenario.integration.tolerance = 1e-12;
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1});
  simulation.run_until(kGroundSeconds);
  return simulation;
}

/// Returns the largest difference of the columns that begin with one of these names.
double column_difference(const Simulation& a, const Simulation& b,
                         std::initializer_list<const char*> names) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.sensor_names().size(); ++k)
    for (const char* name : names)
      if (a.sensor_names()[k].starts_with(name))
        largest = std::max(largest, std::abs(a.sensor_values()[k] - b.sensor_values()[k]));
  return largest;
}

std::string triple(const Eigen::Vector3d& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         "]";
}

}  // namespace

TEST_CASE("a ground that accelerates is a field of gravity") {
  // A harmonic so slow that its acceleration stays what it is at t = 0, to 2e-7.
  const Eigen::Vector3d a(3.0, -2.0, 5.0);
  constexpr double kSlow = 3e-3;
  const Eigen::Vector3d size = a / (kSlow * kSlow);
  const std::string mount = "[hub.mount]\ntranslation = { constant = " + triple(size) +
                            ", amplitude = " + triple(-size) +
                            ", frequency = 3e-3, phase = 1.5707963267948966 }\n";
  const std::string field = "[gravity]\nacceleration = " + triple(-a) + "\n";
  for (const std::string& hub : {kDrivenHub, kTurnedHub})
    for (const Formulation formulation : formulations()) {
      if (hub == kDrivenHub && formulation != Formulation::structured) continue;
      CAPTURE(name_of(formulation));
      const Simulation moved =
          run_ground(make_text(hub + mount, kBooms + kHinges + kTower), formulation);
      const Simulation still =
          run_ground(make_text(hub, kBooms + kHinges + kTower, field), formulation);
      CHECK(std::abs(still.sensor("support.tip.z")) > 1e-3);
      CHECK(column_difference(moved, still, {"blade", "support", "hub.angle", "hub.speed"}) <
            1e-5 * 20.0);  // forces are of some 20 N
      CHECK(column_difference(moved, still, {"blade1.tip", "blade2.tip", "support.tip"}) < 1e-7);
    }
}

TEST_CASE("a ground at constant speed deforms nothing") {
  const std::string flight = "[hub.mount]\ntranslation = { rate = [30, 0, 10] }\n";
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    const Simulation still = run_ground(make_text(kTurnedHub, kBooms + kHinges + kTower, kGravity),
                                        Formulation::structured, method);
    const Simulation moving =
        run_ground(make_text(kTurnedHub + flight, kBooms + kHinges + kTower, kGravity),
                   Formulation::structured, method);
    CHECK(column_difference(still, moving, {"blade", "support", "hub.angle", "hub.speed"}) < 1e-9);
    const Eigen::Vector3d way = moving.hub_pose().position - still.hub_pose().position;
    CHECK((way - Eigen::Vector3d(30, 0, 10) * kGroundSeconds).norm() < 1e-10);
  }
}

TEST_CASE("a ground that is turned, with all but gravity, is a gravity that is turned back") {
  constexpr double kAngle = 0.7;
  const Eigen::Vector3d g(0.5, 1.0, -9.81);
  const Eigen::Vector3d back(std::cos(kAngle) * g.x() - std::sin(kAngle) * g.z(), g.y(),
                             std::sin(kAngle) * g.x() + std::cos(kAngle) * g.z());
  const auto field = [](const Eigen::Vector3d& v) {
    return "[gravity]\nacceleration = " + triple(v) + "\n";
  };
  const std::string mount = "[hub.mount]\nrotation = { constant = [0, 0.7, 0] }\n";
  const Simulation turned = run_ground(make_text(kTurnedHub + mount, kBooms + kTower, field(g)));
  const Simulation still = run_ground(make_text(kTurnedHub, kBooms + kTower, field(back)));
  // The field is written with six digits.
  CHECK(column_difference(turned, still, {"blade", "support", "hub.angle"}) < 1e-4);
  CHECK(column_difference(turned, still, {"blade1.tip", "support.tip", "hub.angle"}) < 1e-6);
}

TEST_CASE("a ground that turns about the axle of a rigid support is a drive") {
  const std::string booms = with_strain(kBooms, "nonlinear");
  const std::string hub =
      "[hub]\nradius = 0.1\nmass = 2.0\ncenter = [0.03, 0.02, 0]\ninertia = 0.5\n";
  const std::string post =
      "[support]\n[[support.body]]\nname = \"post\"\nkind = \"rigid\"\nmass = 1.0\n"
      "inertia = 0.1\n[[support.joint]]\nchild = \"post\"\nkind = \"fixed\"\n"
      "[support.axle]\nbody = \"post\"\noffset = [0, 0, 0.4]\n";
  const std::string drives[] = {"drive = { kind = \"constant\", speed = 4.0 }\n",
                                "drive = { kind = \"fixed\" }\n"
                                "mount = { rotation = { rate = [0, 0, 4.0] } }\n"};
  for (const Formulation formulation : formulations()) {
    const Simulation driven =
        run_ground(make_text(hub + drives[0], booms + post, kGravity), formulation);
    const Simulation carried =
        run_ground(make_text(hub + drives[1], booms + post, kGravity), formulation);
    CHECK(column_difference(driven, carried, {"blade1.tip", "blade2.tip"}) < 1e-10);
    CHECK(column_difference(driven, carried, {"blade", "energy.strain", "hub.torque"}) < 1e-8);
    CHECK(carried.sensor("hub.speed") == 0.0);
    CHECK((driven.hub_reaction().force - carried.hub_reaction().force).norm() < 1e-8);
  }
}
