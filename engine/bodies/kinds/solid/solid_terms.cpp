// Forms the terms of a reduced solid from its products.

#include "engine/bodies/kinds/solid/solid_terms.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kinds/nodal/nodal_body.h"
#include "engine/bodies/space/solid_block.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// The vectors of one evaluation, `stride` values each, in the work memory.
struct ModalVectors {
  int modes, stride;
  double *q, *v;
  SlotProducts slots;
  double *force, *product;

  ModalVectors(const SolidModel& model, const BodyState& state, const BodyWork& work)
      : modes(model.products->modes), stride(model.products->stride) {
    double* next = work.scratch;
    const auto take = [&next, this](int count) {
      double* const place = next;
      next += count * stride;
      return place;
    };
    q = take(1);
    v = take(1);
    slots = {take(9), take(9)};
    force = take(1);
    product = take(1);
    copy_padded(state.q, modes, stride, q);
    copy_padded(state.v, modes, stride, v);
    std::fill_n(force, stride, 0.0);
  }

  const double* p(int a, int b) const { return slots.p + (3 * a + b) * stride; }
  const double* m_rate(int a, int b) const { return slots.m_rate + (3 * a + b) * stride; }
  double dot(const double* a, const double* b) const { return dot_padded(stride, a, b); }
};

/// Sums over the slots.
struct ModalSums {
  Position S, S_rate;
  Matrix3 J, G;
  double rate_energy = 0.0;  ///< 1/2 q'^T Mff q'; only for energies

  Matrix3 inertia() const { return J.trace() * Matrix3::Identity() - J; }
};

ModalSums sum_slots(const SolidConstants& body, const ReducedProducts& products,
                    const ModalVectors& x) {
  ModalSums sums;
  for (int a = 0; a < 3; ++a) {
    const double* C_t = &products.momentum[static_cast<std::size_t>(a * x.stride)];
    sums.S[a] = body.S0[a] + x.dot(C_t, x.q);
    sums.S_rate[a] = x.dot(C_t, x.v);
    for (int b = 0; b < 3; ++b) {
      sums.G(a, b) = x.dot(x.p(b, a), x.v);
      if (b < a) continue;
      const double* h = &products.at_rest[static_cast<std::size_t>((3 * b + a) * x.stride)];
      sums.J(a, b) = sums.J(b, a) = body.J0(a, b) + x.dot(h, x.q) + x.dot(x.p(a, b), x.q);
    }
  }
  return sums;
}

/// Sets the rows of C_w^T, and of the right-hand side: the inertia force and `force`.
void set_rows(const Angular& w, const ModalVectors& x, double* rows) {
  const Matrix3 A = w * w.transpose() - w.squaredNorm() * Matrix3::Identity();
  for (int k = 0; k < x.modes; ++k) {
    const auto p = [&](int a, int b) { return x.p(a, b)[k]; };
    const auto m = [&](int a, int b) { return x.m_rate(a, b)[k]; };
    double force = x.force[k];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) force -= A(a, b) * p(a, b);
    force -= 2.0 *
             (w[0] * (m(2, 1) - m(1, 2)) + w[1] * (m(0, 2) - m(2, 0)) + w[2] * (m(1, 0) - m(0, 1)));
    double* const row = rows + kSolidRow * k;
    row[0] = p(2, 1) - p(1, 2);
    row[1] = p(0, 2) - p(2, 0);
    row[2] = p(1, 0) - p(0, 1);
    row[3] = force;
  }
}

/// Adds elastic and damping forces; returns the power that the damping takes.
double add_elastic(const ReducedSolid& solid, const BodyState& state, const Damping& damping,
                   double* force) {
  double power = 0.0;
  for (Eigen::Index k = 0; k < solid.stiffness.size(); ++k) {
    const double d =
        solid.damping[k] + damping.mass_factor + damping.stiffness_factor * solid.stiffness[k];
    force[k] -= solid.stiffness[k] * state.q_elastic[k] + d * state.v_elastic[k];
    power += d * state.v[k] * state.v[k];
  }
  return power;
}

/// Adds the stiffening by the hub's rotation and by gravity.
void add_tension_in_tree(const SolidModel& model, const BodyMotion& motion, const ModalVectors& x,
                         BodyTerms& terms) {
  const Rotation& R = model.place->R_HB;
  put_stiffening(*model.place,
                 add_solid_stiffening(*model.tension, R.inverse() * motion.hub_w,
                                      R.inverse() * motion.gravity, x.q, x.v, x.product, x.force),
                 motion.gravity, terms);
}

/// Returns the sum of rho x mu' that follows from G = sum rho mu'^T.
Angular calc_spin(const Matrix3& G) {
  return {G(1, 2) - G(2, 1), G(2, 0) - G(0, 2), G(0, 1) - G(1, 0)};
}

