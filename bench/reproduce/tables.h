#pragma once

// The tables of the page of reproduce.

#include "bench/reproduce/reproduction.h"
#include "program/report/page.h"

namespace spoke::reproduce {

/// Returns Table 2 as printed, with its formulas evaluated.
report::Table paper_counts();
/// Returns the three formulations' operations by part, beside the paper's.
report::Table our_counts();
/// Fig. 9: peaks, beside the exact ones.
report::Table deflection_table(const Reproduction& reproduction);
/// Fig. 10: schemes 1 and 2 on 1 to 3 threads.
report::Table subsystem_table(const Reproduction& reproduction);
/// Fig. 11: schemes 1 and 2 on 3x1 to 3x4; for Work::inverse Fig. 12, of the inverse part.
report::Table layered_table(const Reproduction& reproduction, Work work);

/// One line of Table 3 and Fig. 13, the paper's or Spoke's own.
struct MethodTime {
  std::string name = {};
  std::string how = {};                 ///< formulation, executor
  std::optional<double> paper_ms = {};  ///< time per step
  std::optional<double> paper_ratio = {};
  std::optional<double> seconds = {};  ///< time per step, here [s]
  std::optional<double> ratio = {};    ///< ratio to "layered parallel", here
  std::optional<double> run = {};      ///< time for the 20 s, here [s]
};
/// Returns the lines; those that were not measured have no time.
std::vector<MethodTime> method_times(const Reproduction& reproduction);
report::Table method_table(const Reproduction& reproduction);

/// Returns the threads, 3x2 to 3x4, with which scheme 1 was fastest; none if none was measured.
std::optional<graph::Threads> best_layered(const Reproduction& reproduction);

}  // namespace spoke::reproduce
