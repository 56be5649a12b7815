#pragma once

// The charts of the page of reproduce.

#include "bench/reproduce/reproduction.h"
#include "program/report/chart.h"

namespace spoke::reproduce {

/// Fig. 8: the hub's speed, angle and acceleration, in charts of their own for their units differ.
report::LineChart speed_chart(const Reproduction& reproduction);
report::LineChart angle_chart(const Reproduction& reproduction);
report::LineChart acceleration_chart(const Reproduction& reproduction);
/// Fig. 9: the deflection of the tip over time.
report::LineChart deflection_chart(const Reproduction& reproduction);
/// Fig. 10: time per step by threads.
report::LineChart subsystem_chart(const Reproduction& reproduction);
/// Fig. 11: time per step by layers of threads; for Work::inverse Fig. 12, of the inverse part.
report::BarChart layered_chart(const Reproduction& reproduction, Work work);
/// Fig. 13: time per step by method, on a logarithmic axis.
report::BarChart method_chart(const Reproduction& reproduction);

}  // namespace spoke::reproduce
