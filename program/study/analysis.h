#pragma once

// The analysis of a study's runs: extremes and means of the responses, main effects of the
// parameters, Sobol indices.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "program/study/sampling.h"
#include "program/study/single_run.h"
#include "program/study/study.h"

namespace spoke::study {

/// Calls `visit` for every run, in order. A study has more results than memory may hold.
using Visitor = std::function<void(const RunResult&)>;
using ForEachRun = std::function<void(const Visitor& visit)>;

/// A response over all runs that have it; count 0 if none has.
struct Summary {
  std::int64_t count = 0;
  double min = 0.0, max = 0.0, mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the runs, divided by count - 1
  std::int64_t run_of_min = 0, run_of_max = 0;
};

/// The mean response where a parameter has values of a level, or in a part of its range that is as
/// probable as the others.
struct EffectLevel {
  double low = 0.0, high = 0.0;  ///< range of the parameter there; equal to its value for a level
  std::int64_t count = 0;        ///< runs
  double mean = 0.0;             ///< mean of the response
};

/// The effect of a parameter by itself on a response.
struct MainEffect {
  std::size_t parameter = 0;
  std::vector<EffectLevel> levels;
  /// The part of the response's variance that the means of the levels explain, 0 to 1. For random
  /// designs, the part that chance explains is subtracted (epsilon squared).
  double share = 0.0;
};

/// Sobol indices of a parameter for a response (docs/studies.md).
struct SobolIndex {
  std::size_t parameter = 0;
  double first = 0.0, total = 0.0;
};

/// The analysis of a response.
struct ResponseAnalysis {
  Summary summary;
  std::vector<MainEffect> effects;  ///< main effects; none for a table
  std::vector<SobolIndex> indices;  ///< Sobol indices, for the design saltelli
  std::int64_t index_points = 0;    ///< points whose runs all have the response
};

/// Numbers of runs by their end.
struct RunCounts {
  std::int64_t done = 0, doubtful = 0, diverged = 0, refused = 0;
  std::int64_t without_responses() const { return diverged + refused; }
};

/// A run that diverged or was refused.
struct FailedRun {
  std::int64_t run = 0;
  RunStatus status = RunStatus::diverged;
  std::string diagnosis;
};

/// The analysis of a study.
struct Analysis {
  RunCounts counts;
  std::vector<FailedRun> failed;            ///< the first failed runs
  std::vector<ResponseAnalysis> responses;  ///< analysis by response
};

/// The most runs that Analysis::failed lists.
inline constexpr std::size_t kMostListed = 20;

}  // namespace spoke::study
