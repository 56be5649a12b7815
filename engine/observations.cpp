#include "engine/observations.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace spoke {
namespace {

std::string name_body(const Bend& bend) {
  std::ostringstream text;
  text << "blade " << bend.blade + 1.0 << " / body " << bend.body + 1.0;
  return text.str();
}

Warning warn_of_bend(const Scenario& scenario, double step_size, const Observations& seen) {
  const double limit = scenario.limits.deflection;
  const auto blade_of = [&](const Bend& bend) -> const Blade& {
    return scenario.rotor.blades.at(static_cast<std::size_t>(bend.blade));
  };
  const auto length_of = [&](const Bend& bend) {
    return blade_of(bend).length / blade_of(bend).bodies;
  };
  const Bend& first = seen.first_bend.bend;
  const Bend& largest = seen.largest_bend.bend;
  const double time = seen.first_bend.step * step_size;
  std::ostringstream text;
  text << name_body(first) << " bends by " << first.ratio * length_of(first) << " m at t = " << time
       << " s, more than " << 100.0 * limit << " % of its length of " << length_of(first)
       << " m, up to which its linear elasticity holds; ";
  if (seen.largest_bend.step > seen.first_bend.step)
    text << "at most by " << largest.ratio * length_of(largest) << " m, " << 100.0 * largest.ratio
         << " % (" << name_body(largest) << ", t = " << seen.largest_bend.step * step_size
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
  const auto names_body = [&](const Observations::Bent& bent) {
    const Bend& bend = bent.bend;
    return bent.step >= 0.0 && bend.ratio > 0.0 && is_index(bend.blade, rotor.blades.size()) &&
           is_index(bend.body, static_cast<std::size_t>(
                                   rotor.blades[static_cast<std::size_t>(bend.blade)].bodies));
  };
  const bool is_none = seen.first_bend.step == -1.0 && seen.largest_bend.step == -1.0;
  return is_none || (names_body(seen.first_bend) && names_body(seen.largest_bend));
}

void observe_step(double step, const StepRecord& record, Observations& seen) {
  if (record.bend.ratio == 0.0) return;
  if (seen.first_bend.step < 0.0) seen.first_bend = {step, record.bend};
  if (record.bend.ratio > seen.largest_bend.bend.ratio) seen.largest_bend = {step, record.bend};
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
  if (seen.first_bend.step >= 0.0 && scenario.limits.deflection > 0.0)
    warnings.push_back(warn_of_bend(scenario, step_size, seen));
  const bool warns_of_growth = scenario.limits.on_energy_growth == EnergyGrowth::warn;
  if (seen.growth.step >= 0.0 && warns_of_growth)
    warnings.push_back(warn_of_growth(scenario, step_size, seen));
  return warnings;
}

std::string describe_growth(const Scenario& scenario, const Observations& seen) {
  std::ostringstream text;
  text << "the energy has grown by " << seen.growth.residual
       << " J beyond the work done, more than " << 100.0 * scenario.limits.energy_growth
       << " % of its largest value, " << seen.growth.energy << " J";
  return text.str();
}

}  // namespace spoke
