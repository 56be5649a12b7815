// Finds the place of a failure in the table, and its likely cause.

#include "engine/simulation/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/kernels/body_energies.h"
#include "engine/kernels/deformation_limits.h"
#include "engine/kernels/natural_frequencies.h"
#include "engine/kernels/suggested_bodies.h"
#include "models/count_text.h"

namespace spoke {
namespace {

constexpr const char* kNotFinite = " is not finite";
constexpr const char* kHubAcceleration = "the acceleration of the hub";

/// The body at which a failure showed, and what was found there.
struct FailureSite {
  int subsystem = -1;
  int body = -1;
  std::string quantity;       ///< that failed there
  std::string finding;        ///< what is wrong with it
  const char* node = "";      ///< stage of the graph that works on it
  bool has_bad_load = false;  ///< a load on it is not finite

  bool is_known() const { return subsystem >= 0; }
};

std::string name_blade(const FailureSite& site) {
  return "blade " + std::to_string(site.subsystem + 1);
}

std::string name_body(const FailureSite& site) {
  return name_blade(site) + " / body " + std::to_string(site.body + 1);
}

/// The node of the step graph at which the failure showed.
std::string name_node(const FailureSite& site) {
  if (!site.is_known()) return "hub solve";
  const bool is_of_blade = std::string_view(site.node) == "sensors";
  return (is_of_blade ? name_blade(site) : name_body(site)) + " / " + site.node;
}

/// "axial displacement u of node 3", "deflection v of node 4", "rotation psi of node 0".
std::string name_coordinate(const FlexibleBody& body, int coordinate) {
  static constexpr const char* kNames[] = {"axial displacement u", "deflection v", "rotation psi"};
  for (int node = 0; node <= body.elements; ++node)
    for (int c = 0; c < kTwist; ++c)
      if (body.coordinate(node, c) == coordinate)
        return std::string(kNames[c]) + " of node " + std::to_string(node);
  return "coordinate " + std::to_string(coordinate);
}

std::string describe_violation(const LimitViolation& violation) {
  std::ostringstream text;
  if (std::isfinite(violation.value))
    text << " = " << violation.value << " is beyond what its linear model can mean (limit "
         << violation.limit << ")";
  else
    text << kNotFinite;
  return text.str();
}

/// "the acceleration of the deflection v of node 4", of the first coordinate that has none.
std::string name_acceleration(const BodyData<Plane>& body) {
  const FlexibleBody& model = *body.model->body;
  for (int k = 0; k < model.coordinates(); ++k)
    if (!std::isfinite(body.a_found[body.layout.offset(k)]))
      return "the acceleration of the " + name_coordinate(model, k);
  return "the acceleration of its frame";
}

/// Calls `apply` with the indices and data of each body of the subsystems whose step has failed,
/// root to tip.
template <class Apply>
void for_each_failed(const StepData<Plane>& data, Apply&& apply) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const SubsystemData<Plane>& subsystem = data.subsystems[i];
    if (subsystem.progress->outcome == StepOutcome::done) continue;
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j)
      apply(static_cast<int>(i), static_cast<int>(j), subsystem.bodies[j]);
  }
}

/// The first body with a load that is not finite at the time of the failed pass.
FailureSite find_bad_load(const StepData<Plane>& data) {
  FailureSite found;
  for_each_failed(data, [&](int i, int j, const BodyData<Plane>& body) {
    const double t = data.subsystems[static_cast<std::size_t>(i)].progress->control.time;
    for (const BodyLoad<Plane>& load : body.model->loads) {
      const double sum = load.course->value(t) * (load.force.x() + load.force.y() + load.moment);
      if (std::isfinite(sum) || found.is_known()) continue;
      std::ostringstream text;
      text << "the load at x = " << load.points.front().x << " m in its frame";
      found = {i, j, text.str(), kNotFinite, "mass", true};
    }
  });
  return found;
}

/// The first body with a coordinate that is not finite, or else the one farthest beyond its limit.
FailureSite find_worst(const StepData<Plane>& data) {
  FailureSite worst;
  double largest = 0.0;
  for_each_failed(data, [&](int i, int j, const BodyData<Plane>& body) {
    const LimitViolation violation = find_limit_violation(body);
    if (violation.coordinate < 0) return;
    const double severity =
        std::isfinite(violation.value) ? std::abs(violation.value) / violation.limit : HUGE_VAL;
    if (severity <= largest) return;
    largest = severity;
    worst = {i, j, name_coordinate(*body.model->body, violation.coordinate),
             describe_violation(violation), "recovery"};
  });
  return worst;
}

/// The first body that reported a failure: its accelerations, if its coordinates are fine.
FailureSite find_reported(const StepData<Plane>& data) {
  FailureSite found;
  for_each_failed(data, [&](int i, int j, const BodyData<Plane>& body) {
    if (found.is_known() || body.report.failed == 0.0) return;
    found = {i, j, name_acceleration(body), kNotFinite, "recovery"};
  });
  return found;
}

