// Takes and puts the values of a state, and hashes them.

#include "engine/table/state_values.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <span>

namespace spoke {
namespace {

std::uint64_t hash(std::uint64_t value, const double* first, int count) {
  constexpr std::uint64_t kPrime = 1099511628211u;
  const auto* bytes = reinterpret_cast<const unsigned char*>(first);
  for (std::size_t k = 0; k < count * sizeof(double); ++k) value = (value ^ bytes[k]) * kPrime;
  return value;
}

/// The values of a record that are not doubles in the table are so in the state.
constexpr std::size_t kRecordValues = 16;
using RecordValues = std::array<double, kRecordValues>;

RecordValues values_of(const SystemRecord& record) {
  const StepRecord& step = record.step;
  const LargeDeflection& at = step.deflection;
  const Twist &f = step.reaction, &x = record.position, &v = record.velocity;
  return {static_cast<double>(step.passes),
          step.work,
          step.dissipated,
          f[0],
          f[1],
          f[2],
          at.ratio,
          static_cast<double>(at.blade),
          static_cast<double>(at.body),
          record.applied_torque,
          x[0],
          x[1],
          x[2],
          v[0],
          v[1],
          v[2]};
}

/// A whole number; -1 for what a file may hold instead of one.
int to_whole(double value) {
  return value >= 0.0 && value <= std::numeric_limits<int>::max() ? static_cast<int>(value) : -1;
}

SystemRecord make_record(const RecordValues& value) {
  SystemRecord record;
  record.step.passes = to_whole(value[0]);
  record.step.work = value[1];
  record.step.dissipated = value[2];
  record.step.reaction = {value[3], value[4], value[5]};
  record.step.deflection = {value[6], to_whole(value[7]), to_whole(value[8])};
  record.applied_torque = value[9];
  record.position = {value[10], value[11], value[12]};
  record.velocity = {value[13], value[14], value[15]};
  return record;
}

/// Calls `apply` with each range of doubles of the state. Those of the step's record are `record`.
template <class Apply>
void for_each_state_part(StepData& data, RecordValues& record, Apply&& apply) {
  apply(doubles(data.hub_storage[0], data.hub_storage.size()));
  apply(doubles(data.hub));
  apply(std::span<double>(record));
  for (StepProgress& progress : data.progress) apply(doubles(progress.power));
  for (SubsystemData& subsystem : data.subsystems) {
    apply(doubles(subsystem.prescribed));
    apply(doubles(subsystem.root_load));
    apply(doubles(subsystem.joint_loads[0], subsystem.joint_loads.size()));
    for (BodyData& body : subsystem.bodies) {
      const CoordinateBlock& block = body.coordinates;
      const auto size = static_cast<std::size_t>(block.size);
      for (double* vector : {block.q, block.v, block.a}) apply(std::span(vector, size));
      for (double* vector : block.history)
        if (vector) apply(std::span(vector, size));
    }
  }
}

}  // namespace

std::size_t count_state_values(StepData& data) {
  std::size_t count = 0;
  RecordValues record{};
  for_each_state_part(data, record, [&](std::span<const double> part) { count += part.size(); });
  return count;
}

void take_state_values(std::int64_t step, StepData& data, std::vector<double>& values) {
  values.clear();
  values.reserve(count_state_values(data));
  RecordValues record = values_of(of_step(data.records, step));
  for_each_state_part(data, record, [&](std::span<const double> part) {
    values.insert(values.end(), part.begin(), part.end());
  });
}

std::vector<double> take_state_values(std::int64_t step, StepData& data) {
  std::vector<double> values;
  take_state_values(step, data, values);
  return values;
}

void put_state_values(std::span<const double> values, std::int64_t step, StepData& data) {
  assert(values.size() == count_state_values(data));
  const double* next = values.data();
  RecordValues record{};
  for_each_state_part(data, record, [&](std::span<double> part) {
    std::copy_n(next, part.size(), part.begin());
    next += part.size();
  });
  of_step(data.records, step) = make_record(record);
}

std::uint64_t hash_state(const StepData& data) {
  std::uint64_t value = 14695981039346656037u;
  value = hash(value, data.hub_coordinates.q, kTwist);
  value = hash(value, data.hub_coordinates.v, kTwist);
  for (const SubsystemData& subsystem : data.subsystems)
    for (const BodyData& body : subsystem.bodies)
      for (const double* flex : {body.coordinates.q, body.coordinates.v}) {
        value = hash(value, flex + body.layout.u(), body.layout.axial);
        value = hash(value, flex + body.layout.v(), body.layout.bending);
      }
  return value;
}

}  // namespace spoke
