#pragma once

#include <random>
#include <span>
#include <vector>

namespace spoke::graph {

/// Costs of nodes as they vary by chance: at each call all anew, each by a factor from 1 - `most`
/// to 1 + `most`. The first call and what follows are the same for every object and platform.
class CostVariation {
 public:
  /// Refers to `costs`.
  CostVariation(std::span<const double> costs, double most)
      : costs_(costs), most_(most), varied_(costs.size()) {}

  const std::vector<double>& operator()() {
    for (std::size_t node = 0; node < costs_.size(); ++node)
      varied_[node] = costs_[node] * (1.0 + most_ * (2.0 * from_0_to_1() - 1.0));
    return varied_;
  }

 private:
  using Random = std::minstd_rand;
  double from_0_to_1() {
    return static_cast<double>(random_() - Random::min()) / (Random::max() - Random::min());
  }

  std::span<const double> costs_;
  double most_;
  std::vector<double> varied_;
  Random random_;
};

}  // namespace spoke::graph
