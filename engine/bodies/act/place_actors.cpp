// The list of the actors. One that is added here takes part in all that the table does.

#include "engine/bodies/act/place_actors.h"

#include <memory>

#include "engine/bodies/act/air/air_on_blades.h"
#include "engine/bodies/act/drag/drag_on_bodies.h"
#include "engine/bodies/act/pitch_control/pitch_controllers.h"
#include "engine/bodies/act/relaxing_springs/relaxing_springs.h"

namespace spoke {
namespace {

template <class Kind>
void place(const System<Space>& system, StepData<Space>& data) {
  if (Kind::acts(system)) data.actors.push_back(std::make_unique<Kind>(system, data));
}

}  // namespace

std::size_t count_actor_values(const Subsystem<Space>& subsystem) {
  return AirOnBlades::count_values(subsystem) + PitchControllers::count_values(subsystem);
}

void place_actors(const System<Plane>&, StepData<Plane>&) {}

void place_actors(const System<Space>& system, StepData<Space>& data) {
  place<AirOnBlades>(system, data);
  place<PitchControllers>(system, data);
  place<RelaxingSprings>(system, data);
  place<DragOnBodies>(system, data);
}

}  // namespace spoke
