#pragma once

// Fetches what the nodes of the next body of a chain read, where the model outgrows the caches.

#include <cstddef>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Fetch the memory of the body behind `j` that its terms and its recovery read or write, and where
/// that of the one behind it lies.
void fetch_for_terms(const SubsystemData<Space>& data, std::size_t j) noexcept;
void fetch_for_recovery(const SubsystemData<Space>& data, std::size_t j) noexcept;
inline void fetch_for_terms(const SubsystemData<Plane>&, std::size_t) noexcept {}
inline void fetch_for_recovery(const SubsystemData<Plane>&, std::size_t) noexcept {}

}  // namespace spoke
