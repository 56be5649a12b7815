// Looks at each complete step, and words the warnings.

#include "engine/simulation/observations.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "engine/kernels/suggested_bodies.h"
#include "models/start.h"
#include "models/system/beam_properties.h"

namespace spoke {
namespace {

std::string name_body(const Observations::Deflection& seen) {
  std::ostringstream text;
  text << "blade " << seen.blade + 1.0 << " / body " << seen.body + 1.0;
  return text.str();
}

/// Of a body in space.
Warning warn_of_spatial_deflection(double limit, double step_size, const Observations& seen) {
  const Observations::Deflection &first = seen.first_deflection, &largest = seen.largest_deflection;
  const double time = first.step * step_size;
  std::ostringstream text;
  text << name_body(first) << " bends by " << 100.0 * first.ratio
       << " % of its length at t = " << time << " s, more than " << 100.0 * limit
       << " %, up to which its linear elasticity holds; at most by " << 100.0 * largest.ratio
       << " % (" << name_body(largest) << ", t = " << largest.step * step_size
       << " s): cut the beam into more bodies";
  return {WarningKind::linear_range, time, text.str()};
}

Warning warn_of_deflection(const Scenario& scenario, double step_size, const Observations& seen) {
  if (scenario.space)
    return warn_of_spatial_deflection(scenario.limits.deflection, step_size, seen);
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

/// A change of the prescribed speed.
struct SpeedChange {
  double time = 0.0;      ///< at which it begins [s]
  double duration = 0.0;  ///< [s]
  double change = 0.0;    ///< [rad/s]
};

std::vector<SpeedChange> find_speed_changes(const Drive& drive) {
  if (const auto* spin = std::get_if<SpinUp>(&drive)) return {{0.0, spin->ramp, spin->speed}};
  if (const auto* spin = std::get_if<SpinUpHoldSpinDown>(&drive)) {
    const SpeedChange down{spin->ramp + spin->hold, spin->ramp_down, -spin->speed};
    if (spin->ramp == 0.0) return {down};  // it has begun at its speed
    return {{0.0, spin->ramp, spin->speed}, down};
  }
  std::vector<SpeedChange> changes;
  if (const auto* table = std::get_if<SpeedTable>(&drive)) {
    const std::vector<double>&times = table->speed.times(), &values = table->speed.values();
    for (std::size_t k = 1; k < times.size(); ++k)
      changes.push_back({times[k - 1], times[k] - times[k - 1], values[k] - values[k - 1]});
  }
  return changes;
}

constexpr double kLeastSteps = 4.0;  ///< of a change of the speed

/// The changes within so few steps that they see next to nothing of the drive's work.
std::vector<SpeedChange> find_short_changes(const Scenario& scenario, double step_size) {
  constexpr double kNotable = 0.01;  // by the largest change
  const std::vector<SpeedChange> changes = find_speed_changes(drive_of(scenario));
  double largest = 0.0;
  for (const SpeedChange& change : changes) largest = std::max(largest, std::abs(change.change));
  std::vector<SpeedChange> found;
  for (const SpeedChange& change : changes)
    if (change.duration < kLeastSteps * step_size && change.time < scenario.integration.duration &&
        std::abs(change.change) > kNotable * largest)
      found.push_back(change);
  return found;
}

/// The first one.
std::optional<SpeedChange> find_speed_jump(const Scenario& scenario, double step_size) {
  const std::vector<SpeedChange> changes = find_short_changes(scenario, step_size);
  return changes.empty() ? std::nullopt : std::optional(changes.front());
}

std::string advise_on_jump(const SpeedChange& change, double step_size) {
  std::ostringstream text;
  text << "let the change take " << kLeastSteps * step_size << " s or more";
  // Of a ramp shorter than a step, steps short enough for it are hardly meant.
  if (change.duration > step_size)
    text << ", or take an integration.step of " << change.duration / kLeastSteps << " s or less";
  return text.str();
}

Warning warn_of_speed_jump(const SpeedChange& change, double step_size) {
  std::ostringstream text;
  text << "at t = " << change.time << " s the drive changes the speed by " << change.change
       << " rad/s within " << change.duration << " s, less than " << kLeastSteps
       << " steps: the energy of that comes from nowhere; " << advise_on_jump(change, step_size);
  return {WarningKind::speed_jump, change.time, text.str()};
}

Warning warn_of_growth(const Scenario& scenario, double step_size, const Observations& seen) {
  const double time = seen.growth.step * step_size;
  std::ostringstream text;
  text << "at t = " << time << " s " << describe_growth(scenario, seen);
  if (seen.growth.largest_step > seen.growth.step)
    text << ", and by " << seen.growth.largest_residual
         << " J at t = " << seen.growth.largest_step * step_size << " s";
  text << ": " << advise_on_growth(scenario, step_size, seen);
  return {WarningKind::energy_growth, time, text.str()};
}

}  // namespace

bool is_possible(const Observations& seen,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_body) {
  const auto is_index = [](double value) {
    return value >= 0.0 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
  };
  const auto names_body = [&](const Observations::Deflection& at) {
    return at.step >= 0.0 && at.ratio > 0.0 && is_index(at.blade) && is_index(at.body) &&
           has_body(static_cast<std::int64_t>(at.blade), static_cast<std::int64_t>(at.body));
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

double calc_energy_resolution(const Scenario& scenario) {
  double stiffness = 0.0;
  for (const Blade& blade : scenario.rotor.blades)
    for (int body = 0; body < blade.bodies; ++body) {
      const BeamProperties beam = make_beam_properties(blade, body);
      double axial = beam.axial_stiffness, bending = beam.bending_stiffness;
      for (const BeamPiece& piece : beam.pieces) {
        axial = std::max({axial, piece.axial_stiffness[0], piece.axial_stiffness[1]});
        bending = std::max({bending, piece.bending_stiffness[0], piece.bending_stiffness[1]});
      }
      const double l = beam.length / beam.elements;
      stiffness += beam.elements * (axial / l + 12.0 * bending / (l * l * l));
    }
  const double tolerance = scenario.integration.tolerance;
  return stiffness * tolerance * tolerance;
}

std::vector<SpeedJump> find_speed_jumps(const Scenario& scenario, double step_size) {
  std::vector<SpeedJump> jumps;
  for (const SpeedChange& change : find_short_changes(scenario, step_size))
    jumps.push_back({change.time, change.time + change.duration});
  return jumps;
}

bool observe_energy(double step, const EnergyBalance& balance, const GrowthLimit& limit,
                    Observations& seen) {
  Observations::Energy& energy = seen.energy;
  const double explained = balance.energy - balance.residual;
  if (step == energy.step + 1.0 && !limit.has_jump)
    energy.change = std::max(energy.change, std::abs(explained - energy.last));
  energy.step = step;
  energy.last = explained;
  energy.largest = std::max(energy.largest, explained);
  Observations::Growth& growth = seen.growth;
  if (growth.step >= 0.0) {
    if (balance.residual > growth.largest_residual) {
      growth.largest_residual = balance.residual;
      growth.largest_step = step;
    }
    return false;
  }
  // What the quadrature of the work may be wrong by where a motion begins, by what it finds.
  constexpr double kQuadrature = 10.0;
  const double accepted =
      limit.share * energy.largest + kQuadrature * energy.change + limit.resolution;
  if (limit.share == 0.0 || balance.residual <= accepted) return false;
  growth = {step, balance.residual, energy.largest, balance.residual, step};
  return true;
}

std::vector<Warning> make_warnings(const Scenario& scenario, double step_size,
                                   const Observations& seen) {
  std::vector<Warning> warnings;
  if (seen.first_deflection.step >= 0.0 && scenario.limits.deflection > 0.0)
    warnings.push_back(warn_of_deflection(scenario, step_size, seen));
  const bool warns_of_growth = scenario.limits.on_energy_growth == EnergyGrowth::warn;
  if (seen.growth.step >= 0.0 && warns_of_growth)
    warnings.push_back(warn_of_growth(scenario, step_size, seen));
  if (const auto jump = find_speed_jump(scenario, step_size))
    warnings.push_back(warn_of_speed_jump(*jump, step_size));
  return warnings;
}

std::string describe_growth(const Scenario& scenario, const Observations& seen) {
  assert(seen.growth.step >= 0.0);
  std::ostringstream text;
  text << "the energy has grown by " << seen.growth.residual
       << " J beyond the work done, more than " << 100.0 * scenario.limits.energy_growth
       << " % of the largest energy that start and work explain, " << seen.growth.energy << " J";
  return text.str();
}

std::string advise_on_growth(const Scenario& scenario, double step_size, const Observations& seen) {
  const std::optional<SpeedChange> jump = find_speed_jump(scenario, step_size);
  const double since = jump ? seen.growth.step * step_size - jump->time : -1.0;
  if (since < 0.0 || since > 2.0 * kLeastSteps * step_size)
    return "take a smaller integration.step";
  std::ostringstream text;
  text << "the drive's speed jumps at t = " << jump->time << " s, "
       << advise_on_jump(*jump, step_size);
  return text.str();
}

}  // namespace spoke
