// Finds means of responses by levels of parameters, and the variance that they explain.

#include "program/study/main_effects.h"

#include <algorithm>
#include <cmath>

namespace spoke::study {
namespace {

/// Returns the number of levels into which a range of values is divided: the cube root of the runs,
/// 2 to 20.
std::size_t count_parts(std::int64_t runs) {
  return static_cast<std::size_t>(std::clamp(std::cbrt(static_cast<double>(runs)), 2.0, 20.0));
}

/// Finds the levels of the sampled parameters that a run belongs to.
class Levels {
 public:
  Levels(const Study& study, const Sampling& sampling) : study_(study), sampling_(sampling) {
    for (const std::size_t i : sampling.sampled()) {
      const Parameter& parameter = study.parameters[i];
      counts_.push_back(parameter.levels.empty() ? count_parts(study.design.runs)
                                                 : parameter.levels.size());
    }
  }

  std::size_t count(std::size_t dimension) const { return counts_[dimension]; }

  /// Returns the levels by sampled parameter.
  std::vector<std::size_t> find(std::int64_t run, const std::vector<double>& values) const {
    const bool is_grid = study_.design.kind == DesignKind::grid;
    const std::vector<double> point = is_grid ? std::vector<double>() : sampling_.point(run);
    std::vector<std::size_t> found;
    for (std::size_t d = 0; d < counts_.size(); ++d) {
      const auto count = static_cast<double>(counts_[d]);
      found.push_back(is_grid
                          ? find_value(d, values[sampling_.sampled()[d]])
                          : std::min(static_cast<std::size_t>(point[d] * count), counts_[d] - 1));
    }
    return found;
  }

 private:
  std::size_t find_value(std::size_t dimension, double value) const {
    const auto& levels = study_.parameters[sampling_.sampled()[dimension]].levels;
    const auto found = std::find_if(levels.begin(), levels.end(),
                                    [&](const Level& level) { return level.number == value; });
    return static_cast<std::size_t>(found - levels.begin());
  }

  const Study& study_;
  const Sampling& sampling_;
  std::vector<std::size_t> counts_;
};

void add(double x, double y, EffectLevel& level) {
  level.low = level.count == 0 ? x : std::min(level.low, x);
  level.high = level.count == 0 ? x : std::max(level.high, x);
  ++level.count;
  level.mean += (y - level.mean) / static_cast<double>(level.count);
}

/// Returns eta squared, or for random designs epsilon squared, which chance does not enlarge.
double explained_share(const MainEffect& effect, const Summary& summary, bool is_random) {
  const auto runs = static_cast<double>(summary.count);
  const double total = summary.deviation * summary.deviation * (runs - 1.0);
  double between = 0.0, levels = 0.0;
  for (const EffectLevel& level : effect.levels) {
    if (level.count == 0) continue;
    const double change = level.mean - summary.mean;
    between += static_cast<double>(level.count) * change * change;
    levels += 1.0;
  }
  if (!(total > 0.0)) return 0.0;
  double share = between / total;
  if (is_random) share = runs > levels ? 1.0 - (1.0 - share) * (runs - 1.0) / (runs - levels) : 0.0;
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

void find_main_effects(const Study& study, const Sampling& sampling, const ForEachRun& for_each,
                       Analysis& analysis) {
  const Levels levels(study, sampling);
  for (ResponseAnalysis& response : analysis.responses)
    for (std::size_t d = 0; d < sampling.sampled().size(); ++d) {
      response.effects.push_back({sampling.sampled()[d], {}, 0.0});
      response.effects.back().levels.resize(levels.count(d));
    }
  for_each([&](const RunResult& result) {
    const std::vector<double> values = sampling.values(result.run);
    const std::vector<std::size_t> found = levels.find(result.run, values);
    for (std::size_t k = 0; k < analysis.responses.size(); ++k) {
      if (!std::isfinite(result.responses[k])) continue;
      for (std::size_t d = 0; d < found.size(); ++d) {
        MainEffect& effect = analysis.responses[k].effects[d];
        add(values[effect.parameter], result.responses[k], effect.levels[found[d]]);
      }
    }
  });
  for (ResponseAnalysis& response : analysis.responses)
    for (MainEffect& effect : response.effects)
      effect.share =
          explained_share(effect, response.summary, study.design.kind != DesignKind::grid);
}

}  // namespace spoke::study
