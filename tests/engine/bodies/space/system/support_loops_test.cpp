// Loops beside a support: those of its own tree, and anchors on both sides of the axle, whose axes
// are those of what carries them whatever the hub's axis.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/loop_models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using Eigen::Vector3d;

constexpr double kLoopSeconds = 0.1;

/// kTower with a strut from a point of the nacelle; `to`: the other end.
std::string strut_on(const std::string& to) {
  return kTower +
         "[[support.loop]]\nname = \"strut\"\nkind = \"distance\"\n"
         "from = { body = \"nacelle\", point = [0.2, 0.3, 0.1] }\nto = { " +
         to + " }\n";
}

Simulation simulate_loops(const std::string& text,
                          Formulation formulation = Formulation::structured,
                          IntegrationMethod method = IntegrationMethod::rk4) {
  Scenario scenario = make_scenario(text, 1e-3, kLoopSeconds, method);
  scenario.integration.tolerance = 1e-12;
  return Simulation(scenario, {formulation, ExecutorKind::serial, 1});
}

Simulation run_loops(const std::string& text, Formulation formulation = Formulation::structured,
                     IntegrationMethod method = IntegrationMethod::rk4) {
  Simulation simulation = simulate_loops(text, formulation, method);
  simulation.run_until(kLoopSeconds);
  return simulation;
}

/// Returns the largest difference of a column of blades, support and hub.
double motion_difference(const Simulation& a, const Simulation& b) {
  double largest = 0.0;
  for (const char* name :
       {"blade1.tip.x", "blade1.tip.y", "blade2.tip.z", "support.tip.x", "support.tip.y",
        "support.tip.z", "hub.angle", "hub.x", "hub.y", "hub.z"})
    largest = std::max(largest, std::abs(a.sensor(name) - b.sensor(name)));
  return largest;
}

/// The point of the nacelle at which the strut is.
Vector3d strut_head(const Simulation& simulation) {
  const MarkerState nacelle = simulation.marker({2, 1, 0.0});
  return nacelle.position + nacelle.rotation * Vector3d(0.2, 0.3, 0.1);
}

}  // namespace

TEST_CASE("a strut from the ground holds a support, whatever the formulation") {
  const std::string text = make_text(
      kTurnedHub, kBooms + strut_on("body = \"ground\", point = [1.0, 1.5, -0.5]"), kGravity);
  const Vector3d foot(1.0, 1.5, -0.5);
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    const Simulation start = simulate_loops(text, Formulation::structured, method);
    const double length = (strut_head(start) - foot).norm();
    const Simulation held = run_loops(text, Formulation::structured, method);
    CHECK((strut_head(held) - foot).norm() == doctest::Approx(length).epsilon(1e-8));
    for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented})
      CHECK(motion_difference(held, run_loops(text, formulation, method)) < 1e-9);
    const Vector3d along = (foot - strut_head(held)) / length;
    const Wrench wrench = held.loop_reaction(2, "strut");
    CHECK(wrench.force.norm() > 1.0);
    CHECK(wrench.force.cross(along).norm() < 1e-9 * wrench.force.norm());
  }
}

TEST_CASE("an anchor on the ground has the ground's axes, whatever the hub's axis") {
  const std::string on_ground = strut_on("body = \"ground\", point = [1.0, 1.5, -0.5]");
  const std::string on_anchor = strut_on("anchor = \"foot\", point = [0.2, 0.1, -0.1]");
  const std::string foot =
      "[[anchor]]\nname = \"foot\"\nframe = \"mount\"\n"
      "motion = { translation = { constant = [0.8, 1.4, -0.4] } }\n";
  for (const std::string& mount :
       {std::string(), std::string("[hub.mount]\nrotation = { constant = [0, 0.3, 0.2], "
                                   "amplitude = [0.1, 0, 0], frequency = 5.0 }\n")}) {
    const Simulation a = run_loops(make_text(kTurnedHub + mount, kBooms + on_ground, kGravity));
    const Simulation b =
        run_loops(make_text(kTurnedHub + mount, kBooms + on_anchor, kGravity + foot));
    CHECK(motion_difference(a, b) < 1e-11);
    const MarkerMotion base = b.base_frame(), anchor = b.anchor_frame(0);
    CHECK((anchor.position - base.position - base.rotation * Vector3d(0.8, 1.4, -0.4)).norm() <
          1e-12);
    CHECK((anchor.rotation - base.rotation).norm() < 1e-12);
    CHECK((b.mount_frame().rotation - base.rotation).norm() < 1e-12);
    CHECK((b.mount_frame().position - base.position).norm() < 1e-12);
  }
}

