#include "engine/state_values.h"

#include <algorithm>

namespace spoke {

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

}  // namespace spoke
