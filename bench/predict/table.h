#pragma once

// The table of a prediction.

#include <string>

#include "bench/predict/prediction.h"
#include "program/report/page.h"

namespace spoke::predict {

/// Returns all points for people, a row for each executor and number of threads.
report::Table make_table(const Prediction& prediction);

/// Returns the points on several processes, a row for each number of processes.
report::Table make_rank_table(const Prediction& prediction);

/// Returns pairs of label and value: the graphs, T1, Tinf, the measured costs of nodes and
/// runtimes.
std::vector<report::Fact> make_facts(const Prediction& prediction);

}  // namespace spoke::predict
