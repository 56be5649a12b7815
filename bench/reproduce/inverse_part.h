#pragma once

// The part of a step that the paper times in Fig. 12.

#include <memory>

#include "engine/simulation.h"

namespace spoke::reproduce {

/// A graph of a step's nodes "inverse" alone, run as often as rk4 runs them in a step. On more than
/// one thread its time includes forks and barriers.
class InversePart {
 public:
  /// Precondition: the formulation has such nodes (structured, subsystem).
  InversePart(const Scenario& scenario, const SimulationOptions& options);
  ~InversePart();
  InversePart(const InversePart&) = delete;
  InversePart& operator=(const InversePart&) = delete;

  void run(std::int64_t steps);
  int nodes() const;  ///< number of nodes in one evaluation

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the share of the nodes "inverse" in a step's work on one thread, from the costs of all
/// nodes, timed one by one in the same runs.
double measure_inverse_share(const Scenario& scenario, Formulation formulation);

}  // namespace spoke::reproduce
