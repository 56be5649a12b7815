// Sums over points, each of which has a run for A, for B, and for A with each coordinate of B.

#include "program/study/sobol_indices.h"

#include <algorithm>
#include <cmath>

namespace spoke::study {
namespace {

/// The sums of one response.
struct Sums {
  explicit Sums(std::size_t parameters) : first(parameters), total(parameters) {}
  std::int64_t points = 0;
  double mean = 0.0;     ///< mean of A and B
  double squares = 0.0;  ///< sum of squared distances from the mean
  std::vector<double> first, total;
};

/// Adds the responses y of one point: A, B, then A with each coordinate of B, less a number near
/// their mean, which improves the estimate of the first order.
void add_point(const std::vector<double>& y, Sums& sums) {
  ++sums.points;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto count = static_cast<double>(2 * (sums.points - 1)) + static_cast<double>(k) + 1.0;
    const double change = y[k] - sums.mean;
    sums.mean += change / count;
    sums.squares += change * (y[k] - sums.mean);
  }
  for (std::size_t d = 0; d < sums.first.size(); ++d) {
    const double mixed = y[d + 2];
    sums.first[d] += y[1] * (mixed - y[0]);
    sums.total[d] += (y[0] - mixed) * (y[0] - mixed);
  }
}

std::vector<SobolIndex> make_indices(const Sums& sums, const std::vector<std::size_t>& sampled) {
  const auto points = static_cast<double>(sums.points);
  const double variance = sums.points > 0 ? sums.squares / (2.0 * points) : 0.0;
  std::vector<SobolIndex> indices;
  for (std::size_t d = 0; d < sampled.size(); ++d) {
    if (!(variance > 0.0)) break;
    indices.push_back(
        {sampled[d], sums.first[d] / points / variance, sums.total[d] / (2.0 * points) / variance});
  }
  return indices;
}

}  // namespace

void find_sobol_indices(const std::vector<std::size_t>& sampled, const ForEachRun& for_each,
                        Analysis& analysis) {
  const std::size_t runs = sampled.size() + 2, responses = analysis.responses.size();
  std::vector<Sums> sums(responses, Sums(sampled.size()));
  // Responses of the present point's runs, by response.
  std::vector<std::vector<double>> point(responses);
  for_each([&](const RunResult& result) {
    for (std::size_t k = 0; k < responses; ++k) {
      point[k].push_back(result.responses[k] - analysis.responses[k].summary.mean);
      if (point[k].size() < runs) continue;
      if (std::all_of(point[k].begin(), point[k].end(), [](double y) { return std::isfinite(y); }))
        add_point(point[k], sums[k]);
      point[k].clear();
    }
  });
  for (std::size_t k = 0; k < responses; ++k) {
    analysis.responses[k].indices = make_indices(sums[k], sampled);
    analysis.responses[k].index_points = sums[k].points;
  }
}

}  // namespace spoke::study
