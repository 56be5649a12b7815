// Names what a scenario may say of air.

#include "models/air.h"

namespace spoke::spatial {

std::string_view name_of(Induction induction) {
  return induction == Induction::none ? "none" : "momentum";
}

std::string_view name_of(HighThrust relation) {
  if (relation == HighThrust::buhl) return "buhl";
  return relation == HighThrust::glauert ? "glauert" : "hawc2";
}

std::string_view name_of(MassFlow flow) { return flow == MassFlow::glauert ? "glauert" : "normal"; }

std::string_view name_of(AttachedFlow flow) {
  return flow == AttachedFlow::steady ? "steady" : "unsteady";
}

std::string_view name_of(Inflow inflow) {
  return inflow == Inflow::dynamic ? "dynamic" : "quasi_steady";
}

std::string_view name_of(Stall stall) { return stall == Stall::dynamic ? "dynamic" : "static"; }

std::string_view name_of(TowerPotential potential) {
  if (potential == TowerPotential::none) return "none";
  return potential == TowerPotential::cylinder ? "cylinder" : "bak";
}

std::string_view name_of(TowerShadow shadow) {
  return shadow == TowerShadow::none ? "none" : "powles";
}

}  // namespace spoke::spatial
