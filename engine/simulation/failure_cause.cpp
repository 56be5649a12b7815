// Tests each cause by itself, in their order of priority.

#include "engine/simulation/failure_cause.h"

#include <cmath>
#include <sstream>
#include <type_traits>

#include "engine/bodies/kernels/plane/natural_frequencies.h"
#include "engine/bodies/kernels/plane/suggested_bodies.h"
#include "engine/simulation/jumps.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "models/error.h"

namespace spoke {
namespace {

/// Whether the motion that drive and support prescribe, or the torque that they apply, is finite.
bool is_drive_finite(const Drive& drive, double t, double speed) {
  if (!prescribes_motion(drive))
    return std::isfinite(calc_torque(drive, t, std::isfinite(speed) ? speed : 0.0));
  const DriveMotion motion = calc_motion(drive, t);
  return std::isfinite(motion.angle + motion.speed + motion.acceleration);
}

// The functions below return a likely cause with its numbers and what to try, or an empty text if
// it is not the cause.

template <class World>
std::string blame_input(const SystemContext<World>& context, const FailureSite& site) {
  if (site.has_bad_load)
    return "a factor, force or moment of that load overflows or was no number: correct it";
  if (!is_drive_finite(context.system.hub.drive, failed_progress(context.data).control.time,
                       context.data.hub_coordinates.v[World::kAxial]))
    return "the drive's motion or torque is not finite at this time: correct it";
  return {};
}

std::string blame_rk4(const Scenario& scenario, const SystemContext<Plane>& context) {
  const auto* rk4 = std::get_if<Rk4>(&context.integrator.method);
  if (!rk4) return {};
  const plane::FrequencyRange range = plane::calc_frequency_range(scenario.rotor);
  const Damping& damping = scenario.rotor.damping;
  const Damping total = plane::calc_total_damping(scenario.rotor);
  const double limit = calc_rk4_step_with_drag(range, scenario.rotor);
  if (rk4->step <= limit) return {};
  std::ostringstream text;
  text << "the step of " << rk4->step << " s is above the stability limit of rk4, " << limit
       << " s (";
  const bool damps_beams = !damping.directions.is_zero() || !damping.modes.ratios.empty();
  if (total.stiffness_factor == 0.0 && total.mass_factor == 0.0 && !damps_beams)
    text << "2 sqrt(2) by the highest natural frequency, " << range.highest << " rad/s";
  else
    text << "the highest natural frequency is " << range.highest << " rad/s";
  if (damping.stiffness_factor > 0.0 || damping.mass_factor > 0.0)
    text << ", its damping ratio by [damping] "
         << 0.5 * (damping.mass_factor / range.highest + damping.stiffness_factor * range.highest);
  if (damps_beams) text << ", damped by direction or by mode";
  if (total.mass_factor > damping.mass_factor)
    text << ", and linear drag slows the motion down at up to "
         << total.mass_factor - damping.mass_factor << " 1/s";
  text << "): take a smaller integration.step, or generalized_alpha";
  return text.str();
}

/// Also returns an empty text if the limit is not known.
std::string blame_rk4(const Scenario& scenario, const SystemContext<Space>& context) try {
  constexpr double kNotable = 0.01;  // damping ratio
  const auto* rk4 = std::get_if<Rk4>(&context.integrator.method);
  if (!rk4) return {};
  const vibration::Rk4Limit limit = vibration::find_rk4_limit(scenario);
  if (rk4->step <= limit.step) return {};
  const double size = std::abs(limit.root), ratio = -limit.root.real() / size;
  std::ostringstream text;
  text << "the step of " << rk4->step << " s is above the stability limit of rk4, " << limit.step
       << " s (the fastest small motion";
  if (limit.speed != 0.0) text << " at " << limit.speed << " rad/s";
  text << " has a root of " << size << " rad/s";
  if (ratio > kNotable) text << " and a damping ratio of " << ratio;
  text << "): take a smaller integration.step, or generalized_alpha";
  return text.str();
} catch (const InputError&) {
  return {};
}

std::string blame_stiffening(const Scenario& scenario, const SystemContext<Plane>& context,
                             const FailureSite& site) {
  if (!site.is_known()) return {};
  const Blade& blade = scenario.rotor.blades[static_cast<std::size_t>(site.subsystem)];
  const double speed = std::abs(context.data.hub_coordinates.v[kRotation]);
  if (blade.geometric_stiffening) return {};
  const double first = plane::calc_first_frequency(blade);
  if (speed < 0.5 * first) return {};
  std::ostringstream text;
  text << "without geometric stiffening a body does not feel that rotation stiffens it, and the "
          "hub turns at "
       << speed << " rad/s, " << (speed > first ? "above" : "near")
       << " the blade's first natural frequency of " << first
       << " rad/s: set geometric_stiffening = true, or cut the blade into more bodies";
  return text.str();
}

/// Blames drag, which is not in the implicit part: the iteration contracts by gamma' h times its
/// rate.
std::string blame_drag(const Scenario& scenario, const SystemContext<Plane>& context,
                       const FailedStep& failed) {
  constexpr double kGood = 0.2;
  const auto* method = std::get_if<GeneralizedAlpha>(&context.integrator.method);
  if (failed.outcome == StepOutcome::energy_grew || !method) return {};
  const double rate =
      plane::calc_total_damping(scenario.rotor).mass_factor - scenario.rotor.damping.mass_factor;
  const double contraction = method->velocity_gain * rate;
  if (contraction < (failed.outcome == StepOutcome::not_converged ? 2.0 * kGood : 1.0)) return {};
  std::ostringstream text;
  text << "linear drag slows the motion down at up to " << rate
       << " 1/s, which the iteration has to follow: set integration.step to "
       << kGood / contraction * method->step << " or less";
  return text.str();
}

std::string blame_loop(const FailureSite& site) {
  if (!site.is_loop) return {};
  return "which way the mechanism goes on there depends on the step: take a smaller "
         "integration.step, or keep it away from that position";
}

/// Whether a step that is small enough for the motion has had changes that do not fall. Where they
/// fall slowly, a smaller step helps: what is not in Mhat contracts with it.
bool goes_to_and_fro(const StepProgress& progress) {
  constexpr double kFollows = 2e-4;  // from which error of a step on there is a warning
  const double error = progress.error.size;
  return progress.contraction >= 1.0 && error > 0.0 && error < kFollows;
}

template <class World>
std::string blame_iteration(const SystemContext<World>& context, const FailedStep& failed) {
  constexpr double kRoundOff = 1e-12;  // absolute round-off of coordinates of some metres
  if (failed.outcome != StepOutcome::not_converged) return {};
  const IterationLimits& limits = context.integrator.limits;
  const StepProgress& progress = failed_progress(context.data);
  std::ostringstream text;
  if (progress.change < kRoundOff)
    text << "that is round-off: set integration.tolerance to 1e-12 or more";
  else if (goes_to_and_fro(progress))
    text << "the step follows the motion (its estimated error is " << progress.error.size
         << "), but the changes do not fall: a force there turns or jumps within them, as those of "
            "stops, of air and of loads can, where smaller steps may fail alike: make it "
            "smoother, or set integration.method to rk4";
  else
    text << "the step is too large for generalized_alpha to iterate on: set integration.step to "
         << 0.5 * step_size(context.integrator) << " or less, or integration.max_iterations above "
         << limits.most;
  return text.str();
}

/// Blames bodies that were bent beyond the linear range before.
std::string blame_deflection(const Scenario& scenario, const FailedStep& failed, double step) {
  const Observations::Deflection& largest = failed.seen.largest_deflection;
  if (largest.step < 0.0) return {};
  const Blade& blade = scenario.rotor.blades[static_cast<std::size_t>(largest.subsystem)];
  std::ostringstream text;
  text << "blade " << largest.subsystem + 1.0 << " / body " << largest.body + 1.0 << " had bent by "
       << 100.0 * largest.ratio << " % of its length at t = " << largest.step * step
       << " s, too much for its linear elasticity: cut the blade into about "
       << plane::suggest_bodies(blade.bodies, largest.ratio, scenario.limits.deflection)
       << " bodies instead of " << blade.bodies << ", or take a smaller integration.step";
  return text.str();
}

const char* advise(const SystemContext<Plane>&) {
  return "take a smaller integration.step, more bodies per blade, or smaller loads";
}
const char* advise(const SystemContext<Space>&) {
  return "take a smaller integration.step, more bodies per beam, geometric_stiffening where a body "
         "turns fast, or smaller loads";
}

}  // namespace

template <class World>
std::string find_cause(const Scenario& scenario, const SystemContext<World>& context,
                       const FailedStep& failed, const FailureSite& site) {
  constexpr bool kIsPlane = std::is_same_v<World, Plane>;
  const double h = step_size(context.integrator);
  std::string cause = blame_input(context, site);
  const auto or_else = [&cause](const auto& blame) {
    if (cause.empty()) cause = blame();
  };
  or_else([&] { return blame_jump(find_jumps(scenario, h), failed.time, h); });
  or_else([&] { return blame_loop(site); });
  or_else([&] { return blame_rk4(scenario, context); });
  if constexpr (kIsPlane) or_else([&] { return blame_stiffening(scenario, context, site); });
  if constexpr (kIsPlane) or_else([&] { return blame_drag(scenario, context, failed); });
  or_else([&] { return blame_iteration(context, failed); });
  if constexpr (kIsPlane) or_else([&] { return blame_deflection(scenario, failed, h); });
  if (failed.outcome == StepOutcome::energy_grew)
    or_else([&] { return advise_on_growth(scenario, h, failed.seen); });
  or_else([&] { return std::string(advise(context)); });
  return cause;
}

template std::string find_cause(const Scenario&, const SystemContext<Plane>&, const FailedStep&,
                                const FailureSite&);
template std::string find_cause(const Scenario&, const SystemContext<Space>&, const FailedStep&,
                                const FailureSite&);

}  // namespace spoke
