#pragma once

// report.html: a self-contained page of a run, with plots, an animation, and all numbers of
// docs/results.md.

#include <string>

#include "engine/results.h"
#include "engine/run_statistics.h"
#include "program/run_report/recorder.h"

namespace spoke::run_report {

/// The largest deflection of all tips; `when` is empty if there is none.
struct TipSummary {
  double largest = 0.0;  ///< deflection with its sign [m]
  std::string when;      ///< "at 6.765 s (blades 1-3)"
};

/// Returns the page. `rows`: statistics of the recorder's rows; the page has those that there are.
std::string make_html(const Simulation& simulation, const SensorStatistics& statistics,
                      const RunOutcome& outcome, const TipSummary& tips, const Recorder& recorder,
                      const RunStatistics& rows);

}  // namespace spoke::run_report
