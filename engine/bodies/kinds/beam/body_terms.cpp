// Calculates inertia forces from the slots' momenta, elastic and damping forces from the elements.

#include "engine/bodies/kinds/beam/body_terms.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kinds/beam/body_slots.h"
#include "engine/bodies/kinds/beam/straight_terms.h"
#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/body_stiffening.h"
#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/nonlinear_strain.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// The inertia force of a slot at zero X and q'': b = -(A mu + 2 w x mu') with A = w w^T - |w|^2 1.
struct InertiaForce {
  double rows[3][kSlot];

  explicit InertiaForce(const Angular& w) {
    const double ww = w.squaredNorm();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rows[i][j] = (i == j ? ww : 0.0) - w[i] * w[j];
    const double turn[3][3] = {{0.0, -w[2], w[1]}, {w[2], 0.0, -w[0]}, {-w[1], w[0], 0.0}};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rows[i][3 + j] = -2.0 * turn[i][j];
  }
  /// Returns component i; the rate along i does not count.
  [[gnu::always_inline]] double component(int i, const double* mu) const {
    const double* r = rows[i];
    const int j = 3 + (i + 1) % 3, k = 3 + (i + 2) % 3;
    return (r[0] * mu[0] + r[1] * mu[1] + r[2] * mu[2]) + (r[j] * mu[j] + r[k] * mu[k]);
  }
};

/// Sets the rows of C_w^T and Q_f of a node: columns Xi^T (e_a x mu) for a = x, y, z, then Xi^T b +
/// force. For the rotation, sum e_c x (e_a x mu_c) = e_a tr(Mu) - mu_a over the axes c of the node.
void set_rows(const InertiaForce& b, const double* mu, const double* force, double* rows) {
  const double *r = mu, *x = mu + kSlot, *y = mu + 2 * kSlot, *z = mu + 3 * kSlot;
  const double trace = x[0] + y[1] + z[2];
  const double values[kTwist][4] = {
      {0.0, r[2], -r[1], b.component(0, r) + force[0]},
      {-r[2], 0.0, r[0], b.component(1, r) + force[1]},
      {r[1], -r[0], 0.0, b.component(2, r) + force[2]},
      {trace - x[0], -y[0], -z[0], b.component(2, y) - b.component(1, z) + force[3]},
      {-x[1], trace - y[1], -z[1], b.component(0, z) - b.component(2, x) + force[4]},
      {-x[2], -y[2], trace - z[2], b.component(1, x) - b.component(0, y) + force[5]}};
  for (int i = 0; i < kTwist; ++i) {
    store_aligned(Double2{values[i][0], values[i][1]}, rows + 4 * i);
    store_aligned(Double2{values[i][2], values[i][3]}, rows + 4 * i + 2);
  }
}

/// Adds the share of an element's stretch to the rows of u of its nodes: +- e1 (e1.(e_a x mu))/l,
/// and the same projection of b.
void add_stretch_rows(const BeamElement& element, const InertiaForce& b, const double* mu,
                      double* rows) {
  const Position e1 = element.axes.col(0) / element.length;
  const double columns[4] = {
      mu[1] * e1[2] - mu[2] * e1[1], mu[2] * e1[0] - mu[0] * e1[2], mu[0] * e1[1] - mu[1] * e1[0],
      e1[0] * b.component(0, mu) + e1[1] * b.component(1, mu) + e1[2] * b.component(2, mu)};
  const Double2 first{columns[0], columns[1]}, second{columns[2], columns[3]};
  double* outer = rows + kNodeRows;
  for (int i = 0; i < 3; ++i) {
    const double direction = element.axes(i, 0);
    store_aligned(load_aligned(rows + 4 * i) - direction * first, rows + 4 * i);
    store_aligned(load_aligned(rows + 4 * i + 2) - direction * second, rows + 4 * i + 2);
    store_aligned(load_aligned(outer + 4 * i) + direction * first, outer + 4 * i);
    store_aligned(load_aligned(outer + 4 * i + 2) + direction * second, outer + 4 * i + 2);
  }
}

