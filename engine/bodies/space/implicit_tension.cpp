// Weighs the tension matrices of the elements, and applies them to slopes of frame and deformation.

#include "engine/bodies/space/implicit_tension.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/plane_coordinates.h"
#include "engine/bodies/space/tension_weights.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Returns the slopes that the rotation of the frame gives to an element, by plane.
Double2 slope_by_turn(const BeamElement& element, bool is_straight, const Angular& turn) {
  if (is_straight) return Double2{turn[2], -turn[1]};
  return Double2{element.axes.col(2).dot(turn), -element.axes.col(1).dot(turn)};
}
/// Returns the moment on the frame, in B, of moments along the slopes: the transposed map.
Angular turn_by_slope(const BeamElement& element, bool is_straight, const Double2& moment) {
  if (is_straight) return {0.0, -moment[1], moment[0]};
  return element.axes.col(2) * moment[0] - element.axes.col(1) * moment[1];
}

/// Adds -K y of an element to the forces at its nodes; q: of both nodes. Returns the moment on the
/// frame.
Angular subtract_tension(const BeamElement& element, const ImplicitTension::Element& K,
                         bool is_straight, const double* q, const Angular& turn, double* force) {
  PlaneCoordinates x = in_axes_of(element, is_straight, q);
  const Double2 slope = slope_by_turn(element, is_straight, turn);
  x.rise += element.length * slope;
  for (Double2& at : x.slope) at += slope;
  PlaneCoordinates f = multiply_planes(K.bending, x);
  const double trapeze = K.torsion * (x.torsion[1] - x.torsion[0]);
  f.torsion[0] = -trapeze;
  f.torsion[1] = trapeze;
  subtract_forces_of(element, is_straight, f, force);
  const Double2 moment = element.length * f.rise + f.slope[0] + f.slope[1];
  return turn_by_slope(element, is_straight, -moment);
}

/// Adds the columns of K of an element, by unit values of its coordinates.
void add_columns(const BeamElement& element, int e, bool is_straight, ImplicitTension& tension) {
  constexpr int kBoth = 2 * kTwist;
  const ImplicitTension::Element& K = tension.elements[static_cast<std::size_t>(e)];
  Eigen::Matrix<double, kBoth, kBoth> matrix;
  for (int c = 0; c < kBoth; ++c) {
    double unit[kBoth]{}, force[kBoth]{};
    unit[c] = 1.0;
    subtract_tension(element, K, is_straight, unit, Angular::Zero(), force);
    for (int r = 0; r < kBoth; ++r) matrix(r, c) = -force[r];
  }
  tension.stiffness.add(e, matrix);
  add_lean(element, e, K.bending, is_straight, tension.lean, tension.turn);
}

void clear(ImplicitTension& tension) {
  for (TwistMatrix& block : tension.stiffness.diagonal) block.setZero();
  for (TwistMatrix& block : tension.stiffness.below) block.setZero();
  for (NodeMomentum& node : tension.lean) node.setZero();
  tension.turn.setZero();
}

/// Weighs the elements at the speed of the tension; compression is left out.
void weigh_elements(const FlexibleBody& body, const TensionPlace& place, ImplicitTension& tension) {
  const BodyMotion motion{Angular::Zero(), tension.w, Position::Zero()};
  TensionWeights weights = calc_tension_weights(place, motion);
  const CarriedMass* carried = place.carried.data();
  for (int e = 0; e < body.elements; ++e) {
    while (e == carried->end) ++carried;
    weights.tension[0] = carried_tension(*carried, weights);
    const ElementStiffening& from = body.beam[static_cast<std::size_t>(e)].stiffening;
    ImplicitTension::Element& to = tension.elements[static_cast<std::size_t>(e)];
    to = {};
    for (std::size_t k = 0; k < weights.tension.size(); ++k) {
      to.bending += tension.gain * weights.tension[k] * from.bending[k];
      to.torsion += tension.gain * weights.tension[k] * from.torsion[k];
    }
    if (to.bending(1, 1) <= 0.0 || to.bending(3, 3) <= 0.0 || to.torsion < 0.0) to = {};
  }
}

/// Returns the nearest of 32 speeds between a power of two and the next, by the largest component.
Angular round_speed(const Angular& w) {
  const double most = w.cwiseAbs().maxCoeff();
  if (!(most > 0.0) || !std::isfinite(most)) return Angular::Zero();
  const double unit = std::ldexp(1.0, std::ilogb(most) - 5);
  return unit * Angular(w / unit).array().round().matrix();
}

