#include "engine/state_copy.h"

#include <algorithm>

namespace spoke {

StateCopy::StateCopy(StepData& data) {
  state_.push_back(doubles(data.hub_storage[0], data.hub_storage.size()));
  state_.push_back(doubles(data.hub));
  state_.push_back(doubles(data.clocks[0], data.clocks.size()));
  for (SubsystemData& subsystem : data.subsystems) {
    state_.emplace_back(subsystem.storage.data(), subsystem.storage.size());
    state_.push_back(doubles(subsystem.prescribed));
  }
  std::size_t count = 0;
  for (const std::span<double> part : state_) count += part.size();
  values_.resize(count);
}

void StateCopy::save() {
  double* next = values_.data();
  for (const std::span<double> part : state_) next = std::copy(part.begin(), part.end(), next);
}

void StateCopy::restore() const {
  const double* next = values_.data();
  for (const std::span<double> part : state_) {
    std::copy_n(next, part.size(), part.begin());
    next += part.size();
  }
}

}  // namespace spoke
