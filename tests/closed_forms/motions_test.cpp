// Motions of blades whose periods and constants are known.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/closed_forms/beams.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;
using std::numbers::pi;

namespace {

/// Finds times at which a sensor rises through its value `level`, linear between steps [s].
std::vector<double> find_rises(Simulation& simulation, const char* sensor, double level) {
  std::vector<double> times;
  const std::size_t index = simulation.sensor_index(sensor);
  double before = simulation.sensor_values()[index] - level;
  while (!simulation.done()) {
    const double begin = simulation.time();
    simulation.step();
    const double now = simulation.sensor_values()[index] - level;
    if (before < 0.0 && now >= 0.0)
      times.push_back(begin - before / (now - before) * (simulation.time() - begin));
    before = now;
  }
  return times;
}

double mean_period(const std::vector<double>& times) {
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

}  // namespace

TEST_CASE("a stiff blade swings as a compound pendulum, at an amplitude of a radian") {
  Blade blade = wu_haug_blade(2, 2);
  blade.length = 2.0;
  blade.azimuth = -pi / 2.0 + 1.0;
  Scenario scenario;
  scenario.rotor = make_rotor(blade, 1);
  scenario.rotor.blades[0].azimuth = blade.azimuth;
  scenario.rotor.blades[0].youngs_modulus *= 1e4;
  scenario.rotor.hub.inertia = 0.1;
  scenario.rotor.hub.drive = FreeDrive{};
  scenario.rotor.gravity = Position{0.0, -9.81};
  scenario.integration.step = 0.002;
  scenario.integration.spectral_radius = 1.0;
  scenario.integration.duration = 20.0;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  const std::vector<double> times = find_rises(simulation, "hub.angle", -1.0);
  const double mass = blade.density * blade.area * blade.length;
  const double inertia = 0.1 + mass * blade.length * blade.length / 3.0;
  const double small = 2.0 * pi * std::sqrt(inertia / (mass * 9.81 * blade.length / 2.0));
  double a = 1.0, b = std::cos(0.5);  // the period is that of small ones by the mean of both
  for (int k = 0; k < 6; ++k) {
    const double next = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = next;
  }
  REQUIRE(times.size() > 5);
  CHECK(mean_period(times) == approx(small / a).epsilon(2e-4));
}

TEST_CASE("a turning blade lags at the frequency of a rotating beam") {
  // First flap frequencies by sqrt(EI / (rhoA L^4)) at a hub radius of 0: Wright, Smith, Thresher
  // and Wang, J. Appl. Mech. 49 (1982). In the plane the square is less by that of the speed.
  struct Published {
    double speed, flap;
  };
  for (const Published& published :
       {Published{0.0, 3.5160}, Published{2.0, 4.1373}, Published{6.0, 7.3604}}) {
    const double speed = published.speed;
    const double lag = std::sqrt(published.flap * published.flap - speed * speed);
    const Blade blade = wu_haug_blade(4, 4);
    const double unit =
        std::sqrt(blade.youngs_modulus * blade.second_moment / (blade.density * blade.area)) /
        (blade.length * blade.length);
    const double period = 2.0 * pi / (lag * unit);
    Scenario scenario;
    scenario.rotor = make_rotor(blade, 1);
    scenario.rotor.hub.drive = ConstantSpeed{speed * unit};
    // The axial vibration of the start dies away, and so do bending modes beyond the first.
    scenario.rotor.damping.stiffness_factor = 2e-3;
    PointLoad load;
    load.force = Position{0.0, 0.002};
    load.factor = Curve({0.0, 0.5 * period, 1.0 * period}, {0.0, 1.0, 0.0});
    scenario.rotor.loads = {load};
    scenario.integration.spectral_radius = 1.0;
    scenario.integration.step = period / 1000.0;
    scenario.integration.duration = 22.0 * period;
    Simulation simulation(scenario, {.executor = ExecutorKind::serial});
    simulation.run_until(2.0 * period);
    CAPTURE(speed);
    const std::vector<double> times = find_rises(simulation, "blade1.tip.y", 0.0);
    REQUIRE(times.size() > 15);
    CHECK(mean_period(times) == approx(period).epsilon(1e-3));
  }
}

TEST_CASE("a rotor in free flight keeps its momentum, and its mass centre its course") {
  Scenario scenario;
  scenario.rotor = make_rotor(wu_haug_blade(2, 3), 3);
  scenario.rotor.hub.support = HubSupport::free;
  scenario.rotor.hub.mass = 5.0;
  scenario.rotor.hub.drive = FreeDrive{3.0};
  scenario.rotor.blades[0].length = 6.0;
  Sensor sensor;
  sensor.quantity = SensorQuantity::momentum;
  scenario.sensors = {sensor};
  scenario.integration.step = 0.001;
  scenario.integration.spectral_radius = 1.0;
  scenario.integration.duration = 4.0;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  const double x = simulation.sensor("momentum.x"), y = simulation.sensor("momentum.y"),
               angular = simulation.sensor("momentum.angular");
  const double scale = std::hypot(x, y);
  CHECK(scale > 1.0);
  simulation.run_until(4.0);
  CHECK(std::hypot(simulation.sensor("momentum.x") - x, simulation.sensor("momentum.y") - y) <
        1e-3 * scale);
  CHECK(simulation.sensor("momentum.angular") == approx(angular).epsilon(1e-4));
}
