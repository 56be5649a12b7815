// Compares the fastest vibrations of models in space with all roots of the whole matrix and with
// rk4 itself.

#include "engine/small_motions/vibration/frequency_limits.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/linearize.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::message_of;

/// Returns blades of one body, with the joint `root` at their roots.
std::string blade_text(const std::string& root) {
  return R"([blade]
count = 2
length = 2.0
bodies = 1
elements = 2
)" + root +
         R"([blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e5
flap_stiffness = 50.0
lag_stiffness = 80.0
torsion_stiffness = 40.0
)";
}

const std::string kFlapHinge = R"([[blade.joint]]
name = "flap"
station = 0.0
kind = "revolute"
axis = [0.0, -1.0, 0.0]
stiffness = 300.0
damping = 20.0
)";

Scenario parse(const std::string& text) {
  Scenario scenario = parse_scenario(
      "world = \"space\"\n" + text + "[integration]\nduration = 1.0\n", "limit.toml");
  scenario.integration.method = IntegrationMethod::rk4;
  return scenario;
}

Scenario at_speed(double speed, const std::string& root, double damping = 0.0) {
  return parse("[hub.drive]\nkind = \"constant\"\nspeed = " + std::to_string(speed) +
               "\n[damping]\nstiffness_factor = " + std::to_string(damping) + "\n" +
               blade_text(root));
}

/// Returns a scenario whose hub flies, or is held by a torque of zero; blades meet at both.
Scenario with_hub(const std::string& hub) {
  return parse("[hub]\nmass = 5.0\ninertia = [0.4, 0.4, 0.3]\n" + hub +
               "[damping]\nstiffness_factor = 1e-4\n" + blade_text(kFlapHinge));
}

/// Returns the limit by all roots of the state-space matrix and the definition of the stability of
/// rk4.
double limit_by_all_roots(const Scenario& scenario, double speed) {
  const LinearSystem linear = solve_linear_system(scenario, {.speed = speed});
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(linear.A), false);
  const auto is_stable = [&](double h) {
    for (std::complex<double> s : solver.eigenvalues()) {
      const std::complex<double> z(-h * std::abs(s.real()), h * s.imag());
      if (std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0) > 1.0 + 1e-9)
        return false;
    }
    return true;
  };
  double low = 0.0, high = 1.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (is_stable(middle) ? low : high) = middle;
  }
  return low;
}