/// The body of which the last iteration has changed a coordinate most.
FailureSite find_most_changed(const StepData<Plane>& data) {
  FailureSite found;
  double largest = 0.0;
  for_each_failed(data, [&](int i, int j, const BodyData<Plane>& body) {
    if (found.is_known() && body.report.change <= largest) return;
    largest = body.report.change;
    found = {i, j, "change of a coordinate", "", "recovery"};
  });
  return found;
}

/// The body with the largest strain energy.
FailureSite find_most_strained(const StepData<Plane>& data) {
  FailureSite found;
  double largest = -1.0;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j) {
      const double strain = calc_strain_energy(data.subsystems[i].bodies[j]);
      if (strain <= largest) continue;
      largest = strain;
      found = {static_cast<int>(i), static_cast<int>(j), "energy", "", "sensors"};
    }
  return found;
}

FailureSite find_site(const SystemContext<Plane>& context, const FailedStep& failed) {
  const StepData<Plane>& data = context.data;
  if (failed.outcome == StepOutcome::energy_grew) return find_most_strained(data);
  if (failed.outcome == StepOutcome::not_converged) return find_most_changed(data);
  FailureSite site = find_bad_load(data);
  if (!site.is_known()) site = find_worst(data);
  if (!site.is_known()) site = find_reported(data);
  return site;
}

/// Whether drive and support prescribe a motion, or apply a torque, that is not finite.
bool is_drive_finite(const System<Plane>& system, double t, double speed) {
  const Drive& drive = system.hub.drive;
  if (!prescribes_motion(drive)) return std::isfinite(calc_torque(drive, t, speed));
  const DriveMotion motion = calc_motion(drive, t);
  return std::isfinite(motion.angle + motion.speed + motion.acceleration);
}

std::string describe_finding(const Scenario& scenario, const SystemContext<Plane>& context,
                             const FailedStep& failed, const FailureSite& site) {
  std::ostringstream text;
  if (failed.outcome == StepOutcome::energy_grew) {
    text << describe_growth(scenario, failed.seen) << "; " << name_body(site)
         << " is strained most";
  } else if (failed.outcome == StepOutcome::not_converged) {
    const StepProgress& progress = failed_progress(context.data);
    text << "the iteration still changes a coordinate by " << progress.change << " (tolerance "
         << progress.tolerance << ") after " << counted(context.integrator.limits.most, "iteration")
         << ", most in " << name_body(site);
  } else if (site.is_known()) {
    text << name_body(site) << ": " << site.quantity << site.finding;
  } else {
    text << kHubAcceleration << kNotFinite;
  }
  text << " (node \"" << name_node(site) << "\")";
  return text.str();
}

// The causes below say what is likely, with the numbers behind it, and what to try; empty: it is
// not the cause.

std::string blame_input(const SystemContext<Plane>& context, const FailureSite& site) {
  if (site.has_bad_load)
    return "a factor, force or moment of that load overflows or was no number: correct it";
  if (!is_drive_finite(context.system, failed_progress(context.data).control.time,
                       context.data.hub_coordinates.v[kRotation]))
    return "the drive's motion or torque is not finite at this time: correct it";
  return {};
}

std::string blame_rk4(const Scenario& scenario, const SystemContext<Plane>& context) {
  const auto* rk4 = std::get_if<Rk4>(&context.integrator.method);
  if (!rk4) return {};
  const FrequencyRange range = calc_frequency_range(scenario.rotor);
  const Damping& damping = scenario.rotor.damping;
  const Damping total = calc_total_damping(scenario.rotor);
  const double limit = calc_rk4_step_with_drag(range, scenario.rotor);
  if (rk4->step <= limit) return {};
  std::ostringstream text;
  text << "the step of " << rk4->step << " s is above the stability limit of rk4, " << limit
       << " s (";
  if (total.stiffness_factor == 0.0 && total.mass_factor == 0.0)
    text << "2 sqrt(2) by the highest natural frequency, " << range.highest << " rad/s";
  else
    text << "the highest natural frequency is " << range.highest << " rad/s";
  if (damping.stiffness_factor > 0.0 || damping.mass_factor > 0.0)
    text << ", its damping ratio by [damping] "
         << 0.5 * (damping.mass_factor / range.highest + damping.stiffness_factor * range.highest);
  if (total.mass_factor > damping.mass_factor)
    text << ", and linear drag slows the motion down at up to "
         << total.mass_factor - damping.mass_factor << " 1/s";
  text << "): take a smaller integration.step, or generalized_alpha";
  return text.str();
}

