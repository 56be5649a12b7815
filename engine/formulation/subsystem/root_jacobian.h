#pragma once

// The rows of the hub's motion in the joint equations of a blade, Phi_Y of (P 10).

#include "models/system/system.h"

namespace spoke::subsystem {

/// T = [I, B p; 0, 1] of the root bracket: its twist per hub twist, hub frame. With R_PB^T in front
/// it is Phi_Y of (P 4).
template <class World>
TwistMatrixOf<World> root_jacobian(const Subsystem<World>& subsystem) {
  return translation_matrix(subsystem.root.p);
}

}  // namespace spoke::subsystem
