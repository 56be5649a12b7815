#pragma once

// report.html: a self-contained page of a run, with plots, an animation, and all numbers of
// docs/results.md.

#include <string>

#include "engine/results.h"
#include "engine/run_report/recorder.h"

namespace spoke::run_report {

/// The largest deflection of all tips; of none, `when` is empty.
struct TipSummary {
  double largest = 0.0;  ///< with its sign [m]
  std::string when;      ///< "at 6.765 s (blades 1-3)"
};

/// The page.
std::string make_html(const Simulation& simulation, const SensorStatistics& statistics,
                      const RunOutcome& outcome, const TipSummary& tips, const Recorder& recorder);

}  // namespace spoke::run_report
