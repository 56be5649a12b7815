// Compares the residual with the kinetic energy.

#include "program/run_report/energy_residual.h"

#include <cmath>

#include "program/run_report/sensor_range.h"

namespace spoke::run_report {
namespace {

/// Whether the method damps fast vibrations.
bool damps(const Integration& integration) {
  return integration.method == IntegrationMethod::generalized_alpha &&
         integration.spectral_radius < 1.0;
}

}  // namespace

EnergyResidual find_energy_residual(const Simulation& simulation,
                                    const SensorStatistics& statistics) {
  constexpr double kNotable = 1e-3;
  const SensorRange& range = range_of(simulation, statistics, "energy.residual");
  const SensorRange& kinetic = range_of(simulation, statistics, "energy.kinetic");
  EnergyResidual residual;
  const bool is_loss = std::abs(range.min) > std::abs(range.max);
  residual.value = is_loss ? range.min : range.max;
  residual.time = is_loss ? range.t_min : range.t_max;
  if (kinetic.max > 0.0) residual.share = std::abs(residual.value) / kinetic.max;
  residual.is_notable = residual.share > kNotable;
  if (residual.is_notable && is_loss && damps(simulation.scenario().integration))
    residual.explanation = "lost: the method damps vibrations that the step does not resolve";
  return residual;
}

}  // namespace spoke::run_report
