// Orientations in the two methods of integration.

#include "engine/space/integrator/rotation.h"

#include "models/space/rotation_vector.h"

namespace spoke::space {
namespace {

Angular read(const double* values, int at) { return {values[at], values[at + 1], values[at + 2]}; }

void add(const Angular& share, double* values, int at) {
  for (int c = 0; c < kAngular; ++c) values[at + c] += share[c];
}

/// D' - w at the present stage. H belongs to velocities in the parent's frame, H^T = H(-D) to those
/// in the child's.
Angular calc_excess_rate(const RotationBlock& rotation) {
  const Angular D = read(rotation.block->q, rotation.at);
  const Angular w = read(rotation.block->v, rotation.at);
  const Angular turned = rotation.frame == TurnFrame::child ? Angular(-D) : D;
  return calc_inverse_tangent(turned) * w - w;
}

}  // namespace

Quaternion calc_orientation(const RotationBlock& rotation) noexcept {
  return turn(*rotation.reference, read(rotation.block->q, rotation.at), rotation.frame);
}

void fold(const RotationBlock& rotation) noexcept {
  *rotation.reference = normalize(calc_orientation(rotation));
  for (int c = 0; c < kAngular; ++c) rotation.block->q[rotation.at + c] = 0.0;
}

void advance(const Rk4& method, int stage, const RotationBlock& rotation) noexcept {
  CoordinateBlock& block = *rotation.block;
  if (stage == 1) {  // D = 0, where D' = w
    fold(rotation);
    return spoke::advance(method, stage, block);
  }
  const Angular excess = calc_excess_rate(rotation);
  spoke::advance(method, stage, block);
  // The stage before has the weight by which its rate enters the step's sum, and `span` times it
  // the coordinate.
  const bool is_last = stage == 0;
  const double weight = Rk4::weights[static_cast<std::size_t>(is_last ? Rk4::kStages : stage) - 1];
  const double span =
      method.step * (is_last ? weight : Rk4::nodes[static_cast<std::size_t>(stage)]);
  add(weight * excess, block.history[Rk4::sum_q], rotation.at);
  add(span * excess, block.q, rotation.at);
}

void predict(const GeneralizedAlpha& method, const RotationBlock& rotation) noexcept {
  fold(rotation);
  spoke::predict(method, *rotation.block);
}

}  // namespace spoke::space
