// Examines each complete step, and words the warnings.

#include "engine/simulation/observations.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "engine/bodies/kernels/plane/suggested_bodies.h"
#include "engine/small_motions/steady/deflection_words.h"
#include "models/plane/beam_properties.h"

namespace spoke {
namespace {

std::string name_body(const Observations::Deflection& seen) {
  std::ostringstream text;
  text << "blade " << seen.subsystem + 1.0 << " / body " << seen.body + 1.0;
  return text.str();
}

/// Warns of the deflection of a body in space.
Warning warn_of_spatial_deflection(const Scenario& scenario, double step_size,
                                   const Observations& seen) {
  const Observations::Deflection &first = seen.first_deflection, &largest = seen.largest_deflection;
  const double limit = scenario.limits.deflection, time = first.step * step_size;
  const auto words_of = [&](const Observations::Deflection& at) {
    return steady::word_deflection(*scenario.space, static_cast<std::size_t>(at.subsystem),
                                   static_cast<std::size_t>(at.body));
  };
  const steady::DeflectionWords of_first = words_of(first), of_largest = words_of(largest);
  std::ostringstream text;
  text << of_first.name << ' ' << of_first.verb << ' ' << 100.0 * first.ratio << " %"
       << of_first.measure << " at t = " << time << " s, more than " << 100.0 * limit
       << " %, up to which its linear elasticity holds; at most by " << 100.0 * largest.ratio
       << " % (" << of_largest.name << ", t = " << largest.step * step_size
       << " s): " << of_largest.advice;
  return {WarningKind::linear_range, time, text.str()};
}

Warning warn_of_deflection(const Scenario& scenario, double step_size, const Observations& seen) {
  if (scenario.space) return warn_of_spatial_deflection(scenario, step_size, seen);
  const double limit = scenario.limits.deflection;
  const auto blade_of = [&](const Observations::Deflection& at) -> const Blade& {
    return scenario.rotor.blades.at(static_cast<std::size_t>(at.subsystem));
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
       << plane::suggest_bodies(blade_of(largest).bodies, largest.ratio, limit)
       << " bodies instead of " << blade_of(largest).bodies;
  return {WarningKind::linear_range, time, text.str()};
}

Warning warn_of_jump(const Jump& jump, double step_size) {
  std::ostringstream text;
  text << "at t = " << jump.time << " s " << jump.text;
  if (jump.duration > 0.0)
    text << " within " << jump.duration << " s, less than " << kLeastSteps << " steps";
  else
    text << " at once";
  text << ": the energy of that comes from nowhere; " << advise_on_jump(jump, step_size);
  return {WarningKind::speed_jump, jump.time, text.str()};
}

/// Returns the name of a subsystem.
std::string name_subsystem(const Scenario& scenario, double index) {
  const auto i = static_cast<std::size_t>(index);
  if (!scenario.space || i < scenario.space->blades.size()) return "blade " + std::to_string(i + 1);
  return scenario.space->subsystems.at(i - scenario.space->blades.size()).name;
}

std::string name_place(const Scenario& scenario, const Observations::Error& error) {
  switch (static_cast<CoordinatePlace>(static_cast<std::int64_t>(error.place))) {
    case CoordinatePlace::hub_position:
      return "the hub's place";
    case CoordinatePlace::hub_rotation:
      return "the hub's rotation";
    default:
      break;
  }
  const std::string body = name_subsystem(scenario, error.subsystem) + " / body " +
                           std::to_string(static_cast<std::int64_t>(error.body) + 1);
  const bool is_joint = error.place == static_cast<double>(CoordinatePlace::joint);
  return is_joint ? "the joint of " + body : "the deformation of " + body;
}

/// Returns the value rounded down to two digits [s].
double round_down(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit) * unit;
}

Warning warn_of_error(const Scenario& scenario, double step_size, const Observations& seen) {
  const StepAccuracy accuracy = make_accuracy(scenario, step_size, seen);
  std::ostringstream text;
  text.precision(2);
  text << "the step is too large for the motion: its estimated error is " << 100.0 * accuracy.error
       << " % ";
  const bool is_angle = seen.error.place == static_cast<double>(CoordinatePlace::hub_rotation);
  text << (is_angle ? "of a radian" : "of a radian or the length") << " a step in "
       << accuracy.place << " at t = ";
  text.precision(6);
  text << accuracy.time << " s, more than " << 100.0 * scenario.limits.step_error
       << " %: take an integration.step of " << accuracy.step << " s or less";
  return {WarningKind::step_error, seen.error.first_step * step_size, text.str()};
}

Warning warn_of_momentum(const Scenario& scenario, double step_size, const Observations& seen) {
  const Observations::Momentum& momentum = seen.momentum;
  const bool is_angular = momentum.is_angular != 0.0;
  std::ostringstream text;
  text << "the " << (is_angular ? "angular momentum" : "momentum")
       << " of the free model, on which nothing acts, has changed by " << momentum.residual
       << (is_angular ? " kg m^2/s" : " kg m/s") << " at t = " << momentum.step * step_size
       << " s, " << 100.0 * momentum.share
       << " % of the largest that its parts have had, more than "
       << 100.0 * scenario.limits.momentum << " %: take a smaller integration.step";
  return {WarningKind::momentum, momentum.first_step * step_size, text.str()};
}

/// Names the loop of a row of a blade or subsystem, `loop "foot"`, or the coupling behind all
/// loops.
template <class Owner>
std::string name_row(const Owner& owner, int row, bool in_plane) {
  for (const Loop& loop : owner.loops) {
    row -= in_plane ? count_locked_in_plane(loop.kind) : count_locked(loop.kind);
    if (row < 0) return "loop \"" + loop.name + '"';
  }
  if constexpr (requires { owner.couplings; })
    if (std::cmp_less(row, owner.couplings.size()))
      return "coupling \"" + owner.couplings[static_cast<std::size_t>(row)].name + '"';
  return "the shaft";  // of a drive train
}

std::string name_row(const Scenario& scenario, double index, double row) {
  const auto i = static_cast<std::size_t>(index);
  const int number = static_cast<int>(row);
  if (!scenario.space) return name_row(scenario.rotor.blades.at(i), number, true);
  const std::vector<spatial::Blade>& blades = scenario.space->blades;
  if (i < blades.size()) return name_row(blades[i], number, false);
  return name_row(scenario.space->subsystems.at(i - blades.size()), number, false);
}

Warning warn_of_loop(const Scenario& scenario, double step_size, const Observations& seen) {
  const Observations::Loop& loop = seen.loop;
  const double time = loop.first_step * step_size;
  std::ostringstream text;
  text.precision(3);
  text << name_row(scenario, loop.subsystem, loop.row) << " of "
       << name_subsystem(scenario, loop.subsystem)
       << " comes to a singular position at t = " << time
       << " s, in which its equations depend on one another: a pivot of theirs is " << loop.left
       << " of that at the start (t = " << loop.step * step_size
       << " s); which way it goes on from there depends on the step: compare a smaller "
          "integration.step";
  return {WarningKind::singular_loop, time, text.str()};
}

Warning warn_of_growth(const Scenario& scenario, double step_size, const std::vector<Jump>& jumps,
                       const Observations& seen) {
  const double time = seen.growth.step * step_size;
  std::ostringstream text;
  text << "at t = " << time << " s " << describe_growth(scenario, seen);
  if (seen.growth.largest_step > seen.growth.step)
    text << ", and by " << seen.growth.largest_residual
         << " J at t = " << seen.growth.largest_step * step_size << " s";
  text << ": " << advise_on_growth(jumps, step_size, seen);
  return {WarningKind::energy_growth, time, text.str()};
}

}  // namespace

bool is_possible(const Observations& seen,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_body,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_loop_row) {
  const auto is_index = [](double value) {
    return value >= 0.0 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
  };
  const auto names_body = [&](const Observations::Deflection& at) {
    return at.step >= 0.0 && at.ratio > 0.0 && is_index(at.subsystem) && is_index(at.body) &&
           has_body(static_cast<std::int64_t>(at.subsystem), static_cast<std::int64_t>(at.body));
  };
  const bool is_none = seen.first_deflection.step == -1.0 && seen.largest_deflection.step == -1.0;
  const Observations::Error& error = seen.error;
  const auto place = static_cast<double>(CoordinatePlace::joint);
  const bool is_of_hub = error.place == 0.0 || error.place == 1.0;
  const bool is_of_body =
      (error.place == place || error.place == place + 1.0) && is_index(error.subsystem) &&
      is_index(error.body) &&
      has_body(static_cast<std::int64_t>(error.subsystem), static_cast<std::int64_t>(error.body));
  if (!is_of_hub && !is_of_body) return false;
  const Observations::Loop& loop = seen.loop;
  const bool is_of_loop =
      is_index(loop.subsystem) && is_index(loop.row) &&
      has_loop_row(static_cast<std::int64_t>(loop.subsystem), static_cast<std::int64_t>(loop.row));
  if (loop.step != -1.0 && !is_of_loop) return false;
  if (loop.step == -1.0 && loop.first_step != -1.0) return false;
  return is_none || (names_body(seen.first_deflection) && names_body(seen.largest_deflection));
}

namespace {

/// Pivots that have fallen to this share make a position nearly singular.
constexpr double kNearlySingular = 1e-3;

void observe_loop(double step, const LoopNearness& record, Observations& seen) {
  Observations::Loop& loop = seen.loop;
  if (record.left >= loop.left) return;
  const double first =
      loop.first_step >= 0.0 || record.left > kNearlySingular ? loop.first_step : step;
  loop = {first, step, record.left, static_cast<double>(record.subsystem),
          static_cast<double>(record.row)};
}

}  // namespace

void observe_step(double step, const StepRecord& record, double error_limit, Observations& seen) {
  const StepError& error = record.error;
  if (error.size > seen.error.size)
    seen.error = {seen.error.first_step,
                  step,
                  error.size,
                  static_cast<double>(error.subsystem),
                  static_cast<double>(error.body),
                  static_cast<double>(error.place)};
  if (seen.error.first_step < 0.0 && error_limit > 0.0 && error.size > error_limit)
    seen.error.first_step = step;
  observe_loop(step, record.loop, seen);
  const LargeDeflection& largest = record.deflection;
  if (largest.ratio == 0.0) return;
  const Observations::Deflection at{step, largest.ratio, static_cast<double>(largest.subsystem),
                                    static_cast<double>(largest.body)};
  if (seen.first_deflection.step < 0.0) seen.first_deflection = at;
  if (at.ratio > seen.largest_deflection.ratio) seen.largest_deflection = at;
}

void observe_start(double energy, Observations& seen) { seen.energy = {0.0, energy, energy, 0.0}; }

double calc_energy_resolution(const Scenario& scenario) {
  double stiffness = 0.0;
  for (const Blade& blade : scenario.rotor.blades)
    for (int body = 0; body < blade.bodies; ++body) {
      const plane::BeamProperties beam = plane::make_beam_properties(blade, body);
      double axial = beam.axial_stiffness, bending = beam.bending_stiffness;
      for (const plane::BeamPiece& piece : beam.pieces) {
        axial = std::max({axial, piece.axial_stiffness[0], piece.axial_stiffness[1]});
        bending = std::max({bending, piece.bending_stiffness[0], piece.bending_stiffness[1]});
      }
      const double l = beam.length / beam.elements;
      stiffness += beam.elements * (axial / l + 12.0 * bending / (l * l * l));
    }
  const double tolerance = scenario.integration.tolerance;
  return stiffness * tolerance * tolerance;
}

bool observe_momentum(double step, const MomentumBalance& balance, double limit,
                      Observations& seen) {
  Observations::Momentum& momentum = seen.momentum;
  momentum.size = std::max(momentum.size, balance.size);
  momentum.angular_size = std::max(momentum.angular_size, balance.angular_size);
  const auto share_of = [](double residual, double size) {
    return size > 0.0 ? residual / size : 0.0;
  };
  const double share = share_of(balance.residual, momentum.size);
  const double angular_share = share_of(balance.angular_residual, momentum.angular_size);
  const bool is_angular = angular_share > share;
  const double larger = std::max(share, angular_share);
  if (larger > momentum.share) {
    momentum.step = step;
    momentum.share = larger;
    momentum.residual = is_angular ? balance.angular_residual : balance.residual;
    momentum.is_angular = is_angular ? 1.0 : 0.0;
  }
  if (momentum.first_step >= 0.0 || limit == 0.0 || larger <= limit) return false;
  momentum.first_step = step;
  return true;
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
  // Where a motion begins, the quadrature of the work may be wrong by this multiple of the change
  // of energy.
  constexpr double kQuadrature = 10.0;
  const double accepted =
      limit.share * energy.largest + kQuadrature * energy.change + limit.resolution;
  if (limit.share == 0.0 || balance.residual <= accepted) return false;
  growth = {step, balance.residual, energy.largest, balance.residual, step};
  return true;
}

StepAccuracy make_accuracy(const Scenario& scenario, double step_size, const Observations& seen) {
  const Observations::Error& error = seen.error;
  if (error.step < 0.0) return {};
  StepAccuracy accuracy{error.size, error.step * step_size, name_place(scenario, error), step_size};
  // The error of a step goes with its third power where the step follows the motion.
  constexpr double kMargin = 0.9;
  const double limit = scenario.limits.step_error;
  if (limit > 0.0) accuracy.step = round_down(kMargin * step_size * std::cbrt(limit / error.size));
  return accuracy;
}

std::vector<Warning> make_warnings(const Scenario& scenario, double step_size,
                                   const std::vector<Jump>& jumps, const Observations& seen) {
  const Limits& limits = scenario.limits;
  std::vector<Warning> warnings;
  if (seen.first_deflection.step >= 0.0 && limits.deflection > 0.0)
    warnings.push_back(warn_of_deflection(scenario, step_size, seen));
  if (seen.growth.step >= 0.0 && limits.on_energy_growth == EnergyGrowth::warn)
    warnings.push_back(warn_of_growth(scenario, step_size, jumps, seen));
  if (!jumps.empty()) warnings.push_back(warn_of_jump(jumps.front(), step_size));
  if (seen.error.first_step >= 0.0 && limits.step_error > 0.0)
    warnings.push_back(warn_of_error(scenario, step_size, seen));
  if (seen.momentum.first_step >= 0.0 && limits.momentum > 0.0)
    warnings.push_back(warn_of_momentum(scenario, step_size, seen));
  if (seen.loop.first_step >= 0.0) warnings.push_back(warn_of_loop(scenario, step_size, seen));
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
  return advise_on_growth(find_jumps(scenario, step_size), step_size, seen);
}

std::string advise_on_growth(const std::vector<Jump>& jumps, double step_size,
                             const Observations& seen) {
  const std::string blamed = blame_jump(jumps, seen.growth.step * step_size, step_size);
  return blamed.empty() ? "take a smaller integration.step" : blamed;
}

}  // namespace spoke
