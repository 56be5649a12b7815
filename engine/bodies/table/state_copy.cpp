// Copies the ranges of a state back and forth.

#include "engine/bodies/table/state_copy.h"

#include <algorithm>

namespace spoke {

StateCopy::StateCopy(StepTable& data) : state_(data.state_memory()) {
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
