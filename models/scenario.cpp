// Names of the choices in a scenario.

#include "models/scenario.h"

namespace spoke {

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
