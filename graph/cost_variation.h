#pragma once

#include <span>
#include <vector>

#include "graph/chance.h"

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
      varied_[node] = costs_[node] * chance_.factor(most_);
    return varied_;
  }

 private:
  std::span<const double> costs_;
  double most_;
  std::vector<double> varied_;
  Chance chance_;
};

}  // namespace spoke::graph
