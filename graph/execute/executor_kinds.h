#pragma once

// The makers of the single executors, each in a source file of its own.

#include <memory>
#include <vector>

#include "graph/executor.h"
#include "graph/plan/plan.h"

namespace spoke::graph {

/// The makers behind make_executor(), one per source file, so that each runtime's headers stay in
/// one file.
std::unique_ptr<Executor> make_serial_executor(const StepGraph& graph);
/// Makes an executor with one node of a flow graph per cluster of `plan`, a plan of `graph`. A plan
/// of one cluster runs on the calling thread without the runtime. `partition` says which flow graph
/// a cluster belongs to, from 0 on without gaps; without it partition_clusters() does.
std::unique_ptr<Executor> make_flow_graph_executor(const StepGraph& graph, Plan plan, int threads,
                                                   std::vector<int> partition = {});

/// The makers below exist only in builds with OpenMP. At most `processors` threads get work.
std::unique_ptr<Executor> make_openmp_scheme1_executor(const StepGraph& graph, Threads threads,
                                                       int processors);
std::unique_ptr<Executor> make_openmp_scheme2_executor(const StepGraph& graph, Threads threads);
std::unique_ptr<Executor> make_openmp_levels_executor(const StepGraph& graph, int threads);
std::unique_ptr<Executor> make_openmp_tasks_executor(const StepGraph& graph, int threads);

}  // namespace spoke::graph