TEST_CASE("an anchor that moves carries the foot of a strut along, and its work counts") {
  const std::string text =
      make_text(kTurnedHub, kBooms + strut_on("anchor = \"foot\", point = [0.2, 0.1, -0.1]"),
                kGravity +
                    "[[anchor]]\nname = \"foot\"\nframe = \"mount\"\n"
                    "motion = { translation = { constant = [0.8, 1.4, -0.4], amplitude = [0.02, 0, "
                    "0.05], frequency = 9.0 } }\n");
  const auto foot_of = [](double t) {
    return Vector3d(1.0 + 0.02 * std::sin(9.0 * t), 1.5, -0.5 + 0.05 * std::sin(9.0 * t));
  };
  const Simulation start = simulate_loops(text), end = run_loops(text);
  const double length = (strut_head(start) - foot_of(0.0)).norm();
  CHECK((strut_head(end) - foot_of(kLoopSeconds)).norm() == doctest::Approx(length).epsilon(1e-8));
  CHECK(std::abs(end.sensor("energy.residual")) < 1e-5);
  CHECK(std::abs(end.sensor("energy.work")) > 1e-2);
}

TEST_CASE("a loop of a subsystem on a support closes on the hub and on anchors that turn with it") {
  const auto pendulum = [](const std::string& to) {
    return "[[subsystem]]\nname = \"rod\"\n[[subsystem.body]]\nname = \"rod\"\nkind = \"rigid\"\n"
           "mass = 0.8\ncenter = [0.4, 0.0, 0.1]\ninertia = [0.03, 0.05, 0.04]\n"
           "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"rod\"\nkind = \"spherical\"\n"
           "offset = [0.2, 0.1, 0.0]\ninitial_speed = [1.0, 0.5, -1.0]\n"
           "[[subsystem.loop]]\nname = \"link\"\nkind = \"distance\"\n"
           "from = { body = \"rod\", point = [0.5, 0.1, 0.0] }\nto = { " +
           to + " }\n";
  };
  const std::string horn =
      "[[anchor]]\nname = \"horn\"\nframe = \"hub\"\n"
      "motion = { translation = { constant = [0.4, 0.1, 0.3] }, rotation = { constant = [0, 0, "
      "0.5] "
      "} }\n";
  const std::string on_hub = "body = \"hub\", point = [0.5, 0.2, 0.6]";
  // The same point in the axes of the anchor.
  const Vector3d in_horn = Eigen::AngleAxisd(-0.5, Vector3d::UnitZ()) * Vector3d(0.1, 0.1, 0.3);
  const std::string on_horn = "anchor = \"horn\", point = [" + std::to_string(in_horn.x()) + ", " +
                              std::to_string(in_horn.y()) + ", 0.3]";
  for (const Formulation formulation : formulations()) {
    const Simulation a =
        run_loops(make_text(kTurnedHub, pendulum(on_hub) + kBooms + kTower, kGravity), formulation);
    const Simulation b = run_loops(
        make_text(kTurnedHub, pendulum(on_horn) + kBooms + kTower, kGravity + horn), formulation);
    CHECK(motion_difference(a, b) < 1e-5);  // the point is written with six digits
    const HubFrame hub = b.hub_frame();
    const MarkerMotion anchor = b.anchor_frame(0);
    CHECK((anchor.position - hub.position - hub.rotation * Vector3d(0.4, 0.1, 0.3)).norm() < 1e-12);
    const Eigen::Matrix3d turned =
        hub.rotation * Eigen::AngleAxisd(0.5, Vector3d::UnitZ()).toRotationMatrix();
    CHECK((anchor.rotation - turned).norm() < 1e-12);
    CHECK((anchor.angular_velocity - hub.angular_velocity).norm() < 1e-12);
    const Vector3d at = anchor.position - hub.position;
    CHECK((anchor.velocity - hub.velocity - hub.angular_velocity.cross(at)).norm() < 1e-12);
    CHECK(std::abs(b.sensor("energy.residual")) < 1e-4);
  }
}
