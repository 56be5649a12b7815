// Simulates the histories of Fig. 8 and Fig. 9, and samples the drive.

#include "bench/reproduce/figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/results.h"
#include "engine/simulation.h"

namespace spoke::reproduce {
namespace {

constexpr double kInterval = 0.05;  // time between points [s]

double end_of_ramp(const Drive& drive) {
  const auto* spin_up = std::get_if<SpinUp>(&drive);
  return spin_up ? spin_up->ramp : 0.0;
}

}  // namespace

std::vector<DrivePoint> sample_drive(const Drive& drive, double duration, int count) {
  assert(prescribes_motion(drive) && duration > 0.0 && count > 0);
  std::vector<DrivePoint> points;
  for (int k = 0; k <= count; ++k) {
    const double t = duration * k / count;
    points.push_back({t, calc_motion(drive, t)});
  }
  return points;
}

Deflection simulate_deflection(std::string name, Scenario scenario, double step) {
  scenario.rotor.blades.resize(1);  // blades are alike, and the hub's motion is prescribed
  scenario.integration.method = IntegrationMethod::generalized_alpha;
  scenario.integration.step = step;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial, .threads = 1});
  const auto& names = simulation.sensor_names();
  const auto sensor = static_cast<std::size_t>(
      std::find(names.begin(), names.end(), "blade1.tip.y") - names.begin());
  Deflection deflection{.name = std::move(name)};
  OutputTimes output(kInterval);
  const double ramp = end_of_ramp(scenario.rotor.hub.drive);
  const auto observe = [&](double t, std::span<const double> values) {
    const double y = values[sensor];
    if (y < deflection.lag) deflection.lag = y, deflection.lag_time = t;
    if (t >= ramp) deflection.residual = std::max(deflection.residual, std::abs(y));
    if (output.is_due(t)) deflection.points.push_back({t, y});
  };
  observe(0.0, simulation.sensor_values());
  simulation.run_until(scenario.integration.duration, observe);
  return deflection;
}

std::vector<Deflection::Point> exact::points() {
  return {{1.0, -0.01324108},   {2.5, -0.14306001},     {5.0, -0.42305208},
          {7.5, -0.52079305},   {10.0, -0.3477879},     {12.5, -0.1105987},
          {15.0, 0.0073388835}, {17.5, -0.00021268942}, {20.0, -0.0071307119}};
}

}  // namespace spoke::reproduce
