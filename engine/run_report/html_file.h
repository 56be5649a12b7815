#pragma once

// report.html: a self-contained page of a run, with plots, an animation, and all numbers of
// docs/results.md.

#include <string>
#include <vector>

#include "engine/results.h"
#include "engine/run_report/recorder.h"

namespace spoke::run_report {

/// The page. tips: lines on the largest deflections, the largest first.
std::string make_html(const Simulation& simulation, const SensorStatistics& statistics,
                      const RunOutcome& outcome, const std::vector<std::string>& tips,
                      const Recorder& recorder);

}  // namespace spoke::run_report
