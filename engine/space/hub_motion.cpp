// The hub's state and acceleration, from its coordinates and to them.

#include "engine/space/hub_motion.h"

namespace spoke::space {
namespace {

/// What is of the prescribed components, or of the free ones; zero in place of the others.
Twist select(const Prescribed& prescribed, bool which, Twist v) {
  for (int c = 0; c < kTwist; ++c)
    if (prescribed[static_cast<std::size_t>(c)] != which) v[c] = 0.0;
  return v;
}

}  // namespace

HubState calc_hub_state(const double* q, const double* v, const Quaternion& reference) noexcept {
  HubState state;
  state.p = {q[0], q[1], q[2]};
  state.R = make_rotation(turn(reference, Angular(q[3], q[4], q[5]), TurnFrame::child));
  state.twist =
      make_twist(state.R.inverse() * Position(v[0], v[1], v[2]), Angular(v[3], v[4], v[5]));
  return state;
}

Twist calc_given(const Prescribed& prescribed, const Rotation& R, const Position& gravity,
                 const Position& acceleration, const Angular& alpha) noexcept {
  const Position less_gravity = acceleration - gravity;
  return select(prescribed, true, make_twist(R.inverse() * less_gravity, alpha));
}

Twist calc_coordinate_accelerations(const Prescribed& prescribed, const Rotation& R,
                                    const Position& gravity, const Twist& acceleration) noexcept {
  Twist found = acceleration;
  linear(found) = R * Position(linear(acceleration)) + gravity;
  return select(prescribed, false, found);
}

}  // namespace spoke::space
