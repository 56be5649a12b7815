// Makes counts and summaries; the files beside this one find effects and indices.

#include "program/study/analyse.h"

#include <cmath>

#include "program/study/main_effects.h"
#include "program/study/sobol_indices.h"

namespace spoke::study {
namespace {

void count(const RunResult& result, Analysis& analysis) {
  RunCounts& counts = analysis.counts;
  switch (result.status) {
    case RunStatus::done:
      ++counts.done;
      return;
    case RunStatus::doubtful:
      ++counts.doubtful;
      return;
    case RunStatus::diverged:
      ++counts.diverged;
      break;
    case RunStatus::refused:
      ++counts.refused;
      break;
  }
  if (analysis.failed.size() < kMostListed)
    analysis.failed.push_back({result.run, result.status, result.diagnosis});
}

/// Means and variances by Welford's recurrence, whose sums do not cancel.
class Summarised {
 public:
  void add(std::int64_t run, double value) {
    if (!std::isfinite(value)) return;
    ++summary_.count;
    const double change = value - summary_.mean;
    summary_.mean += change / static_cast<double>(summary_.count);
    squares_ += change * (value - summary_.mean);
    if (summary_.count == 1 || value < summary_.min) {
      summary_.min = value;
      summary_.run_of_min = run;
    }
    if (summary_.count == 1 || value > summary_.max) {
      summary_.max = value;
      summary_.run_of_max = run;
    }
  }
  Summary summary() const {
    Summary summary = summary_;
    if (summary.count > 1)
      summary.deviation = std::sqrt(squares_ / static_cast<double>(summary.count - 1));
    return summary;
  }

 private:
  Summary summary_;
  double squares_ = 0.0;
};

}  // namespace

Analysis analyse(const Study& study, const Sampling& sampling, const ForEachRun& for_each) {
  Analysis analysis;
  std::vector<Summarised> summaries(study.responses.size());
  for_each([&](const RunResult& result) {
    count(result, analysis);
    for (std::size_t k = 0; k < summaries.size(); ++k)
      summaries[k].add(result.run, result.responses[k]);
  });
  analysis.responses.resize(summaries.size());
  for (std::size_t k = 0; k < summaries.size(); ++k)
    analysis.responses[k].summary = summaries[k].summary();
  if (study.design.kind != DesignKind::table)
    find_main_effects(study, sampling, for_each, analysis);
  if (study.design.kind == DesignKind::saltelli)
    find_sobol_indices(sampling.sampled(), for_each, analysis);
  return analysis;
}

}  // namespace spoke::study
