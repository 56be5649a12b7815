#pragma once

// A simulation that makes the same steps over and over, to be timed in turns with others.

#include <cstdint>
#include <memory>
#include <string>

#include "bench/compare/interleaved.h"
#include "engine/simulation.h"

namespace spoke::bench {

class RepeatedSteps {
 public:
  /// Runs to the time `begin` [s], and makes the `steps` from there until all that chooses has
  /// chosen.
  RepeatedSteps(const Scenario& scenario, const SimulationOptions& options, double begin,
                int steps);

  void go_back() { simulation_.restore(start_); }
  void run();
  double evaluations_per_step() const { return evaluations_; }
  /// Returns the hash of the state behind the last step.
  std::uint64_t hash() const { return hash_; }
  std::string executor() const { return simulation_.executor_description(); }

  /// Returns them as an alternative whose times are those of one step.
  static Alternative alternative(std::string name, const std::shared_ptr<RepeatedSteps>& steps,
                                 int reference);

 private:
  Simulation simulation_;
  int steps_;
  SavedState start_;
  double evaluations_ = 0.0;
  std::uint64_t hash_ = 0;
};

}  // namespace spoke::bench
