// Walks along the primitives of a joint, outward: docs/formulation.md, section 11. The columns of
// those ahead are zero until they are reached.

#include "engine/bodies/space/joint_motion.h"

#include <cassert>

namespace spoke::space {
namespace {

/// Walks the way from the handle to the child. The frame that has been reached is that of motion.R
/// and motion.p, its twist, resolved in the parent's frame, (v, w).
class Walk {
 public:
  Walk(const Joint& joint, const JointState& state, const Twist& handle, JointMotion& motion)
      : joint_(joint), state_(state), motion_(motion), v_(linear(handle)), w_(angular(handle)) {}

  /// Moves on by p, which changes at p_rate; both in the frame reached. With r = R p, r' = R p_rate
  ///   b_t += b_r x r + w x (w x r) + 2 w x r',  H_c,t += H_c,r x r,  p += r,  v += w x r + r'
  void move_on(const Position& p, const Position& p_rate) {
    const Position r = motion_.R * p, r_rate = motion_.R * p_rate;
    linear(motion_.bias) +=
        cross(angular(motion_.bias), r) + cross(w_, cross(w_, r)) + 2.0 * cross(w_, r_rate);
    for (int c = 0; c < joint_.coordinates + joint_.driven; ++c) {
      auto column = motion_.columns.col(c);
      column.head<kPosition>() += cross(column.tail<kAngular>(), r);
    }
    motion_.p += r;
    v_ += cross(w_, r) + r_rate;
  }
  void move_on(const Position& p) { move_on(p, Position::Zero()); }

  void pass(const JointPrimitive& primitive) {
    switch (primitive.kind) {
      case JointPrimitive::Kind::revolute:
        return revolve(primitive);
      case JointPrimitive::Kind::prismatic:
        return slide(primitive);
      case JointPrimitive::Kind::spherical:
        return turn_freely(primitive);
    }
  }

  /// Returns the twist of the frame reached, in that frame.
  Twist twist() const { return motion_.R.inverse() * make_twist(v_, w_); }

 private:
  /// Value, rate and prescribed acceleration of the next component, and its column's place.
  struct Component {
    PrescribedMotion motion;
    int column;
  };
  Component next_component(const JointPrimitive& primitive) {
    if (primitive.is_driven) {
      const PrescribedMotion& given = state_.driven[driven_];
      return {given, joint_.coordinates + driven_++};
    }
    const Component component{{state_.q[free_], state_.v[free_], 0.0}, free_};
    ++free_;
    return component;
  }

  /// Turns by q about the axis n: b_r += q' w x n + q'' n, w += q' n, H_r = n, R = R exp(q n~); q''
  /// where it is prescribed.
  void revolve(const JointPrimitive& primitive) {
    const Component component = next_component(primitive);
    const Angular axis = motion_.R * primitive.axis;
    const double rate = component.motion.rate;
    angular(motion_.bias) += rate * cross(w_, axis) + component.motion.acceleration * axis;
    w_ += rate * axis;
    motion_.columns.col(component.column).tail<kAngular>() = axis;
    motion_.R = motion_.R * exponential(component.motion.value * primitive.axis);
  }

  /// Moves on by q along the axis n: r = q n, r' = q' n, b_t += q'' n, H_t = n; q'' where it is
  /// prescribed.
  void slide(const JointPrimitive& primitive) {
    const Component component = next_component(primitive);
    move_on(component.motion.value * primitive.axis, component.motion.rate * primitive.axis);
    const Position axis = motion_.R * primitive.axis;
    linear(motion_.bias) += component.motion.acceleration * axis;
    motion_.columns.col(component.column).head<kPosition>() = axis;
  }

  /// Turns by Q: b_r += w x w_J, w += w_J, H_r = R, R = R Q; w_J and H_r are resolved in the
  /// child's frame or the parent's.
  void turn_freely(const JointPrimitive& primitive) {
    const Rotation turned = motion_.R * make_rotation(calc_orientation(joint_, primitive, state_));
    const Rotation& R = primitive.frame == TurnFrame::child ? turned : motion_.R;
    const Angular relative = R * Angular(state_.v[free_], state_.v[free_ + 1], state_.v[free_ + 2]);
    angular(motion_.bias) += cross(w_, relative);
    w_ += relative;
    motion_.columns.middleCols<kAngular>(free_).bottomRows<kAngular>() = R.axes;
    free_ += kAngular;
    motion_.R = turned;
  }

  const Joint& joint_;
  const JointState& state_;
  JointMotion& motion_;
  Position v_;
  Angular w_;
  int free_ = 0;    // coordinates reached
  int driven_ = 0;  // driven components reached
};

}  // namespace

void calc_joint_motion(const Joint& joint, const JointState& state, const Rotation& section,
                       const Twist& handle, JointMotion& motion, Twist& child) noexcept {
  assert(joint.coordinates + joint.driven <= Joint::kMost);
  assert((joint.coordinates == 0 || (state.q && state.v)) && (joint.driven == 0 || state.driven));
  motion.R = section;
  motion.p.setZero();
  motion.columns.setZero();
  motion.bias.setZero();
  Walk walk(joint, state, handle, motion);
  if (!joint.offset.p.isZero(0.0)) walk.move_on(joint.offset.p);  // zero where a beam goes on
  motion.R = motion.R * joint.offset.R;
  for (const JointPrimitive& primitive : joint.sequence()) walk.pass(primitive);
  child = walk.twist();
}

void leave_section(const RotationVectorMotion& section, JointMotion& motion,
                   Twist& child) noexcept {
  motion.R = motion.R * section.R.inverse();
  child = section.R * child;
  angular(child) -= section.velocity;
}

Twist calc_carried_acceleration(const JointMotion& motion, const Twist& handle) noexcept {
  return motion.R.inverse() * Twist(refer(-motion.p, handle) + motion.bias);
}

Quaternion calc_orientation(const Joint& joint, const JointPrimitive& spherical,
                            const JointState& state) noexcept {
  assert(joint.spherical_at >= 0 && joint.spherical_at + kAngular <= joint.coordinates);
  assert(spherical.kind == JointPrimitive::Kind::spherical && state.reference);
  const double* q = state.q + joint.spherical_at;
  return turn(*state.reference, Angular(q[0], q[1], q[2]), spherical.frame);
}

double calc_drive_force(const Joint& joint, const JointMotion& motion, int c,
                        const Twist& F) noexcept {
  assert(c >= 0 && c < joint.driven);
  return motion.columns.col(joint.coordinates + c).dot(motion.R * F);
}

double calc_drive_power(const Joint& joint, const JointState& state, const JointMotion& motion,
                        const Twist& F) noexcept {
  double sum = 0.0;
  for (int c = 0; c < joint.driven; ++c)
    sum += state.driven[c].rate * calc_drive_force(joint, motion, c, F);
  return sum;
}

}  // namespace spoke::space
