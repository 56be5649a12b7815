#pragma once

// Typical values of measured times.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <vector>

namespace spoke::graph {

/// Returns the middle value, the upper one for an even number. Precondition: not empty.
template <class Value>
Value median(std::vector<Value> values) {
  assert(!values.empty());
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Returns the mean of the smaller three quarters of all values, which it sorts: that leaves out
/// interruptions, but keeps the mean of nodes that are idle in some runs and busy in others.
/// Precondition: not empty.
template <class Value>
double robust_mean(std::vector<Value>& values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t kept = (3 * values.size() + 3) / 4;
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(kept);
  return std::accumulate(values.begin(), end, 0.0,
                         [](double sum, Value value) { return sum + static_cast<double>(value); }) /
         static_cast<double>(kept);
}

}  // namespace spoke::graph
