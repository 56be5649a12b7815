// Means, quantiles and deviations.

#include "bench/compare/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace spoke::compare {

double mean(std::span<const double> values) {
  assert(!values.empty());
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::span<const double> values) { return quantile(values, 0.5); }

double quantile(std::span<const double> values, double share) {
  assert(share >= 0.0 && share <= 1.0);
  assert(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

Quartiles quartiles_of(std::span<const double> values) {
  return {quantile(values, 0.25), median(values), quantile(values, 0.75), values.size()};
}

std::optional<double> standard_deviation(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::vector<double> ratios(std::span<const double> above, std::span<const double> below) {
  std::vector<double> result(std::min(above.size(), below.size()));
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = above[k] / below[k];
  return result;
}

}  // namespace spoke::compare
