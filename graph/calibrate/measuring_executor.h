#pragma once

// An executor that measures what nodes cost while it runs them.

#include <cstdint>
#include <vector>

#include "graph/calibrate/node_costs.h"
#include "graph/executor.h"

namespace spoke::graph {

/// Runs the nodes serially, and measures what each of them costs and what
/// is done between two runs. So what runs by an executor can be measured at work.
/// Time stamps stand between the nodes of half of the runs only; the others tell what all nodes
/// cost together, undisturbed.
class MeasuringExecutor final : public Executor {
 public:
  /// Refers to `graph`, which must outlive it.
  explicit MeasuringExecutor(const StepGraph& graph) : graph_(graph), costs_(graph) {}

  void run() override;
  void run_while(const std::function<bool()>& more) override;
  std::string_view name() const override { return name_of(ExecutorKind::serial); }
  Threads threads() const override { return 1; }

  int runs() const { return costs_.runs() + static_cast<int>(plain_ticks_.size()); }
  /// By index of the node its mean cost per run [s]. Their sum is the mean time of the runs without
  /// stamps; where these take longer than two stretches of 20 ms, the median of the stretches'
  /// means. Precondition: runs() > 0; of a single run stamps distort it.
  std::vector<double> node_costs() const;
  /// The times of the runs without stamps between the nodes [s].
  std::vector<double> run_times() const;
  /// What asking whether to go on took, in the runs of run_while(), likewise [s]; 0 without any.
  double between_runs() const;

 private:
  const StepGraph& graph_;
  NodeCosts costs_;
  std::vector<std::uint64_t> plain_ticks_;
  std::vector<std::uint64_t> ticks_between_;
};

}  // namespace spoke::graph
