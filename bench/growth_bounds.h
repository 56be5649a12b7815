#pragma once

// What many cores could make of a large model: work and span of its step graph, by node costs
// measured here.

#include <string>
#include <vector>

#include "bench/report.h"
#include "models/scenario.h"

namespace spoke::bench {

/// A model, and what it is called.
struct LargeModel {
  std::string name;
  Scenario scenario;
};

/// Builds and measures each model, one after the other, and prints: sizes; the memory that it has
/// taken; times of its start and of a clone, the least of some; work and span of an evaluation,
/// runs of one pass; and how many times as fast 16, 64 and 256 processors would be, by a schedule
/// of flow_graph, and by the bound of greedy schedules, T1/P + Tinf.
void measure_bounds(const std::vector<LargeModel>& models, Report& report);

}  // namespace spoke::bench
