#pragma once

// The part of a step that the paper times in Fig. 12.

#include <memory>

#include "engine/simulation.h"

namespace spoke::reproduce {

/// The nodes "inverse" of a step by themselves: a graph of nothing else, run as often as rk4 does
/// in a step. On more than one thread its time holds their forks and barriers too.
class InversePart {
 public:
  /// Precondition: the formulation has such nodes (structured, subsystem).
  InversePart(const Scenario& scenario, const SimulationOptions& options);
  ~InversePart();
  InversePart(const InversePart&) = delete;
  InversePart& operator=(const InversePart&) = delete;

  void run(std::int64_t steps);
  int nodes() const;  ///< in one evaluation

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The share of a step's work that is the nodes "inverse", on one thread: from the costs of all
/// nodes, timed one by one in the same runs.
double measure_inverse_share(const Scenario& scenario, Formulation formulation);

}  // namespace spoke::reproduce