/// Runs rk4 for a thousand steps of this share of the limit, with a push at a tip. Returns the
/// error, empty if it gets through.
std::string diverge(Scenario scenario, double share) {
  scenario.integration.step = share * vibration::find_rk4_limit(scenario).step;
  scenario.integration.duration = 1000.0 * scenario.integration.step;
  spatial::PointLoad push;
  push.force = {0.01, 0.01, 0.01};
  scenario.space->loads = {push};
  try {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
    simulation.run_until(scenario.integration.duration);
  } catch (const DivergenceError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("rk4's limit in space is that of all roots, with dampers, damping and free hubs") {
  for (const Scenario& scenario :
       {at_speed(0.0, ""), at_speed(0.0, "", 0.01), at_speed(0.0, kFlapHinge),
        at_speed(0.0, kFlapHinge, 1e-4), with_hub("[hub.drive]\nkind = \"torque\"\ntorque = 0.0\n"),
        with_hub("support = \"free\"\n[hub.drive]\nkind = \"free\"\n")}) {
    const vibration::Rk4Limit limit = vibration::find_rk4_limit(scenario);
    CHECK(limit.speed == 0.0);
    CHECK(limit.step == Approx(limit_by_all_roots(scenario, 0.0)).epsilon(1e-4));
  }
}

TEST_CASE("where the hub turns, a bar on a flap hinge flaps, and that is rk4's limit") {
  const Scenario scenario = parse(R"([hub.drive]
kind = "spin_up_hold_spin_down"
speed = -30.0
ramp = 0.1
hold = 0.5
[[subsystem]]
name = "bar"
[[subsystem.body]]
name = "bar"
kind = "rigid"
mass = 1.0
center = [1.0, 0.0, 0.0]
inertia = [0.02, 0.1, 0.1]
[[subsystem.joint]]
parent = "hub"
child = "bar"
kind = "revolute"
axis = [0.0, -1.0, 0.0]
)");
  const vibration::Rk4Limit limit = vibration::find_rk4_limit(scenario);
  CHECK(limit.speed == -30.0);
  // Steiner: 1.1 about the hinge and about the axle.
  const double flap = 30.0 * std::sqrt((1.1 - 0.02) / 1.1);
  CHECK(std::abs(limit.root) == Approx(flap).epsilon(1e-6));
  CHECK(limit.step == Approx(2.0 * std::sqrt(2.0) / flap).epsilon(1e-6));
}

TEST_CASE("an anchor that vibrates is none of the model's motions: the limit is that at rest") {
  const auto limit_of = [](const std::string& amplitude) {
    return vibration::find_rk4_limit(parse(R"([hub.drive]
kind = "fixed"
[[anchor]]
name = "shaker"
[anchor.motion.translation]
amplitude = [0.0, 0.0, )" + amplitude + R"(]
frequency = 50.0
[[subsystem]]
name = "bar"
[[subsystem.body]]
name = "bar"
kind = "rigid"
mass = 1.0
center = [1.0, 0.0, 0.0]
inertia = [0.02, 0.1, 0.1]
[[subsystem.joint]]
parent = "hub"
child = "bar"
kind = "revolute"
axis = [0.0, -1.0, 0.0]
[[subsystem.loop]]
name = "spring"
kind = "distance"
from = { body = "bar", point = [1.0, 0.0, 0.0] }
to = { anchor = "shaker", point = [1.0, 0.0, -0.5] }
stiffness = 440.0
)"));
  };
  const vibration::Rk4Limit shaken = limit_of("0.01");
  // 440 N/m at 1 m from the hinge, 1.1 kg m^2 about it.
  CHECK(std::abs(shaken.root) == Approx(20.0).epsilon(1e-6));
  CHECK(shaken.step == limit_of("0.0").step);
}

TEST_CASE("rk4 in space goes through below its limit and diverges above it, which is named") {
  for (const Scenario& scenario :
       {at_speed(0.0, ""), at_speed(0.0, "", 0.01), at_speed(0.0, kFlapHinge),
        with_hub("[hub.drive]\nkind = \"torque\"\ntorque = 0.0\n")}) {
    CHECK(diverge(scenario, 0.98).empty());
    const std::string told = diverge(scenario, 1.05);
    CHECK(told.find("is above the stability limit of rk4") != std::string::npos);
    CHECK(told.ends_with("take a smaller integration.step, or generalized_alpha"));
  }
}

TEST_CASE("natural frequencies at rest in space are those of a clamped beam and of the mesh") {
  const Scenario scenario = at_speed(3.0, "", 0.01);
  const LinearProperties properties = Simulation(scenario).linear_properties();
  CHECK(properties.lowest_frequency ==
        Approx(3.516015 * std::sqrt(50.0 / std::pow(2.0, 4))).epsilon(1e-3));
  CHECK(properties.highest_frequency ==
        Approx(2.0 * std::sqrt(2.0) / limit_by_all_roots(at_speed(0.0, ""), 0.0)).epsilon(1e-4));
}

TEST_CASE("a rigid body that turns freely has no limit, and large trees are left out in one line") {
  Scenario top = parse(R"([hub.drive]
kind = "fixed"
[[subsystem]]
name = "wheel"
[[subsystem.body]]
name = "disc"
kind = "rigid"
mass = 1.0
center = [0.0, 0.0, 0.0]
inertia = [1.0, 1.0, 2.0]
[[subsystem.joint]]
parent = "hub"
child = "disc"
kind = "revolute"
axis = [0.0, 0.0, 1.0]
)");
  CHECK(std::isinf(vibration::find_rk4_limit(top).step));
  Scenario long_blade = at_speed(0.0, "");
  long_blade.space->blades[0].beam.bodies = 100;
  CHECK(message_of([&] { vibration::find_rk4_limit(long_blade); }) ==
        "the frequencies of \"blade 1\" are not computed: it has 1200 coordinates, expected at "
        "most 1000");
}

}  // namespace
}  // namespace spoke
