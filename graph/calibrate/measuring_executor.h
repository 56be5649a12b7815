#pragma once

// An executor that measures the costs of nodes while it runs them.

#include <cstdint>
#include <vector>

#include "graph/calibrate/node_costs.h"
#include "graph/executor.h"

namespace spoke::graph {

/// Runs the nodes serially, and measures the cost of each and of the work between two runs. So a
/// program that runs by an executor can be measured at work. Time stamps stand between the nodes of
/// only half of the runs; the others tell the undisturbed cost of all nodes together.
class MeasuringExecutor final : public Executor {
 public:
  /// Refers to `graph`, which must outlive this executor.
  explicit MeasuringExecutor(const StepGraph& graph) : graph_(graph), costs_(graph) {}

  void run() override;
  void run_while(const std::function<bool()>& more) override;
  std::string_view name() const override { return name_of(ExecutorKind::serial); }
  Threads threads() const override { return 1; }

  int runs() const { return costs_.runs() + static_cast<int>(plain_ticks_.size()); }
  /// Returns by index of the node its mean cost per run [s]. Their sum is the mean time of the runs
  /// without stamps; where these take longer than two stretches of 20 ms, the median of the
  /// stretches' means. Precondition: runs() > 0; after a single run, stamps distort the costs.
  std::vector<double> node_costs() const;
  /// Returns the times of the runs without stamps between the nodes [s].
  std::vector<double> run_times() const;
  /// Returns the mean time of asking whether to go on, in the runs of run_while() [s]; 0 without
  /// any.
  double between_runs() const;

 private:
  const StepGraph& graph_;
  NodeCosts costs_;
  std::vector<std::uint64_t> plain_ticks_;
  std::vector<std::uint64_t> ticks_between_;
};

}  // namespace spoke::graph
