#pragma once

// Statistics of measured times.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace spoke::compare {

/// Precondition of all functions: there is at least one value.
double mean(std::span<const double> values);
double median(std::span<const double> values);
/// Returns the value below which `share` (0 to 1) of the values lie, interpolated between
/// neighbours.
double quantile(std::span<const double> values, double share);

struct Quartiles {
  double low = 0.0, median = 0.0, high = 0.0;
  std::size_t rounds = 0;  ///< number of values
};
Quartiles quartiles_of(std::span<const double> values);
/// Returns the deviation of a sample (divided by n - 1); none for a single value.
std::optional<double> standard_deviation(std::span<const double> values);

/// Returns above[k] / below[k] for all k that both have.
std::vector<double> ratios(std::span<const double> above, std::span<const double> below);

}  // namespace spoke::compare