void calc_rows(const FlexibleBody& body, const Angular& w, const BodyScratch& scratch,
               double* rows) {
  const InertiaForce b(w);
  for (int k = body.first_node(); k < body.node_count(); ++k)
    set_rows(b, scratch.momenta + kNodeSlots * kSlot * k, scratch.force + kTwist * k,
             rows + kNodeRows * k);
  // Node 0 of a clamped body has no rows that count: the share of the first element is not used.
  if (body.first_node() > 0) std::fill_n(rows, kNodeRows, 0.0);
  for (int e = 0; e < body.elements; ++e)
    add_stretch_rows(body.beam[static_cast<std::size_t>(e)], b,
                     scratch.momenta + stretch_place(body, e), rows + kNodeRows * e);
}

void add_elastic_force(const FlexibleBody& body, const double* q, double* force) {
  for (const BeamElement& element : body.beam) {
    double d[kTwist], F[kTwist];
    calc_relative(element, q, d);
    multiply(element.stiffness.data(), d).store_to(F);
    subtract_wrench(element, F, force);
    q += kTwist;
    force += kTwist;
  }
}

/// Returns the damping wrench of an element by the velocity d of its outer node. `is_damped`:
/// whether its own matrix damps, too.
Double6 damping_wrench(const BeamElement& element, bool is_damped, double stiffness_factor,
                       const double* d) {
  Double6 F;
  if (is_damped) F = multiply(element.damping.data(), d);
  if (stiffness_factor == 0.0) return F;
  const Double6 elastic = multiply(element.stiffness.data(), d);
  F.a += stiffness_factor * elastic.a;
  F.b += stiffness_factor * elastic.b;
  F.c += stiffness_factor * elastic.c;
  return F;
}

/// Adds the damping D = mass_factor Mff + stiffness_factor K + that of the sections: its force at
/// v_elastic; returns its power at v.
double add_damping(const FlexibleBody& body, const Damping& damping, const double* v_elastic,
                   const double* v, double* force) {
  double power = 0.0;
  const auto apply = [&](const double* velocity, auto&& take) {
    for (const BeamElement& element : body.beam) {
      double d[kTwist], F[kTwist];
      calc_relative(element, velocity, d);
      damping_wrench(element, body.is_damped, damping.stiffness_factor, d).store_to(F);
      take(element, d, F);
      velocity += kTwist;
    }
  };
  double* at = force;
  apply(v_elastic, [&at](const BeamElement& element, const double*, const double* F) {
    subtract_wrench(element, F, at);
    at += kTwist;
  });
  apply(v, [&power](const BeamElement&, const double* d, const double* F) {
    for (int i = 0; i < kTwist; ++i) power += d[i] * F[i];
  });
  return power;
}

using ConstNode = Eigen::Map<const Twist>;

/// Returns the row of node k of M x.
Twist mass_row(const BlockTridiagonal& M, int k, const double* x) {
  assert(k >= 0 && k < M.nodes());
  const auto node = static_cast<std::size_t>(k);
  Twist sum = M.diagonal[node].lazyProduct(ConstNode(x + kTwist * k));
  if (k > 0) sum += M.below[node - 1].lazyProduct(ConstNode(x + kTwist * (k - 1)));
  if (k + 1 < M.nodes())
    sum += M.below[node].transpose().lazyProduct(ConstNode(x + kTwist * (k + 1)));
  return sum;
}

double add_mass_damping(const FlexibleBody& body, double factor, const double* v_elastic,
                        const double* v, double* force) {
  double power = 0.0;
  for (int k = 0; k < body.node_count(); ++k) {
    Eigen::Map<Twist>(force + kTwist * k) -= factor * mass_row(body.M, k, v_elastic);
    power += factor * ConstNode(v + kTwist * k).dot(mass_row(body.M, k, v));
  }
  return power;
}

/// Flex vectors by node, expanded into scratch memory, each once.
struct NodalState {
  const double *q, *v, *q_elastic, *v_elastic;

  NodalState(const FlexibleBody& body, const BodyState& state, bool is_damped,
             const std::array<double*, 4>& nodal) {
    expand(body, state.q, nodal[0]);
    expand(body, state.v, nodal[1]);
    q = q_elastic = nodal[0];
    v = v_elastic = nodal[1];
    if (state.q_elastic != state.q) {
      expand(body, state.q_elastic, nodal[2]);
      q_elastic = nodal[2];
    }
    if (is_damped && state.v_elastic != state.v) {
      expand(body, state.v_elastic, nodal[3]);
      v_elastic = nodal[3];
    }
  }
};

