#pragma once

#include "engine/simulation.h"

namespace spoke::test {

/// The formulation that users get, on one thread.
inline const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

/// Any formulation, on one thread, each run of one pass.
inline SimulationOptions serial(Formulation formulation) {
  return {formulation, ExecutorKind::serial, 1, 1};
}

}  // namespace spoke::test
