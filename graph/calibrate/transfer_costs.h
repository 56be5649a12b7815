#pragma once

// What it costs when data come from another processor's cache.

#include "graph/simulate/data_traffic.h"

namespace spoke::graph {

/// What it takes on this machine until data that another processor has written are there, measured
/// in so many places in memory, on each in an equal share of twice `time` [s]. Nothing where this
/// process gets no other processor.
Transfer measure_transfer(int places, double time);

}  // namespace spoke::graph
