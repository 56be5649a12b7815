#include "graph/plan_choice.h"

#include <algorithm>

namespace spoke::graph {
namespace {

// The lower one of an even number.
double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double speedup_of(const Samples& serial, const Samples& other) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(serial.size(), other.size()); ++round) {
    ratios.push_back(serial[round] / other[round]);
  }
  return median(std::move(ratios));
}

}  // namespace

double least_gain(double seconds_per_run, double handover) {
  return 1.05 + 2.0 * handover / std::max(seconds_per_run, 1e-7);
}

Choice choose_plan(std::span<const Samples> samples, std::span<const double> foreseen,
                   double least) {
  constexpr double believed = 1.15;  // found / foreseen
  Choice best{0, 0.0, 0.0};
  double most = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double speedup = speedup_of(samples[0], samples[k]);
    const double counted = std::min(speedup, believed * foreseen[k]);
    if (counted <= most) continue;
    most = counted;
    best = {k, speedup, foreseen[k]};
  }
  if (best.speedup < least) best.index = 0;
  return best;
}

}  // namespace spoke::graph
