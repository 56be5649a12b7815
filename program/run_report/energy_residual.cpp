// Compares the residual with the kinetic energy.

#include "program/run_report/energy_residual.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/start.h"
#include "program/run_report/sensor_range.h"

namespace spoke::run_report {
namespace {

/// Whether the method damps fast vibrations.
bool damps(const Integration& integration) {
  return integration.method == IntegrationMethod::generalized_alpha &&
         integration.spectral_radius < 1.0;
}

/// Whether loops lock all that the model could vibrate in: each blade and subsystem has no
/// mobility, and the hub turns as prescribed.
bool is_locked(const Simulation& simulation) {
  const Scenario& scenario = simulation.scenario();
  const bool is_free = scenario.space ? scenario.space->hub.support == HubSupport::free
                                      : scenario.rotor.hub.support == HubSupport::free;
  if (is_free || !prescribes_motion(drive_of(scenario))) return false;
  const std::size_t owners = scenario.space
                                 ? scenario.space->blades.size() + scenario.space->subsystems.size()
                                 : scenario.rotor.blades.size();
  const std::vector<SubsystemFreedoms> locked = simulation.loops_at_start().subsystems;
  return locked.size() == owners &&
         std::none_of(locked.begin(), locked.end(),
                      [](const SubsystemFreedoms& own) { return own.mobility > 0; });
}

/// Returns the largest energy that has come up: what round-off of the balance is measured by.
double find_largest_energy(const Simulation& simulation, const SensorStatistics& statistics) {
  double largest = 0.0;
  for (const char* sensor : {"energy.kinetic", "energy.strain", "energy.work"}) {
    const SensorRange& range = range_of(simulation, statistics, sensor);
    largest = std::max({largest, std::abs(range.min), std::abs(range.max)});
  }
  return largest;
}

}  // namespace

EnergyResidual find_energy_residual(const Simulation& simulation,
                                    const SensorStatistics& statistics) {
  constexpr double kNotable = 1e-3, kRoundOff = 1e-9;
  const SensorRange& range = range_of(simulation, statistics, "energy.residual");
  const SensorRange& kinetic = range_of(simulation, statistics, "energy.kinetic");
  EnergyResidual residual;
  const bool is_loss = std::abs(range.min) > std::abs(range.max);
  residual.value = is_loss ? range.min : range.max;
  residual.time = is_loss ? range.t_min : range.t_max;
  if (kinetic.max > 0.0) residual.share = std::abs(residual.value) / kinetic.max;
  const double round_off = kRoundOff * find_largest_energy(simulation, statistics);
  residual.is_notable = residual.share > kNotable && std::abs(residual.value) > round_off;
  if (residual.is_notable && is_locked(simulation))
    residual.explanation =
        "of the work of prescribed motion, which is summed over steps: a smaller one makes it "
        "smaller";
  else if (residual.is_notable && is_loss && damps(simulation.scenario().integration))
    residual.explanation = "lost: the method damps vibrations that the step does not resolve";
  return residual;
}

}  // namespace spoke::run_report
