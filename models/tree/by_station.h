#pragma once

// Linear interpolation between stations.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace spoke::spatial {

/// Values at a place between stations: of each array the same two values and weights.
class ByStation {
 public:
  /// Stations ascend, two or more; beyond the ends the last piece goes on.
  ByStation(const std::vector<double>& station, double x) {
    assert(station.size() >= 2);
    const auto after = std::upper_bound(station.begin() + 1, station.end() - 1, x);
    upper_ = static_cast<std::size_t>(after - station.begin());
    weight_ = (x - station[upper_ - 1]) / (station[upper_] - station[upper_ - 1]);
  }

  template <class Value>
  Value of(const std::vector<Value>& values) const {
    return (1.0 - weight_) * values[upper_ - 1] + weight_ * values[upper_];
  }

 private:
  std::size_t upper_;
  double weight_;
};

}  // namespace spoke::spatial
