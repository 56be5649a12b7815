// Calculates the hub's state from its coordinates.

#include "engine/bodies/space/hub_motion.h"

#include <cassert>

namespace spoke::space {

HubState calc_hub_state(const double* q, const double* v, const HubAttitude& attitude) noexcept {
  assert(q && v);
  HubState state;
  state.p = {q[0], q[1], q[2]};
  state.R = make_rotation(turn(attitude.reference, Angular(q[3], q[4], q[5]), TurnFrame::child));
  state.twist = make_twist(state.R.inverse() * Position(v[0], v[1], v[2]),
                           Angular(v[3], v[4], v[5] + attitude.mount_spin));
  return state;
}

}  // namespace spoke::space