/// Sets all but the block, at the speed w of the tension.
void set_matrices(const FlexibleBody& body, const TensionPlace& place, ImplicitTension& tension) {
  weigh_elements(body, place, tension);
  clear(tension);
  for (int e = 0; e < body.elements; ++e)
    add_columns(body.beam[static_cast<std::size_t>(e)], e, body.is_straight, tension);
}

/// Returns the speed from which on tension counts: there a rotation of the frame feels a hundredth
/// of the body's inertia.
double find_least_speed(const FlexibleBody& body, const TensionPlace& place,
                        ImplicitTension& tension) {
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    tension.w = Angular::Unit(axis);
    set_matrices(body, place, tension);
    most = std::max(most, tension.turn.diagonal().maxCoeff());
  }
  return std::sqrt(0.01 * body.J0(0, 0) / most);
}

}  // namespace

ImplicitTension make_implicit_tension(const FlexibleBody& body, const TensionPlace& place,
                                      const BlockFactors& factors, double gain,
                                      const ElasticBlock& block) {
  assert(gain > 0.0 && !place.carried.empty() && place.carried.back().end >= body.elements);
  ImplicitTension tension;
  tension.factors = factors;
  tension.gain = gain;
  tension.elements.resize(static_cast<std::size_t>(body.elements));
  tension.stiffness = BlockTridiagonal(body.node_count());
  tension.lean.resize(static_cast<std::size_t>(body.node_count()));
  tension.least = find_least_speed(body, place, tension);
  tension.w.setConstant(std::numeric_limits<double>::quiet_NaN());
  tension.block = block;
  return tension;
}

void follow_speed(const FlexibleBody& body, const TensionPlace& place, const Angular& w,
                  ImplicitTension& tension) noexcept {
  assert(std::cmp_equal(tension.elements.size(), body.elements));
  const Angular speed = tension.counts_at(w) ? round_speed(w) : Angular(Angular::Zero());
  if (speed == tension.w) return;
  tension.w = speed;
  set_matrices(body, place, tension);
  [[maybe_unused]] const bool is_made =
      factorise_anew(body, tension.factors, tension.stiffness, nullptr, tension.block);
  assert(is_made && "positive definite: pressure is left out");
}

void add_lean(const BeamElement& element, int e, const Matrix4& bending, bool is_straight,
              std::vector<NodeMomentum>& lean, Matrix3& turn) noexcept {
  for (int c = 0; c < 3; ++c) {
    const double still[2 * kTwist]{};
    double force[2 * kTwist]{};
    turn.col(c) -=
        subtract_tension(element, {bending, 0.0}, is_straight, still, Angular::Unit(c), force);
    for (int node = 0; node < 2; ++node)
      for (int r = 0; r < kTwist; ++r)
        lean[static_cast<std::size_t>(e + node)](r, c) -= force[kTwist * node + r];
  }
}

void add_implicit_tension(const FlexibleBody& body, const ImplicitTension& tension, const double* a,
                          const Angular& turn, const BodyWork& work, BodyTerms& terms) noexcept {
  assert(std::cmp_equal(tension.lean.size(), body.node_count()) && a);
  run_large_kernel([&]() noexcept {
    const ScratchRoom scratch(body, work);
    double *nodal = scratch->nodal[0], *force = scratch->force;
    expand(body, a, nodal);
    std::fill_n(force, kTwist * body.node_count(), 0.0);
    Angular moment = Angular::Zero();
    for (int e = 0; e < body.elements; ++e)
      moment += subtract_tension(body.beam[static_cast<std::size_t>(e)],
                                 tension.elements[static_cast<std::size_t>(e)], body.is_straight,
                                 nodal + kTwist * e, turn, force + kTwist * e);
    angular(terms.Q) -= moment;
    terms.Theta += tension.turn;
    double* row = work.rows + kNodeRows * body.first_node();
    for (int k = body.first_node(); k < body.node_count(); ++k) {
      const NodeMomentum& lean = tension.lean[static_cast<std::size_t>(k)];
      for (int c = 0; c < kTwist; ++c, row += 4) {
        for (int i = 0; i < 3; ++i) row[i] += lean(c, i);
        row[3] -= force[kTwist * k + c];
      }
    }
  });
}

}  // namespace spoke::space
