#pragma once

// The end of a body's recovery, for the nodes that make it.

#include "engine/step/assembly.h"

namespace spoke {

/// Parts that a node reads and writes.
struct RecoveryAccess {
  PartList inputs;
  PartList outputs;
};
/// Returns those of a body's recovery that is one node.
template <class World>
RecoveryAccess recovery_access(const Assembly<World>& g, int i, int j);
/// Returns those of its end, where its accelerations are found by other nodes.
template <class World>
RecoveryAccess completion_access(const Assembly<World>& g, int i, int j);
/// Hands the accelerations of body `j` to the integrator, and reports.
template <class World>
void complete_recovery(const Method& method, int j, SubsystemData<World>& data) noexcept;

}  // namespace spoke
