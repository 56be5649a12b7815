// Names of the choices in a scenario, and what it has.

#include "models/scenario.h"

#include <algorithm>

namespace spoke {

bool has_loops(const Scenario& scenario) {
  const auto are_any = [](const auto& items) {
    return std::any_of(items.begin(), items.end(), [](const auto& item) {
      if constexpr (requires { item.couplings; })
        if (!item.couplings.empty()) return true;
      return !item.loops.empty();
    });
  };
  if (!scenario.space) return are_any(scenario.rotor.blades);
  return are_any(scenario.space->blades) || are_any(scenario.space->subsystems);
}

std::string_view name_of(IntegrationMethod method) {
  return method == IntegrationMethod::rk4 ? "rk4" : "generalized_alpha";
}

std::string_view name_of(IterationGoal goal) {
  return goal == IterationGoal::tolerance ? "tolerance" : "error";
}

IterationGoal goal_of(const Integration& integration) {
  if (integration.iterate_to) return *integration.iterate_to;
  const bool is_default = integration.tolerance == Integration{}.tolerance;
  return is_default ? IterationGoal::error : IterationGoal::tolerance;
}

std::string_view name_of(InitialState state) {
  return state == InitialState::equilibrium ? "equilibrium" : "undeformed";
}

std::string_view name_of(EnergyGrowth growth) {
  return growth == EnergyGrowth::stop ? "stop" : "warn";
}

std::string_view name_of(HubSupport support) {
  return support == HubSupport::free ? "free" : "axle";
}

std::string_view name_of(ReferenceFrame frame) {
  return frame == ReferenceFrame::chord ? "chord" : "clamped";
}

std::string_view name_of(BeamStrain strain) {
  if (strain == BeamStrain::automatic) return "automatic";
  return strain == BeamStrain::nonlinear ? "nonlinear" : "linear";
}

std::string_view name_of(DragFrame frame) { return frame == DragFrame::hub ? "hub" : "inertial"; }

std::string_view name_of(LoadFrame frame) {
  switch (frame) {
    case LoadFrame::inertial:
      return "inertial";
    case LoadFrame::section:
      return "section";
    case LoadFrame::hub:
      break;
  }
  return "hub";
}

}  // namespace spoke
