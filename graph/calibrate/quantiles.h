#pragma once

// Medians and quartiles of measured times.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace spoke::graph {

namespace detail {
/// Returns the value below which the fraction `numerator`/`denominator` of all values lies.
/// Precondition: not empty.
template <class Value>
Value order_statistic(std::vector<Value> values, std::size_t numerator, std::size_t denominator) {
  assert(!values.empty() && numerator < denominator);
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() * numerator / denominator);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
}  // namespace detail

/// Returns the middle value, the upper one for an even number. Precondition: not empty.
template <class Value>
Value median(std::vector<Value> values) {
  return detail::order_statistic(std::move(values), 1, 2);
}

/// Returns the value of an undisturbed sample, since disturbances only add time. Precondition: not
/// empty.
inline double lower_quartile(std::vector<double> values) {
  return detail::order_statistic(std::move(values), 1, 4);
}

}  // namespace spoke::graph
