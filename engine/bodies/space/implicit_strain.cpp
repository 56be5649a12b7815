// Sums the tangents of the elements, and multiplies accelerations by them.

#include "engine/bodies/space/implicit_strain.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/implicit_tension.h"
#include "engine/bodies/space/nonlinear_strain.h"

namespace spoke::space {
namespace {

using StateNode = Eigen::Map<Twist>;
using ConstNode = Eigen::Map<const Twist>;

void clear(ImplicitStrain& strain) {
  for (TwistMatrix& block : strain.added.diagonal) block.setZero();
  for (TwistMatrix& block : strain.added.below) block.setZero();
  for (NodeMomentum& node : strain.lean) node.setZero();
  strain.turn.setZero();
}

/// Adds A x by node to y, for a symmetric A.
void add_product(const BlockTridiagonal& A, const double* x, double* y) {
  for (int k = 0; k < A.nodes(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    StateNode(y + kTwist * k) += A.diagonal[at].lazyProduct(ConstNode(x + kTwist * k));
    if (k == 0) continue;
    const TwistMatrix& below = A.below[at - 1];
    StateNode(y + kTwist * k) += below.lazyProduct(ConstNode(x + kTwist * (k - 1)));
    StateNode(y + kTwist * (k - 1)) += below.transpose().lazyProduct(ConstNode(x + kTwist * k));
  }
}

/// Makes the block at coordinates by node, with `gain` times what the wrenches add to D^T K D: of
/// a pressure, too, as far as it softens both the body and its frame. Returns whether the block is
/// positive definite.
bool set_block(const FlexibleBody& body, const double* q, double gain, ImplicitStrain& strain) {
  clear(strain);
  add_tangents(body, strain.factors, gain, q, strain.wrenches.data(), strain.added);
  for (int e = 0; e < body.elements; ++e) {
    const auto at = static_cast<std::size_t>(e);
    const BeamElement& element = body.beam[at];
    const double tension = element.axes.col(0).dot(linear(strain.wrenches[at]));
    const Matrix4 K = gain * tension * element.stiffening.bending[0];
    add_lean(element, e, K, body.is_straight, strain.lean, strain.turn);
  }
  return factorise_anew(body, {}, strain.added, &strain.shift, strain.block);
}

}  // namespace

ImplicitStrain make_implicit_strain(const FlexibleBody& body, const BlockFactors& factors,
                                    double gain, const ElasticBlock& block) {
  assert(body.is_nonlinear() && gain > 0.0);
  ImplicitStrain strain;
  strain.factors = factors;
  strain.gain = gain;
  strain.wrenches.assign(static_cast<std::size_t>(body.elements), Twist::Zero());
  strain.nodal.assign(static_cast<std::size_t>(kTwist * body.node_count() + 3 * body.elements),
                      0.0);
  strain.added = BlockTridiagonal(body.node_count());
  strain.lean.assign(static_cast<std::size_t>(body.node_count()), NodeMomentum::Zero());
  strain.shift.nodes.resize(static_cast<std::size_t>(body.node_count()));
  strain.block = block;
  return strain;
}

void keep_wrenches(const FlexibleBody& body, const double* q, ImplicitStrain& strain) noexcept {
  double* const nodal = strain.nodal.data();
  expand(body, q, nodal);
  calc_strain_wrenches(body, nodal, nodal + kTwist * body.node_count(), strain.wrenches.data());
}

void follow_strain(const FlexibleBody& body, const double* q, const BodyWork& work,
                   ImplicitStrain& strain) noexcept {
  assert(std::cmp_equal(strain.wrenches.size(), body.elements));
  const ScratchRoom scratch(body, work);
  double* const nodal = scratch->nodal[0];
  expand(body, q, nodal);
  set_shift(body, nodal, strain.shift);
  // A body on its way to buckle, in a step as long as that takes.
  if (!set_block(body, nodal, strain.gain, strain)) set_block(body, nodal, 0.0, strain);
}

void add_implicit_strain(const FlexibleBody& body, const ImplicitStrain& strain, const double* a,
                         const Angular& turn, const BodyWork& work, BodyTerms& terms) noexcept {
  assert(std::cmp_equal(strain.lean.size(), body.node_count()) && a);
  const ScratchRoom scratch(body, work);
  double *nodal = scratch->nodal[0], *force = scratch->force;
  expand(body, a, nodal);
  std::fill_n(force, kTwist * body.node_count(), 0.0);
  // (Mhat - Mff) A, with Mhat of shifted coordinates.
  double* const mass = scratch->nodal[1];
  std::fill_n(mass, kTwist * body.node_count(), 0.0);
  add_product(body.M, nodal, mass);
  double* const shifted = scratch->nodal[2];
  std::copy_n(nodal, kTwist * body.node_count(), shifted);
  strain.shift.apply_inverse(shifted);
  add_product(body.M, shifted, force);
  add_product(strain.added, shifted, force);
  strain.shift.apply_inverse_transposed(force);
  for (int i = 0; i < kTwist * body.node_count(); ++i) force[i] -= mass[i];
  Angular moment = strain.turn.lazyProduct(turn);
  for (int k = 0; k < body.node_count(); ++k) {
    const NodeMomentum& lean = strain.lean[static_cast<std::size_t>(k)];
    moment += lean.transpose().lazyProduct(ConstNode(nodal + kTwist * k));
    StateNode(force + kTwist * k) += lean.lazyProduct(turn);
  }
  angular(terms.Q) += moment;
  terms.Theta += strain.turn;
  double* row = work.rows + kNodeRows * body.first_node();
  for (int k = body.first_node(); k < body.node_count(); ++k) {
    const NodeMomentum& lean = strain.lean[static_cast<std::size_t>(k)];
    for (int c = 0; c < kTwist; ++c, row += 4) {
      for (int i = 0; i < 3; ++i) row[i] += lean(c, i);
      row[3] += force[kTwist * k + c];
    }
  }
}

}  // namespace spoke::space
