#pragma once

// The table of a prediction.

#include <string>

#include "bench/predict/prediction.h"
#include "program/report/page.h"

namespace spoke::predict {

/// All points for people, a row per executor and number of threads.
report::Table make_table(const Prediction& prediction);

/// The same by number of processes.
report::Table make_rank_table(const Prediction& prediction);

/// Pairs of label and value: the graphs, T1, Tinf, what nodes and runtimes were measured to cost.
std::vector<report::Fact> make_facts(const Prediction& prediction);

}  // namespace spoke::predict