/// Adds damping to the rows of a body whose directions do not meet.
double add_damping_to_rows(const FlexibleBody& body, const Damping& damping, const BodyState& state,
                           const BodyWork& work) {
  const ScratchRoom scratch(body, work);
  double power = 0.0;
  std::fill_n(scratch->force, kTwist * body.node_count(), 0.0);
  double *v = scratch->nodal[0], *v_elastic = scratch->nodal[1];
  expand(body, state.v, v);
  expand(body, state.v_elastic, v_elastic);
  if (body.is_damped || damping.stiffness_factor != 0.0)
    power += add_damping(body, damping, v_elastic, v, scratch->force);
  if (damping.mass_factor != 0.0)
    power += add_mass_damping(body, damping.mass_factor, v_elastic, v, scratch->force);
  for (int i = kTwist * body.first_node(); i < kTwist * body.node_count(); ++i)
    work.rows[4 * i + 3] += scratch->force[i];
  return power;
}

/// Calculates the terms of a body whose directions meet.
BodyTerms calc_coupled_terms(const BodyModel& model, const BodyState& state,
                             const BodyMotion& motion, const Damping& damping,
                             const BodyWork& work) {
  const FlexibleBody& body = *model.body;
  const bool is_damped = body.is_damped || damping.stiffness_factor != 0.0;
  const ScratchRoom scratch(body, work);
  const NodalState x(body, state, is_damped || damping.mass_factor != 0.0, scratch->nodal);
  double* const force = scratch->force;
  std::fill_n(force, kTwist * body.node_count(), 0.0);

  BodyTerms terms;
  TurnedInertia turned;
  if (body.is_nonlinear()) {
    terms.dissipation +=
        subtract_strain_forces(body, damping.stiffness_factor, {x.q_elastic, x.v_elastic},
                               {x.q, x.v}, scratch->slots, force);
    turned = subtract_turning(body, motion.w, {x.q, x.v}, force);
  } else {
    add_elastic_force(body, x.q_elastic, force);
    if (is_damped) terms.dissipation += add_damping(body, damping, x.v_elastic, x.v, force);
  }
  if (damping.mass_factor != 0.0)
    terms.dissipation += add_mass_damping(body, damping.mass_factor, x.v_elastic, x.v, force);
  if (model.tension) {
    const StiffeningSums tension = add_stiffening(model, motion, x.q, x.v, force);
    terms.stiffening = calc_hub_stiffening(*model.tension, motion.gravity, tension);
    terms.tension = calc_tension_moment(*model.tension, tension);
  }

  const SlotSums sums = calc_slots(body, x.q, x.v, *scratch);
  calc_rows(body, motion.w, *scratch, work.rows);
  terms.S = sums.S;
  terms.S_rate = sums.S_rate;
  terms.Theta = sums.inertia();
  if (body.is_nonlinear()) terms.Theta -= turned.value;
  terms.Q =
      calc_frame_force(motion.w, terms.S, terms.Theta.lazyProduct(motion.w), sums.S_rate, sums.G);
  if (body.is_nonlinear()) angular(terms.Q) += 2.0 * turned.rate.lazyProduct(motion.w);
  return terms;
}

}  // namespace

BodyTerms calc_body_terms(const BodyModel& model, const BodyState& state, const BodyMotion& motion,
                          const Damping& damping, const BodyWork& work) noexcept {
  assert(model.body && state.q && state.v && state.q_elastic && state.v_elastic);
  assert(damping.mass_factor >= 0.0 && damping.stiffness_factor >= 0.0);
  const FlexibleBody& body = *model.body;
  if (!body.is_decoupled || !body.directions)
    return run_large_kernel(
        [&]() noexcept { return calc_coupled_terms(model, state, motion, damping, work); });
  BodyTerms terms = calc_straight_terms(model, state, motion, work);
  if (body.is_damped || damping.stiffness_factor != 0.0 || damping.mass_factor != 0.0)
    terms.dissipation += add_damping_to_rows(body, damping, state, work);
  return terms;
}

}  // namespace spoke::space
