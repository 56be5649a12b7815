// Steps and states of the table as a whole.

#include "engine/bodies/table/step_data.h"

#include <algorithm>
#include <cassert>

namespace spoke {
namespace {

/// Calls `apply` with the blocks of coordinates of the joint that carries a body.
void for_joint_block(BodyData<Plane>&, const std::function<void(CoordinateBlock&)>&) {}
void for_joint_block(BodyData<Space>& body, const std::function<void(CoordinateBlock&)>& apply) {
  if (body.joint.coordinates.size > 0) apply(body.joint.coordinates);
}

}  // namespace

template <class World>
std::int64_t StepData<World>::passes_of(std::size_t index, std::int64_t step) const {
  assert(is_coupled ? index == 0 : index < subsystems.size());
  return is_coupled ? of_step(records, step).step.passes
                    : of_step(subsystems[index].records, step).step.passes;
}

template <class World>
std::int64_t StepData<World>::most_passes_of(std::int64_t step) const {
  return of_step(records, step).step.passes;
}

template <class World>
void StepData<World>::for_each_block(const std::function<void(CoordinateBlock&)>& apply) {
  apply(hub_coordinates);
  for (SubsystemData<World>& subsystem : subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      for_joint_block(body, apply);
      apply(body.coordinates);
    }
}

template <class World>
std::vector<std::span<std::byte>> StepData<World>::state_memory() {
  return all_parts.marked(Mark::state);
}

template <class World>
void StepData<World>::keep_record(std::int64_t step) {
  kept_ = of_step(records, step);
  for (RotorData<World>& rotor : rotors) rotor.kept = of_step(rotor.records, step);
}

template <class World>
void StepData<World>::take_evaluated_record(std::int64_t step) {
  evaluated = of_step(records, step);
  for (RotorData<World>& rotor : rotors) rotor.evaluated = of_step(rotor.records, step);
}

template <class World>
void StepData<World>::return_record(std::int64_t step) {
  of_step(records, step) = kept_;
  for (RotorData<World>& rotor : rotors) of_step(rotor.records, step) = rotor.kept;
}

template <class World>
bool StepData<World>::has_loads() const {
  return std::any_of(actors.begin(), actors.end(),
                     [](const auto& actor) { return actor->calls_user(); });
}

template <class World>
bool StepData<World>::is_any_load_failed() const {
  return std::any_of(actors.begin(), actors.end(),
                     [](const auto& actor) { return actor->has_failed(); });
}

template <class World>
void StepData<World>::clear_load_failures() {
  for (const auto& actor : actors) actor->clear_failures();
}

namespace {

bool is_acted_on(const BodyData<Plane>& body) { return !body.applied.empty(); }
bool is_acted_on(const BodyData<Space>& body) {
  return !body.applied.empty() || !body.joint.added.empty();
}

}  // namespace

template <class World>
PartList loads_on(std::size_t i, std::size_t j, const StepData<World>& data) {
  PartList list;
  if (!is_acted_on(data.subsystems[i].bodies[j])) return list;  // spares a look at all markers
  for (const auto& actor : data.actors)
    actor->list_parts_on(static_cast<int>(i), static_cast<int>(j), list);
  return list;
}

template <class World>
PartList courses_of(std::size_t i, const StepData<World>& data) {
  PartList list;
  for (const auto& actor : data.actors) actor->list_courses(static_cast<int>(i), list);
  return list;
}

template class StepData<Plane>;
template class StepData<Space>;
template PartList loads_on(std::size_t, std::size_t, const StepData<Plane>&);
template PartList loads_on(std::size_t, std::size_t, const StepData<Space>&);
template PartList courses_of(std::size_t, const StepData<Plane>&);
template PartList courses_of(std::size_t, const StepData<Space>&);

}  // namespace spoke
