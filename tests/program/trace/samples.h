#pragma once

#include "program/trace/trace.h"

namespace spoke::trace::testing {

/// The settings with which a rotor of three unequal blades is traced.
struct Sample {
  ExecutorKind executor = ExecutorKind::flow_graph;
  graph::Threads threads = 2;
  int window = 1;
  bool is_coupled = false;  ///< whether the hub has free coordinates
  Formulation formulation = Formulation::structured;
};

/// Makes a simulation that has made 20 steps.
Simulation make_simulation(const Sample& sample);

/// Makes a trace of ten steps, the first of them number 21.
Trace make_trace(const Sample& sample);

/// Returns a trace with two steps of two passes on two threads, by hand: nodes 0 -> 1, 0 -> 2, then
/// in the next pass 1 -> 0 and 2 -> 0.
Trace small_trace();

}  // namespace spoke::trace::testing
