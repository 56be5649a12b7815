// Sums the applied forces from the tips of a tree to the hub.

#include "engine/bodies/kernels/applied_forces.h"

#include <algorithm>

#include "engine/bodies/kernels/hub_solve.h"

namespace spoke {
namespace {

template <class World>
bool is_stiffened(const SubsystemData<World>& data) {
  return std::any_of(data.bodies.begin(), data.bodies.end(), [](const BodyData<World>& body) {
    return static_cast<bool>(body.model->stiffening);
  });
}

/// Notes which bodies have applied forces, on themselves or on what they carry. Returns whether any
/// has.
template <class World>
bool find_sources(SubsystemData<World>& data) {
  bool any = false;
  for (std::size_t j = data.bodies.size(); j-- > 0;) {
    BodyData<World>& body = data.bodies[j];
    body.forces.applied = !body.loads.empty() || !body.drags.empty() || !body.applied.empty();
    any |= body.forces.applied;
    if ((body.forces || has_slide(*body.model)) && body.model->parent >= 0)
      data.bodies[static_cast<std::size_t>(body.model->parent)].forces.carried = true;
  }
  return any;
}

/// Whether the tension of a body depends on what is applied to bodies that it carries.
template <class World>
bool any_body_feels(const SubsystemData<World>& data) {
  return std::any_of(data.bodies.begin(), data.bodies.end(), [](const BodyData<World>& body) {
    return body.forces.carried && body.model->stiffening;
  });
}

void place_element_forces(SubsystemData<Plane>& data) {
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    BodyData<Plane>& body = data.bodies[j];
    if (!body.model->stiffening || !body.forces || !body.element_forces.empty()) continue;
    body.element_forces = ArenaVector<Position>(
        static_cast<std::size_t>(body.model->body->elements) + 1, Position::Zero(), *data.arena);
    data.part_maker.add(data.parts.bodies[j].terms, body.element_forces);
  }
}
void place_element_forces(SubsystemData<Space>&) {}

// Slides that deformation makes are found with the sums.
void add_slides(SubsystemData<Plane>&) {}
void add_slides(SubsystemData<Space>& data) {
  for (BodyData<Space>& body : data.bodies)
    if (body.model->joint.slide) data.part_maker.add(data.parts.applied_forces, body.slide);
}

}  // namespace

template <class World>
void place_applied_forces(StepData<World>& data) {
  bool any_forces = data.has_hub_loads, any_stiffened = false;
  for (SubsystemData<World>& subsystem : data.subsystems) {
    any_forces |= find_sources(subsystem);
    any_stiffened |= is_stiffened(subsystem);
  }
  const bool flies = data.flies && any_stiffened && any_forces;
  for (SubsystemData<World>& subsystem : data.subsystems) {
    if (flies)
      subsystem.flight_acceleration =
          subsystem.rotor < 0
              ? &data.flight_acceleration
              : &data.rotors[static_cast<std::size_t>(subsystem.rotor)].flight_acceleration;
    const bool is_needed = any_body_feels(subsystem) || (flies && find_sources(subsystem));
    if (!is_needed || !subsystem.applied_forces.empty()) continue;
    subsystem.applied_forces = ArenaVector<PositionOf<World>>(
        subsystem.bodies.size() + 1, PositionOf<World>::Zero(), *subsystem.arena);
    subsystem.parts.applied_forces =
        subsystem.part_maker.cover("applied forces", Mark::none, subsystem.applied_forces);
    add_slides(subsystem);
  }
  for (SubsystemData<World>& subsystem : data.subsystems) place_element_forces(subsystem);
}

template <class World>
void calc_flight_acceleration(const System<World>& system, double t,
                              StepData<World>& data) noexcept {
  PositionOf<World> sum = linear(calc_hub_load(system, t, data.hub));
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    if (subsystem.applied_forces.empty()) continue;
    const PositionOf<World>& force = subsystem.applied_forces.back();
    if (subsystem.rotor < 0)
      sum += force;
    else
      sum += data.hub.R.inverse() * PositionOf<World>(subsystem.hub->R * force);
  }
  data.flight_acceleration = sum / data.mass;
  for (RotorData<World>& rotor : data.rotors)
    rotor.flight_acceleration =
        rotor.hub.R.inverse() * PositionOf<World>(data.hub.R * data.flight_acceleration);
}

template <class World>
PartList parts_of_flight_acceleration(const StepData<World>& data) {
  PartList list{data.parts.hub_state};
  for (const SubsystemData<World>& subsystem : data.subsystems)
    if (!subsystem.applied_forces.empty()) list.push_back(subsystem.parts.applied_forces);
  for (const RotorParts& rotor : data.parts.rotors) list.push_back(rotor.hub);
  return list;
}

template void place_applied_forces(StepData<Plane>&);
template void place_applied_forces(StepData<Space>&);
template void calc_flight_acceleration(const System<Plane>&, double, StepData<Plane>&) noexcept;
template void calc_flight_acceleration(const System<Space>&, double, StepData<Space>&) noexcept;
template PartList parts_of_flight_acceleration(const StepData<Plane>&);
template PartList parts_of_flight_acceleration(const StepData<Space>&);

}  // namespace spoke
