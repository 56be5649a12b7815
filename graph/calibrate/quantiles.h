#pragma once

// Medians and quartiles of measured times.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace spoke::graph {

namespace detail {
/// The value below which `numerator` of `denominator` of all lie. Precondition: not empty.
template <class Value>
Value order_statistic(std::vector<Value> values, std::size_t numerator, std::size_t denominator) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() * numerator / denominator);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
}  // namespace detail

/// The middle one, of an even number the upper. Precondition: not empty.
template <class Value>
Value median(std::vector<Value> values) {
  return detail::order_statistic(std::move(values), 1, 2);
}

/// What an undisturbed sample is like, since what disturbs only adds. Precondition: not empty.
inline double lower_quartile(std::vector<double> values) {
  return detail::order_statistic(std::move(values), 1, 4);
}

}  // namespace spoke::graph
