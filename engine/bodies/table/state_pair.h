#pragma once

// States of what acts on a subsystem and follows its motion with a delay: of a wake, a flow that
// separates, a fluid around a body. Steps, saved states, processes and states at rest take them
// from here, whatever acts.

#include <algorithm>

#include "engine/support/page_arena.h"
#include "graph/access.h"

namespace spoke {

/// The states at the end of the last step, from which evaluations go on, and those that the last
/// evaluation has reached at its time. The last value of each says whether there are any yet, 0 or
/// 1: before, what acts is in equilibrium with the motion.
struct StatePair {
  ArenaVector<double> kept, reached;
  graph::PartId kept_part, reached_part;

  bool has_begun() const { return kept.back() != 0.0; }
  /// Keeps what the last evaluation has reached.
  void keep() noexcept { std::copy(reached.begin(), reached.end(), kept.begin()); }
  /// Lets the states be those of equilibrium again.
  void forget() noexcept { kept.back() = 0.0; }
};

/// One of a pair's states that relaxes: z, of which the force -z acts on a coordinate q, with
/// z' = k q' - z/T.
struct RelaxingState {
  const StatePair* pair = nullptr;
  std::size_t index = 0;   ///< of the pair's states
  int body = 0;            ///< of the subsystem
  int coordinate = 0;      ///< of the joint that carries the body
  double stiffness = 0.0;  ///< k [N m/rad, N/m]
  double time = 0.0;       ///< T [s]
};

}  // namespace spoke