BodyTerms calc_terms_of_modes(const SolidModel& model, const BodyState& state,
                              const BodyMotion& motion, const Damping& damping,
                              const BodyWork& work) {
  const SolidConstants& body = *model.body->constants;
  const ModalVectors x(model, state, work);
  multiply_slots(*model.products, x.q, x.v, x.slots);
  const ModalSums sums = sum_slots(body, *model.products, x);
  BodyTerms terms;
  terms.dissipation = add_elastic(*body.reduced(), state, damping, x.force);
  terms.S = sums.S;
  terms.S_rate = sums.S_rate;
  terms.Theta = sums.inertia();
  const Angular& w = motion.w;
  Angular Theta_w = terms.Theta.lazyProduct(w);
  terms.Q = calc_frame_force(w, terms.S, Theta_w, sums.S_rate, sums.G);
  if (model.tension && model.place) add_tension_in_tree(model, motion, x, terms);
  if (model.tension && !model.place) {
    const SolidStiffening own =
        add_solid_stiffening(*model.tension, w, Position::Zero(), x.q, x.v, x.product, x.force);
    terms.Theta -= own.Lambda;
    angular(terms.Q) += Angular(own.Lambda_rate * w + cross(w, Angular(own.Lambda * w)));
  }
  set_rows(w, x, work.rows);
  return terms;
}

/// The sums of a solid, and its stiffening along the axes of B.
struct ObservedSums {
  ModalSums sums;
  SolidStiffening stiffening;
};

ObservedSums observe(const SolidModel& model, const BodyState& state, const Position& gravity,
                     const BodyWork& work) {
  if (model.tiles) {
    const auto [sums, stiffening] = observe_nodal(model, state, gravity, work);
    return {{sums.S, sums.S_rate, sums.J, sums.G, sums.rate_energy}, stiffening};
  }
  const ModalVectors x(model, state, work);
  multiply_slots(*model.products, x.q, x.v, x.slots);
  ObservedSums observed{sum_slots(*model.body->constants, *model.products, x), {}};
  observed.sums.rate_energy = 0.5 * x.dot(x.v, x.v);
  if (model.tension)
    observed.stiffening = add_solid_stiffening(*model.tension, Angular::Zero(), gravity, x.q, x.v,
                                               x.product, x.force);
  return observed;
}

}  // namespace

BodyTerms calc_solid_terms(const SolidModel& model, const BodyState& state,
                           const BodyMotion& motion, const Damping& damping,
                           const BodyWork& work) noexcept {
  assert(model.body && state.q && state.v && state.q_elastic && state.v_elastic);
  if (model.tiles) {
    for (int p = 0; p < model.tiles->count(); ++p)
      calc_nodal_tile(model, p, state, motion, damping, work);
    return sum_nodal_terms(model, motion, work);
  }
  assert(model.products);
  return run_large_kernel(
      [&]() noexcept { return calc_terms_of_modes(model, state, motion, damping, work); });
}

BodyEnergies calc_solid_energies(const SolidModel& model, const BodyState& state,
                                 const Twist& twist, const BodyMotion& motion,
                                 const BodyWork& work) noexcept {
  assert(model.body && state.q && state.v);
  Position gravity = Position::Zero();
  if (model.place) gravity = model.place->R_HB.inverse() * motion.gravity;
  const auto [sums, stiffening] = observe(model, state, gravity, work);
  const Position v0 = linear(twist), w = angular(twist);
  BodyEnergies energies;
  energies.S = sums.S;
  energies.kinetic = 0.5 * model.body->constants->mass * v0.squaredNorm() +
                     v0.dot(cross(w, sums.S) + sums.S_rate) +
                     0.5 * w.dot(sums.inertia().lazyProduct(w)) + w.dot(calc_spin(sums.G)) +
                     sums.rate_energy;
  energies.strain = calc_strain_energy(*model.body, state.q);
  if (!model.tension) return energies;
  if (model.place) {
    BodyTerms terms;
    put_stiffening(*model.place, stiffening, motion.gravity, terms);
    energies.kinetic -= 0.5 * motion.hub_w.dot(terms.stiffening.inertia.lazyProduct(motion.hub_w));
    energies.tension = motion.gravity.dot(terms.tension.value);
    return energies;
  }
  energies.kinetic -= 0.5 * w.dot(stiffening.Lambda.lazyProduct(w));
  return energies;
}

Matrix3 calc_stiffening_inertia(const SolidModel& model, const BodyState& state,
                                const BodyWork& work) noexcept {
  assert(model.tension && model.place);
  const Matrix3 Lambda = observe(model, state, Position::Zero(), work).stiffening.Lambda;
  return turn_tensor(model.place->R_HB, Lambda);
}

Twist calc_solid_momentum(const SolidModel& model, const BodyState& state, const Twist& twist,
                          const BodyWork& work) noexcept {
  const auto [sums, stiffening] = observe(model, state, Position::Zero(), work);
  const Position v0 = linear(twist), w = angular(twist);
  Twist momentum =
      make_twist(model.body->constants->mass * v0 + cross(w, sums.S) + sums.S_rate,
                 cross(sums.S, v0) + Position(sums.inertia().lazyProduct(w)) + calc_spin(sums.G));
  if (model.tension && !model.place) angular(momentum) -= stiffening.Lambda.lazyProduct(w);
  return momentum;
}

double calc_strain_energy(const Solid& body, const double* q) noexcept {
  assert(q);
  const ReducedSolid* solid = body.constants->reduced();
  if (!solid) return calc_nodal_strain_energy(*body.constants->nodal(), q);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < solid->stiffness.size(); ++k)
    sum += solid->stiffness[k] * q[k] * q[k];
  return 0.5 * sum;
}

}  // namespace spoke::space
