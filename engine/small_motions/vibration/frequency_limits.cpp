// Linearises the undeformed model, takes it apart, and asks each part for the ends of its spectrum.

#include "engine/small_motions/vibration/frequency_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/bodies/kernels/plane/natural_frequencies.h"
#include "engine/small_motions/steady/alike_subsystems.h"
#include "engine/small_motions/steady/close_loops.h"
#include "engine/small_motions/steady/find_equilibrium.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/coupled_roots.h"
#include "engine/small_motions/vibration/eigenvalues.h"
#include "engine/small_motions/vibration/extreme_root.h"
#include "models/error.h"
#include "models/tree/tree.h"

namespace spoke::vibration {
namespace {

using steady::LinearModel;

constexpr std::int64_t kMostInSubsystem = 1000;  ///< coordinates of one, for full matrices
constexpr std::int64_t kMostInAll = 100000;      ///< most coordinates of a model

void require_size(const spatial::Model& model) {
  std::int64_t all = 0;
  for (const spatial::Tree& tree : build_trees(model)) {
    const std::int64_t own = count_coordinates(tree);
    all += own;
    if (own > kMostInSubsystem)
      throw InputError("the frequencies of \"" + tree.name + "\" are not computed: it has " +
                       std::to_string(own) + " coordinates, expected at most " +
                       std::to_string(kMostInSubsystem));
  }
  if (all > kMostInAll)
    throw InputError("frequencies are not computed of " + std::to_string(all) +
                     " coordinates, expected at most " + std::to_string(kMostInAll));
}

/// Lets a course stay where it is at t = 0, if it is no table, which comes to rest by itself.
void hold(spatial::VectorCourse& course) {
  auto* harmonic = std::get_if<spatial::VectorHarmonic>(&course);
  if (!harmonic) return;
  harmonic->constant += std::sin(harmonic->phase) * harmonic->amplitude;
  harmonic->rate.setZero();
  harmonic->amplitude.setZero();
}

/// Returns the scenario without the motion of the mount and the vibration of anchors, which are
/// none of the model's.
Scenario without_motion(const Scenario& scenario) {
  Scenario held = scenario;
  held.space->hub.mount.reset();
  for (Anchor& anchor : held.space->anchors)
    if (auto* motion = std::get_if<spatial::MountMotion>(&anchor.motion))
      for (spatial::VectorCourse* course : {&motion->translation, &motion->rotation}) hold(*course);
  return held;
}

/// Linearises the parts of the model with `share` of loads, gravity and the squares of the speeds
/// of rotors.
std::vector<LinearModel> linearize_parts(const Scenario& scenario,
                                         const std::vector<double>& speeds, double share) {
  const std::unique_ptr<steady::SteadyModel> model =
      steady::make_steady_model(scenario, steady::at_speeds(speeds, {.holds_forces = true}));
  model->set_share(share);
  steady::Equilibrium start;
  start.alike = steady::find_alike(*model);
  for (std::size_t i = 0; i < model->subsystems(); ++i) {
    start.q.push_back(model->initial(i));
    start.rows.push_back(steady::close_loops(i, *model, start.q.back()));
    start.multipliers.emplace_back();
    model->settle(i, start.q.back());
  }
  start.wrench = steady::HubVector::Zero(model->twist_size());
  if (const steady::SupportedModel* machine = model->on_support())
    start.wrenches.assign(machine->rotors(), start.wrench);
  LinearModel linear = steady::linearize_machine(start, *model);
  // What turns is seen as it stands: that moves frequencies by the speed at most.
  if (linear.support) steady::stand_on(*linear.support, linear);
  return take_apart(linear, model->azimuths());
}

/// Returns the root below which motions are round-off: they do not change within the whole
/// duration.
double least_root(const Scenario& scenario) { return 1e-6 / scenario.integration.duration; }

/// Returns the largest stable step for a root. A motion that grows counts like one that decays as
/// fast.
double rk4_step_of(std::complex<double> root) {
  return plane::calc_rk4_limit({-std::abs(root.real()), root.imag()});
}

Rk4Limit find_rk4_limit_of(const std::vector<LinearModel>& parts, double speed, double least) {
  Rk4Limit limit{std::numeric_limits<double>::infinity(), speed, 0.0};
  for (const LinearModel& part : parts) {
    const std::complex<double> root = find_extreme_root(
        Pencil(part), [](std::complex<double> s) { return 1.0 / rk4_step_of(s); });
    if (std::abs(root) < least || rk4_step_of(root) >= limit.step) continue;
    limit = {rk4_step_of(root), speed, root};
  }
  return limit;
}

void drop_damping(LinearModel& model) {
  model.C.setZero();
  for (steady::LinearSubsystem& subsystem : model.subsystems) subsystem.C.setZero();
  for (steady::HubCoupling& coupling : model.couplings) {
    coupling.C_bh.setZero();
    coupling.C_hb.setZero();
  }
}

/// Returns the lowest root of the motions that something holds [rad/s]; 0 if there is none.
double find_lowest(const Pencil& pencil, double least) {
  for (Eigen::Index count = 8; pencil.size() > 0; count *= 2) {
    for (const Root& root : find_roots(pencil, std::min(count, pencil.size())))
      if (std::abs(root.s) >= least) return std::abs(root.s);
    if (count >= pencil.size()) break;
  }
  return 0.0;
}

struct LargestSpeed {
  double operator()(const SpinUp& drive) const { return drive.speed; }
  double operator()(const SpinUpHoldSpinDown& drive) const { return drive.speed; }
  double operator()(const SpeedTable& drive) const {
    const auto [least, most] = std::minmax_element(drive.speed.values().begin(),  //
                                                   drive.speed.values().end());
    return std::abs(*least) > std::abs(*most) ? *least : *most;
  }
  template <class Other>
  double operator()(const Other& drive) const {
    return calc_initial_speed(drive);
  }
};

double largest_speed(const spatial::Hub& hub) {
  if (hub.support == HubSupport::free) return hub.angular_velocity.dot(hub.axis.normalized());
  return std::visit(LargestSpeed{}, hub.drive);
}

/// Returns that of each rotor.
std::vector<double> largest_speeds(const spatial::Model& model) {
  std::vector<double> speeds;
  for (int r = 0; r < count_rotors(model); ++r) speeds.push_back(largest_speed(hub_of(model, r)));
  return speeds;
}

/// Returns the smaller one of the limit at rest, of `parts`, and the limit at the largest speed.
Rk4Limit find_least(const Scenario& scenario, const std::vector<LinearModel>& parts) {
  constexpr double kNotable = 0.999;
  const double least = least_root(scenario);
  const std::vector<double> speeds = largest_speeds(*scenario.space);
  const Rk4Limit at_rest = find_rk4_limit_of(parts, 0.0, least);
  if (std::all_of(speeds.begin(), speeds.end(), [](double speed) { return speed == 0.0; }))
    return at_rest;
  const Rk4Limit turning =
      find_rk4_limit_of(linearize_parts(scenario, speeds, 1.0), speeds.front(), least);
  return turning.step < kNotable * at_rest.step ? turning : at_rest;
}

}  // namespace

FrequencyLimits find_frequency_limits(const Scenario& scenario) {
  require_size(*scenario.space);
  const Scenario held = without_motion(scenario);
  std::vector<LinearModel> parts = linearize_parts(held, {0.0}, 0.0);
  FrequencyLimits limits;
  limits.rk4 = find_least(held, parts);
  for (LinearModel& part : parts) {
    drop_damping(part);
    const Pencil pencil(part);
    const double lowest = find_lowest(pencil, least_root(scenario));
    if (lowest > 0.0 && (limits.lowest == 0.0 || lowest < limits.lowest)) limits.lowest = lowest;
    const auto magnitude = [](std::complex<double> s) { return std::abs(s); };
    limits.highest = std::max(limits.highest, std::abs(find_extreme_root(pencil, magnitude)));
  }
  if (limits.highest < least_root(scenario)) limits.highest = 0.0;
  return limits;
}

Rk4Limit find_rk4_limit(const Scenario& scenario) {
  require_size(*scenario.space);
  const Scenario held = without_motion(scenario);
  return find_least(held, linearize_parts(held, {0.0}, 0.0));
}

}  // namespace spoke::vibration
