// Copies the ranges of a state back and forth.

#include "engine/table/state_copy.h"

#include <algorithm>

namespace spoke {

StateCopy::StateCopy(StepData& data) {
  state_.push_back(std::as_writable_bytes(std::span(data.hub_storage)));
  state_.push_back(std::as_writable_bytes(std::span(&data.hub, 1)));
  state_.push_back(std::as_writable_bytes(std::span(data.progress)));
  for (SubsystemData& subsystem : data.subsystems) {
    state_.push_back(std::as_writable_bytes(std::span(subsystem.storage)));
    state_.push_back(std::as_writable_bytes(std::span(&subsystem.prescribed, 1)));
    state_.push_back(std::as_writable_bytes(std::span(&subsystem.root_load, 1)));
    state_.push_back(std::as_writable_bytes(std::span(subsystem.joint_loads)));
  }
  std::size_t count = 0;
  for (const std::span<std::byte> part : state_) count += part.size();
  values_.resize(count);
}

void StateCopy::save() {
  std::byte* next = values_.data();
  for (const std::span<std::byte> part : state_) next = std::copy(part.begin(), part.end(), next);
}

void StateCopy::restore() const {
  const std::byte* next = values_.data();
  for (const std::span<std::byte> part : state_) {
    std::copy_n(next, part.size(), part.begin());
    next += part.size();
  }
}

}  // namespace spoke
