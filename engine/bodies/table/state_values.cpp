// Takes and puts the values of a state, and hashes them.

#include "engine/bodies/table/state_values.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <span>
#include <type_traits>

#include "engine/support/hash.h"

namespace spoke {
namespace {

std::uint64_t hash(std::uint64_t value, const double* first, int count) {
  return hash_bytes(first, static_cast<std::size_t>(count) * sizeof(double), value);
}

/// Returns a whole number; -1 if the value, which a file may hold, is none.
int to_whole(double value) {
  return value >= 0.0 && value <= std::numeric_limits<int>::max() ? static_cast<int>(value) : -1;
}

template <class World>
constexpr bool has_attitude = !std::is_empty_v<typename BodyTypes<World>::Attitude>;

/// Lets `exchange` take each value of a record as it stands in the state, or put it there; some are
/// no doubles in the table.
template <class World, class Exchange>
void for_each_value(SystemRecord<World>& record, Exchange&& exchange) {
  const auto exchange_whole = [&](auto& whole) {
    double value = static_cast<double>(whole);
    exchange(value);
    whole = to_whole(value);
  };
  const auto exchange_all = [&](TwistOf<World>& twist) {
    for (double& value : twist) exchange(value);
  };
  StepRecord& step = record.step;
  exchange_whole(step.passes);
  exchange(step.work);
  exchange(step.dissipated);
  exchange_all(record.reaction);
  exchange(step.deflection.ratio);
  exchange_whole(step.deflection.subsystem);
  exchange_whole(step.deflection.body);
  exchange(record.applied_torque);
  exchange_all(record.position);
  exchange_all(record.velocity);
  if constexpr (has_attitude<World>) {
    for (double& value : record.hub_rotation.axes.reshaped()) exchange(value);
    exchange(record.hub_rotation.mount_spin);
  }
}

/// Calls `exchange` with each value of the hub of a rotor on a support, of a record.
template <class World, class Exchange>
void for_each_value(RotorRecord<World>& record, Exchange&& exchange) {
  for (TwistOf<World>* twist : {&record.position, &record.velocity, &record.reaction})
    for (double& value : *twist) exchange(value);
  exchange(record.applied_torque);
  if constexpr (has_attitude<World>) {
    for (double& value : record.rotation.axes.reshaped()) exchange(value);
    exchange(record.rotation.mount_spin);
  }
}

/// Calls `exchange` with each value of the records of a step.
template <class World, class Exchange>
void for_each_value(std::int64_t step, StepData<World>& data, Exchange&& exchange) {
  for_each_value(of_step(data.records, step), exchange);
  for (RotorData<World>& rotor : data.rotors)
    for_each_value(of_step(rotor.records, step), exchange);
}

template <class Apply>
void apply_to_block(const CoordinateBlock& block, Apply&& apply) {
  const auto size = static_cast<std::size_t>(block.size);
  for (double* vector : {block.q, block.v, block.a}) apply(std::span(vector, size));
  for (double* vector : block.history)
    if (vector) apply(std::span(vector, size));
}

template <class Apply>
void apply_to_joint(BodyData<Plane>&, Apply&&) {}
template <class Apply>
void apply_to_joint(BodyData<Space>& body, Apply&& apply) {
  if (body.joint.coordinates.size == 0) return;
  apply_to_block(body.joint.coordinates, apply);
  apply(doubles(*body.joint.rotation));
}

/// Calls `apply` with each range of doubles of the state that is one subsystem's.
template <class World, class Apply>
void for_each_state_part(SubsystemData<World>& subsystem, Apply&& apply) {
  apply(doubles(subsystem.prescribed));
  apply(doubles(subsystem.root_load));
  apply(doubles(subsystem.joint_loads[0], subsystem.joint_loads.size()));
  if (ArenaVector<double>& kept = subsystem.loops.kept_multipliers; !kept.empty())
    apply(doubles(kept[0], kept.size()));
  for (const std::span<double> of_actor : subsystem.saved) apply(of_actor);
  for (BodyData<World>& body : subsystem.bodies) {
    apply_to_joint(body, apply);
    apply_to_block(body.coordinates, apply);
  }
}

/// Calls `apply` with each range of doubles of the state but those of the record, which
/// `apply_to_record` comes to in their place.
template <class World, class Apply, class ApplyToRecord>
void for_each_state_part(StepData<World>& data, Apply&& apply, ApplyToRecord&& apply_to_record) {
  apply(doubles(data.hub_storage[0], data.hub_storage.size()));
  apply(doubles(data.hub));
  for (RotorData<World>& rotor : data.rotors) apply(doubles(rotor.hub));
  if constexpr (has_attitude<World>) apply(doubles(data.hub_attitude));
  apply_to_record();
  for (StepProgress& progress : data.progress) {
    apply(doubles(progress.power));
    apply(doubles(progress.remembered));
  }
  for (SubsystemData<World>& subsystem : data.subsystems) for_each_state_part(subsystem, apply);
}

}  // namespace

template <class World>
std::size_t count_state_values(StepData<World>& data) {
  std::size_t count = 0;
  for_each_state_part(
      data, [&](std::span<const double> part) { count += part.size(); },
      [&] { for_each_value(0, data, [&](double) { ++count; }); });
  return count;
}

template <class World>
void StepData<World>::take_state(std::int64_t step, std::vector<double>& values) {
  assert(step >= 0);
  values.clear();
  values.reserve(count_state_values(*this));
  for_each_state_part(
      *this,
      [&](std::span<const double> part) { values.insert(values.end(), part.begin(), part.end()); },
      [&] { for_each_value(step, *this, [&](double value) { values.push_back(value); }); });
}

template <class World>
void StepData<World>::put_state(std::span<const double> values, std::int64_t step) {
  assert(values.size() == count_state_values(*this));
  const double* next = values.data();
  for_each_state_part(
      *this,
      [&](std::span<double> part) {
        std::copy_n(next, part.size(), part.begin());
        next += part.size();
      },
      [&] { for_each_value(step, *this, [&](double& value) { value = *next++; }); });
}

std::vector<double> take_state_values(std::int64_t step, StepTable& data) {
  std::vector<double> values;
  data.take_state(step, values);
  return values;
}

template <class World>
std::vector<std::span<std::byte>> state_of_subsystem(StepData<World>& data, std::size_t i) {
  std::vector<std::span<std::byte>> memory;
  for_each_state_part(data.subsystems[i], [&](std::span<double> part) {
    memory.push_back(std::as_writable_bytes(part));
  });
  return memory;
}

namespace {

void hash_joint(const BodyData<Plane>&, std::uint64_t&) {}
void hash_joint(const BodyData<Space>& body, std::uint64_t& value) {
  const CoordinateBlock& block = body.joint.coordinates;
  value = hash(value, block.q, block.size);
  value = hash(value, block.v, block.size);
}

}  // namespace

template <class World>
std::uint64_t hash_state(const StepData<World>& data) {
  std::uint64_t value = hash_bytes(data.hub_coordinates.q, World::kTwist * sizeof(double));
  value = hash(value, data.hub_coordinates.v, World::kTwist);
  if constexpr (has_attitude<World>) value = hash(value, &data.hub_attitude.reference.w, 4);
  for (const SubsystemData<World>& subsystem : data.subsystems)
    for (const BodyData<World>& body : subsystem.bodies) {
      hash_joint(body, value);
      for (const double* flex : {body.coordinates.q, body.coordinates.v})
        body.layout.for_parts([&](int first, int n) { value = hash(value, flex + first, n); });
    }
  return value;
}

template void StepData<Plane>::take_state(std::int64_t, std::vector<double>&);
template void StepData<Space>::take_state(std::int64_t, std::vector<double>&);
template void StepData<Plane>::put_state(std::span<const double>, std::int64_t);
template void StepData<Space>::put_state(std::span<const double>, std::int64_t);
template std::vector<std::span<std::byte>> state_of_subsystem(StepData<Plane>&, std::size_t);
template std::vector<std::span<std::byte>> state_of_subsystem(StepData<Space>&, std::size_t);
template std::size_t count_state_values(StepData<Plane>&);
template std::size_t count_state_values(StepData<Space>&);
template std::uint64_t hash_state(const StepData<Plane>&);
template std::uint64_t hash_state(const StepData<Space>&);

}  // namespace spoke
