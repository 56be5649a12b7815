// Visits the joints of blades, subsystems and the support.

#include "engine/small_motions/steady/friction_at_rest.h"

namespace spoke::steady {
namespace {

/// Calls visit(coordinate) for the coordinates with friction; `model`: may be constant.
template <class Model, class Visit>
void for_frictions(Model& model, const Visit& visit) {
  const auto look = [&visit](auto& joint) {
    for (auto& coordinate : joint.coordinates)
      if (coordinate.friction) visit(coordinate);
  };
  for (auto& blade : model.blades)
    for (auto& outer : blade.joints) look(outer.joint);
  for (auto& subsystem : model.subsystems)
    for (auto& outer : subsystem.joints) look(outer.joint);
}

}  // namespace

bool has_friction(const Scenario& scenario) {
  bool has = false;
  if (scenario.space)
    for_frictions(*scenario.space, [&](const spatial::JointCoordinate&) { has = true; });
  return has;
}

Scenario with_friction_at_rest(const Scenario& scenario) {
  Scenario damped = scenario;
  for_frictions(*damped.space, [](spatial::JointCoordinate& coordinate) {
    const spatial::Friction& friction = *coordinate.friction;
    coordinate.damping += friction.static_force.value_or(friction.force) / friction.speed;
    coordinate.friction.reset();
  });
  return damped;
}

}  // namespace spoke::steady
