// Orientations in the two methods of integration.

#include "engine/step/integrator/rotation.h"

#include <cassert>

namespace spoke::space {
namespace {

Angular read(const double* values, int at) { return {values[at], values[at + 1], values[at + 2]}; }

void write(const Angular& from, double* values, int at) {
  for (int c = 0; c < kAngular; ++c) values[at + c] = from[c];
}

/// Returns P' of P = exp(D~) at the present stage.
Quaternion calc_relative_rate(const RotationBlock& rotation) {
  const Quaternion P = make_quaternion(read(rotation.block->q, rotation.at));
  const Angular w = read(rotation.block->v, rotation.at);
  return rotation.frame == TurnFrame::child ? calc_rate(P, w) : calc_rate(w, P);
}

/// Begins stage 0 with projection, which turns the orientation by a small rotation.
void project(const Rk4& method, const RotationBlock& rotation) {
  double* q = rotation.block->q;
  const Angular before = read(q, rotation.at);
  write(Angular::Zero(), q, rotation.at);
  spoke::advance(method, 0, *rotation.block);
  const Angular by = read(q, rotation.at);
  write(logarithm(turn(make_quaternion(before), by, rotation.frame)), q, rotation.at);
}

}  // namespace

Quaternion calc_orientation(const RotationBlock& rotation) noexcept {
  assert(rotation.state && rotation.at >= 0 && rotation.at + kAngular <= rotation.block->size);
  return turn(rotation.state->reference, read(rotation.block->q, rotation.at), rotation.frame);
}

void fold(const RotationBlock& rotation) noexcept {
  rotation.state->reference = normalize(calc_orientation(rotation));
  write(Angular::Zero(), rotation.block->q, rotation.at);
}

void advance(const Rk4& method, int stage, const RotationBlock& rotation) noexcept {
  assert(stage >= 0 && stage < method.passes());
  if (stage == Rk4::kClosing || stage == Rk4::kBraking)
    return spoke::advance(method, stage, *rotation.block);
  if (stage == 0 && method.projects) return project(method, rotation);
  // `stage` follows the one in which the rate was found.
  const bool is_last = stage == 0 || stage == Rk4::kAtEnd;
  const auto found_in = static_cast<std::size_t>(is_last ? Rk4::kStages : stage) - 1;
  Quaternion& sum = rotation.state->sum;
  if (found_in == 0) {
    fold(rotation);
    sum = {0.0, Position::Zero()};
  }
  const Quaternion rate = calc_relative_rate(rotation);
  sum = sum + Rk4::weights[found_in] * rate;
  spoke::advance(method, stage, *rotation.block);
  const Quaternion step = is_last ? sum : Rk4::nodes[static_cast<std::size_t>(stage)] * rate;
  write(logarithm(Quaternion{} + method.step * step), rotation.block->q, rotation.at);
}

void predict(const GeneralizedAlpha& method, int order, const RotationBlock& rotation) noexcept {
  fold(rotation);
  spoke::predict(method, order, *rotation.block);
}

}  // namespace spoke::space
