#include "engine/state_values.h"

#include <algorithm>

namespace spoke {
namespace {

std::uint64_t hash(std::uint64_t value, const double* first, int count) {
  constexpr std::uint64_t kPrime = 1099511628211u;
  const auto* bytes = reinterpret_cast<const unsigned char*>(first);
  for (std::size_t k = 0; k < count * sizeof(double); ++k) value = (value ^ bytes[k]) * kPrime;
  return value;
}

}  // namespace

std::size_t count_state_values(StepData& data) {
  std::size_t count = 0;
  for_each_state_part(0, data, [&](std::span<const double> part) { count += part.size(); });
  return count;
}

void take_state_values(std::int64_t step, StepData& data, std::vector<double>& values) {
  values.clear();
  values.reserve(count_state_values(data));
  for_each_state_part(step, data, [&](std::span<const double> part) {
    values.insert(values.end(), part.begin(), part.end());
  });
}

std::vector<double> take_state_values(std::int64_t step, StepData& data) {
  std::vector<double> values;
  take_state_values(step, data, values);
  return values;
}

void put_state_values(const std::vector<double>& values, std::int64_t step, StepData& data) {
  const double* next = values.data();
  for_each_state_part(step, data, [&](std::span<double> part) {
    std::copy_n(next, part.size(), part.begin());
    next += part.size();
  });
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
