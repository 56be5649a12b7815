// Finds the equilibrium of a scenario's model, and whether small motions about it decay.

#include <complex>

#include "engine/equilibrium.h"
#include "engine/small_motions/steady/describe_equilibrium.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/choose_frame.h"
#include "engine/small_motions/vibration/solve_modes.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

/// Tells by the lowest modes whether small motions decay.
Stability judge(const ModesResult& found) {
  constexpr double kRoundOff = 1e-6;  // of a real part, by the eigenvalue, as in Mode::grows()
  // By the damping, not by the rate: that of a slow mode is small whatever its damping.
  const auto growth = [](const Mode& mode) {
    return mode.eigenvalue == 0.0 ? 0.0 : mode.eigenvalue.real() / std::abs(mode.eigenvalue);
  };
  const Mode* most = &found.modes[0];
  for (const Mode& mode : found.modes)
    if (growth(mode) > growth(*most)) most = &mode;
  Stability stability{SmallMotions::persist, most->eigenvalue.real(), most->frequency, most->name,
                      most->of};
  if (most->grows()) stability.motions = SmallMotions::grow;
  if (growth(*most) < -kRoundOff) stability.motions = SmallMotions::decay;
  return stability;
}

/// Tells whether small motions decay, or why that is not known: they have no constant matrices, or
/// loops are in a singular position.
void add_stability(const Scenario& scenario, const steady::Equilibrium& equilibrium,
                   steady::SteadyModel& model, EquilibriumResult& result) {
  const ModeFrame frame =
      model.turns() ? vibration::choose_frame(scenario, std::nullopt) : ModeFrame::turning;
  try {
    steady::LinearModel linear = steady::linearize_machine(equilibrium, model);
    if (linear.support && frame == ModeFrame::turning) steady::stand_on(*linear.support, linear);
    result.stability = judge(vibration::make_modes(linear, equilibrium, frame, {}, model));
  } catch (const InputError& error) {
    result.stability_unknown = error.what();
  }
}

}  // namespace

EquilibriumResult solve_equilibrium(const Scenario& scenario, const SteadyState& state) {
  check_scenario(scenario);
  const std::unique_ptr<steady::SteadyModel> model = steady::make_steady_model(
      scenario, steady::at_speeds(steady::find_steady_speeds(scenario, state)));
  if (model->is_hub_free())
    throw InputError("hub.support: the hub is free, expected an axle: nothing holds the model");
  const steady::Equilibrium found = steady::find_machine_equilibrium(*model);
  steady::require_held(found);
  EquilibriumResult result = steady::describe(found, *model);
  add_stability(scenario, found, *model, result);
  steady::add_warnings(scenario, result);
  return result;
}

}  // namespace spoke
