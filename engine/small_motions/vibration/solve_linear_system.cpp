// Takes a scenario to its state-space matrices: equilibrium, linearisation, frame.

#include <algorithm>

#include "engine/linearize.h"
#include "engine/small_motions/steady/describe_equilibrium.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/linear_system.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/multi_blade_system.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

ModeFrame choose_frame(const Scenario& scenario, const std::vector<double>& speeds,
                       std::optional<ModeFrame> asked) {
  if (asked == ModeFrame::floquet)
    throw InputError(
        "in the frame \"floquet\" matrices are not constant, expected \"turning\" or \"fixed\"");
  if (asked) return *asked;
  const bool is_supported = scenario.space && scenario.space->support;
  const bool turns = std::any_of(speeds.begin(), speeds.end(), [](double w) { return w != 0.0; });
  return is_supported && turns ? ModeFrame::fixed : ModeFrame::turning;
}

}  // namespace

LinearSystem solve_linear_system(const Scenario& scenario, const SteadyState& state,
                                 std::optional<ModeFrame> asked) {
  check_scenario(scenario);
  const std::vector<double> speeds = steady::find_steady_speeds(scenario, state);
  const bool is_fixed = choose_frame(scenario, speeds, asked) == ModeFrame::fixed;
  const std::unique_ptr<steady::SteadyModel> model = steady::make_steady_model(
      scenario, steady::at_speeds(speeds, {.is_axial = is_fixed, .has_outputs = true}));
  const steady::Equilibrium equilibrium = steady::find_machine_equilibrium(*model);
  steady::require_steady_machine(*model, equilibrium);
  LinearSystem system;
  if (is_fixed) {
    const steady::LinearModel linear = steady::linearize_machine(equilibrium, *model);
    system = vibration::make_multi_blade_system(scenario, {*model, equilibrium, linear});
  } else {
    system = steady::make_turning_system(scenario, equilibrium, *model);
  }
  system.equilibrium = describe(equilibrium, *model);
  steady::add_warnings(scenario, system.equilibrium);
  return system;
}

}  // namespace spoke
