// A blade at rest, or turning steadily: shapes under end loads and its own centrifugal force.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/closed_forms/beams.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

/// Makes a blade that creeps to rest, on a hub that stands still, under a load at its tip that
/// rises.
Scenario resting_scenario(int bodies, const Position& force, double moment) {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(bodies, 2), 1);
  scenario.rotor.hub.drive = FixedDrive{};
  scenario.rotor.damping.stiffness_factor = 0.5;
  PointLoad load;
  load.frame = LoadFrame::hub;
  load.force = force;
  load.moment = moment;
  load.ramp = 5.0;
  scenario.rotor.loads = {load};
  scenario.integration.step = 0.02;
  scenario.integration.duration = 30.0;
  return scenario;
}

/// Returns the displacement of the tip at the end [m].
Position rest(const Scenario& scenario) {
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  simulation.run_until(scenario.integration.duration);
  return {simulation.sensor("blade1.tip.x"), simulation.sensor("blade1.tip.y")};
}

double bending_stiffness(const Blade& blade) { return blade.youngs_modulus * blade.second_moment; }

/// Returns the displacement of the tip of an inextensible cantilever of length 1 and EI = 1 under a
/// transverse force that keeps its direction: theta'' = -force cos(theta), theta(0) = 0, theta'(1)
/// = 0. The curvature at the root is found by shooting, with the classical method of Runge and
/// Kutta.
Position elastica(double force) {
  using State = std::array<double, 4>;  // angle, curvature, x, y
  const auto shoot = [force](double curvature) {
    State y{0.0, curvature, 0.0, 0.0};
    const auto slope = [force](const State& s) {
      return State{s[1], -force * std::cos(s[0]), std::cos(s[0]), std::sin(s[0])};
    };
    constexpr int kSteps = 500;
    const double h = 1.0 / kSteps;
    const auto moved = [](const State& s, const State& by, double share) {
      State sum = s;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += share * by[k];
      return sum;
    };
    for (int step = 0; step < kSteps; ++step) {
      const State a = slope(y), b = slope(moved(y, a, h / 2)), c = slope(moved(y, b, h / 2)),
                  d = slope(moved(y, c, h));
      for (std::size_t k = 0; k < y.size(); ++k)
        y[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
    }
    return y;
  };
  const double root = find_root([&](double k) { return shoot(k)[1]; }, 0.0, force);
  const State end = shoot(root);
  return {end[2] - 1.0, end[3]};
}

}  // namespace

TEST_CASE("a cantilever bends by F L^3 / (3 EI) and M L^2 / (2 EI)") {
  const Blade blade = wu_haug_blade();
  const double EI = bending_stiffness(blade), L = blade.length;
  CHECK(rest(resting_scenario(4, {0.0, 0.05}, 0.0)).y() ==
        approx(0.05 * L * L * L / (3.0 * EI)).epsilon(1e-4));
  CHECK(rest(resting_scenario(4, {0.0, 0.0}, 0.3)).y() ==
        approx(0.3 * L * L / (2.0 * EI)).epsilon(1e-4));
}

TEST_CASE("a moment bends a blade to an arc of 77 degrees") {
  const Blade blade = wu_haug_blade();
  const double L = blade.length, angle = 77.0 * std::numbers::pi / 180.0;
  const Position tip = rest(resting_scenario(32, {0.0, 0.0}, angle * bending_stiffness(blade) / L));
  CHECK(tip.x() == approx(L * std::sin(angle) / angle - L).epsilon(1e-3));
  CHECK(tip.y() == approx(L * (1.0 - std::cos(angle)) / angle).epsilon(1e-3));
}

TEST_CASE("a force at the tip bends a blade by a third of its length as the elastica") {
  const Blade blade = wu_haug_blade();
  const double L = blade.length, force = 1.0;  // by EI / L^2
  const Position exact = elastica(force);
  CHECK(exact.y() == approx(0.3017).epsilon(1e-3));  // Bisshopp and Drucker 1945
  const Position tip =
      rest(resting_scenario(32, {0.0, force * bending_stiffness(blade) / (L * L)}, 0.0));
  CHECK(tip.x() == approx(L * exact.x()).epsilon(1e-3));
  CHECK(tip.y() == approx(L * exact.y()).epsilon(1e-3));
}

TEST_CASE("a turning blade is longer by tan(k L) / k - L, k the speed by that of sound") {
  for (const int bodies : {1, 4}) {
    Scenario scenario;
    Blade blade = wu_haug_blade(bodies, 4);
    const double speed = 4.0, k = 0.3 / blade.length;
    blade.youngs_modulus = blade.density * speed * speed / (k * k);
    blade.second_moment *= 1e6;  // bending is damped with it
    scenario.rotor = make_rotor(blade, 1);
    scenario.rotor.hub.drive = ConstantSpeed{speed};
    scenario.rotor.damping.stiffness_factor = 0.05;
    scenario.integration.step = 0.005;
    scenario.integration.duration = 20.0;
    CAPTURE(bodies);
    const double exact = std::tan(k * blade.length) / k - blade.length;
    CHECK(rest(scenario).x() == approx(exact).epsilon(1e-3));
  }
}