std::string blame_stiffening(const Scenario& scenario, const SystemContext<Plane>& context,
                             const FailureSite& site) {
  if (!site.is_known()) return {};
  const Blade& blade = scenario.rotor.blades[static_cast<std::size_t>(site.subsystem)];
  const double speed = std::abs(context.data.hub_coordinates.v[kRotation]);
  if (blade.geometric_stiffening) return {};
  const double first = calc_first_frequency(blade);
  if (speed < 0.5 * first) return {};
  std::ostringstream text;
  text << "without geometric stiffening a body does not feel that rotation stiffens it, and the "
          "hub turns at "
       << speed << " rad/s, " << (speed > first ? "above" : "near")
       << " the blade's first natural frequency of " << first
       << " rad/s: set geometric_stiffening = true, or cut the blade into more bodies";
  return text.str();
}

/// Drag is not in the implicit part: the iteration contracts by gamma' h times its rate.
std::string blame_drag(const Scenario& scenario, const SystemContext<Plane>& context,
                       const FailedStep& failed) {
  constexpr double kGood = 0.2;
  const auto* method = std::get_if<GeneralizedAlpha>(&context.integrator.method);
  if (failed.outcome == StepOutcome::energy_grew || !method) return {};
  const double rate =
      calc_total_damping(scenario.rotor).mass_factor - scenario.rotor.damping.mass_factor;
  const double contraction = method->velocity_gain * rate;
  if (contraction < (failed.outcome == StepOutcome::not_converged ? 2.0 * kGood : 1.0)) return {};
  std::ostringstream text;
  text << "linear drag slows the motion down at up to " << rate
       << " 1/s, which the iteration has to follow: set integration.step to "
       << kGood / contraction * method->step << " or less";
  return text.str();
}

std::string blame_iteration(const SystemContext<Plane>& context, const FailedStep& failed) {
  constexpr double kRoundOff = 1e-12;  // of coordinates of some metres
  if (failed.outcome != StepOutcome::not_converged) return {};
  const IterationLimits& limits = context.integrator.limits;
  std::ostringstream text;
  if (failed_progress(context.data).change < kRoundOff)
    text << "that is round-off: set integration.tolerance to 1e-12 or more";
  else
    text << "the step is too large for generalized_alpha to iterate on: set integration.step to "
         << 0.5 * step_size(context.integrator) << " or less, or integration.max_iterations above "
         << limits.most;
  return text.str();
}

/// Bodies that were bent beyond the linear range before.
std::string blame_deflection(const Scenario& scenario, const FailedStep& failed, double step) {
  const Observations::Deflection& largest = failed.seen.largest_deflection;
  if (largest.step < 0.0) return {};
  const Blade& blade = scenario.rotor.blades[static_cast<std::size_t>(largest.blade)];
  std::ostringstream text;
  text << "blade " << largest.blade + 1.0 << " / body " << largest.body + 1.0 << " had bent by "
       << 100.0 * largest.ratio << " % of its length at t = " << largest.step * step
       << " s, too much for its linear elasticity: cut the blade into about "
       << suggest_bodies(blade.bodies, largest.ratio, scenario.limits.deflection)
       << " bodies instead of " << blade.bodies << ", or take a smaller integration.step";
  return text.str();
}

std::string find_cause(const Scenario& scenario, const SystemContext<Plane>& context,
                       const FailedStep& failed, const FailureSite& site) {
  const double h = step_size(context.integrator);
  for (const std::string& cause :
       {blame_input(context, site), blame_jump(find_jumps(scenario, h), failed.time, h),
        blame_rk4(scenario, context), blame_stiffening(scenario, context, site),
        blame_drag(scenario, context, failed), blame_iteration(context, failed),
        blame_deflection(scenario, failed, h)})
    if (!cause.empty()) return cause;
  if (failed.outcome == StepOutcome::energy_grew) return advise_on_growth(scenario, h, failed.seen);
  return "take a smaller integration.step, more bodies per blade, or smaller loads";
}

Divergence locate(const FailedStep& failed, const FailureSite& site) {
  Divergence at{.time = failed.time, .step = failed.step, .node = name_node(site)};
  if (site.is_known()) {
    at.subsystem = name_blade(site);
    at.body = "body " + std::to_string(site.body + 1);
  }
  at.quantity = site.is_known() ? site.quantity : kHubAcceleration;
  return at;
}

}  // namespace

const StepProgress& failed_progress(const StepTable& data) {
  for (const StepProgress& progress : data.progress)
    if (progress.outcome != StepOutcome::done) return progress;
  return data.progress.front();
}

DivergenceError diagnose(const Scenario& scenario, const SystemContext<Plane>& context,
                         const FailedStep& failed) {
  const FailureSite site = find_site(context, failed);
  std::ostringstream text;
  text << "diverged at t = " << failed.time << " s, step " << failed.step << ": "
       << describe_finding(scenario, context, failed, site) << "; "
       << find_cause(scenario, context, failed, site);
  return DivergenceError(text.str(), locate(failed, site));
}

}  // namespace spoke
