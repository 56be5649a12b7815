// Looks at each complete step, and words the warnings.

#include "engine/simulation/observations.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>

namespace spoke {
namespace {

std::string name_body(const Observations::Deflection& seen) {
  std::ostringstream text;
  text << "blade " << seen.blade + 1.0 << " / body " << seen.body + 1.0;
  return text.str();
}

Warning warn_of_deflection(const Scenario& scenario, double step_size, const Observations& seen) {
  const double limit = scenario.limits.deflection;
  const auto blade_of = [&](const Observations::Deflection& at) -> const Blade& {
    return scenario.rotor.blades.at(static_cast<std::size_t>(at.blade));
  };
  const auto length_of = [&](const Observations::Deflection& at) {
    return blade_of(at).length / blade_of(at).bodies;
  };
  const Observations::Deflection& first = seen.first_deflection;
  const Observations::Deflection& largest = seen.largest_deflection;
  const double time = seen.first_deflection.step * step_size;
  std::ostringstream text;
  text << name_body(first) << " bends by " << first.ratio * length_of(first) << " m at t = " << time
       << " s, more than " << 100.0 * limit << " % of its length of " << length_of(first)
       << " m, up to which its linear elasticity holds; ";
  if (seen.largest_deflection.step > seen.first_deflection.step)
    text << "at most by " << largest.ratio * length_of(largest) << " m, " << 100.0 * largest.ratio
         << " % (" << name_body(largest) << ", t = " << seen.largest_deflection.step * step_size
         << " s): ";
  text << "cut the blade into about "
       << suggest_bodies(blade_of(largest).bodies, largest.ratio, limit) << " bodies instead of "
       << blade_of(largest).bodies;
  return {WarningKind::linear_range, time, text.str()};
}

Warning warn_of_growth(const Scenario& scenario, double step_size, const Observations& seen) {
  const double time = seen.growth.step * step_size;
  std::ostringstream text;
  text << "at t = " << time << " s " << describe_growth(scenario, seen);
  if (seen.growth.largest_step > seen.growth.step)
    text << ", and by " << seen.growth.largest_residual
         << " J at t = " << seen.growth.largest_step * step_size << " s";
  text << ": take a smaller integration.step";
  if (scenario.integration.method == IntegrationMethod::generalized_alpha)
    text << ", or a smaller integration.spectral_radius";
  return {WarningKind::energy_growth, time, text.str()};
}

}  // namespace

bool is_possible(const Observations& seen, const Rotor& rotor) {
  const auto is_index = [](double value, std::size_t count) {
    return value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value);
  };
  const auto names_body = [&](const Observations::Deflection& at) {
    return at.step >= 0.0 && at.ratio > 0.0 && is_index(at.blade, rotor.blades.size()) &&
           is_index(at.body, static_cast<std::size_t>(
                                 rotor.blades[static_cast<std::size_t>(at.blade)].bodies));
  };
  const bool is_none = seen.first_deflection.step == -1.0 && seen.largest_deflection.step == -1.0;
  return is_none || (names_body(seen.first_deflection) && names_body(seen.largest_deflection));
}

void observe_step(double step, const StepRecord& record, Observations& seen) {
  const LargeDeflection& largest = record.deflection;
  if (largest.ratio == 0.0) return;
  const Observations::Deflection at{step, largest.ratio, static_cast<double>(largest.blade),
                                    static_cast<double>(largest.body)};
  if (seen.first_deflection.step < 0.0) seen.first_deflection = at;
  if (at.ratio > seen.largest_deflection.ratio) seen.largest_deflection = at;
}

void observe_start(double energy, Observations& seen) { seen.energy = {0.0, energy, energy, 0.0}; }

bool observe_energy(double step, const EnergyBalance& balance, double limit, Observations& seen) {
  Observations::Energy& energy = seen.energy;
  if (step == energy.step + 1.0)
    energy.change = std::max(energy.change, std::abs(balance.energy - energy.last));
  energy.step = step;
  energy.last = balance.energy;
  energy.largest = std::max(energy.largest, balance.energy);
  Observations::Growth& growth = seen.growth;
  if (growth.step >= 0.0) {
    if (balance.residual > growth.largest_residual) {
      growth.largest_residual = balance.residual;
      growth.largest_step = step;
    }
    return false;
  }
  if (limit == 0.0 || balance.residual <= limit * energy.largest + 2.0 * energy.change)
    return false;
  growth = {step, balance.residual, energy.largest, balance.residual, step};
  return true;
}

int suggest_bodies(int bodies, double ratio, double limit) {
  constexpr int kMost = 100000;
  // Deflection of the first of n bodies under a curvature that falls as (1 - x/L)^2, by its length.
  const auto share = [](double n) { return (1.0 - (2.0 / 3.0 - 1.0 / (6.0 * n)) / n) / n; };
  int n = bodies;
  while (n < kMost && ratio * share(n) > limit * share(bodies)) ++n;
  return n;
}

std::vector<Warning> make_warnings(const Scenario& scenario, double step_size,
                                   const Observations& seen) {
  std::vector<Warning> warnings;
  if (seen.first_deflection.step >= 0.0 && scenario.limits.deflection > 0.0)
    warnings.push_back(warn_of_deflection(scenario, step_size, seen));
  const bool warns_of_growth = scenario.limits.on_energy_growth == EnergyGrowth::warn;
  if (seen.growth.step >= 0.0 && warns_of_growth)
    warnings.push_back(warn_of_growth(scenario, step_size, seen));
  return warnings;
}

std::string describe_growth(const Scenario& scenario, const Observations& seen) {
  assert(seen.growth.step >= 0.0);
  std::ostringstream text;
  text << "the energy has grown by " << seen.growth.residual
       << " J beyond the work done, more than " << 100.0 * scenario.limits.energy_growth
       << " % of its largest value, " << seen.growth.energy << " J";
  return text.str();
}

}  // namespace spoke
