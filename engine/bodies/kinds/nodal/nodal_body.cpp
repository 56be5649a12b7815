// Hands motion and stiffening to the tiles, and what they have summed to the body.

#include "engine/bodies/kinds/nodal/nodal_body.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/space/nodal_terms.h"

namespace spoke::space {
namespace {

/// Matrices of the stiffening: of the monomials of w, then of gravity.
constexpr int kForms = kSpins + 3;

/// Weights of these.
struct FormWeights {
  std::array<double, kForms> all{};

  FormWeights() = default;
  /// w, gravity: in B.
  FormWeights(const Angular& w, const Position& gravity) {
    const std::array<double, kSpins> spins = spin_monomials(w);
    std::copy(spins.begin(), spins.end(), all.begin());
    std::copy_n(gravity.data(), 3, all.begin() + kSpins);
  }
};

Position gravity_in(const SolidModel& model, const BodyMotion& motion) {
  return model.place ? Position(model.place->R_HB.inverse() * motion.gravity)
                     : Position(Position::Zero());
}

FormWeights weights_of(const SolidModel& model, const BodyMotion& motion) {
  if (!model.tension) return {};
  assert(model.place && "its frame is clamped");
  return {Angular(model.place->R_HB.inverse() * motion.hub_w), gravity_in(model, motion)};
}

SolidStiffening find_stiffening(const SolidModel& model, const Position& gravity,
                                const NodalWork& work) {
  if (!model.tension) return {};
  const double* forms = total_forms(*model.tiles, work);
  return make_stiffening(forms, forms + model.tiles->forms, gravity);
}

Matrix3 symmetric(const Matrix3& J) { return 0.5 * (J + J.transpose()); }

}  // namespace

void calc_nodal_tile(const SolidModel& model, int p, const BodyState& state,
                     const BodyMotion& motion, const Damping& damping,
                     const BodyWork& work) noexcept {
  assert(model.tiles);
  const FormWeights weights = weights_of(model, motion);
  calc_tile_terms(*model.tiles, p, state, motion.w, damping, weights.all.data(), work.tiles);
}

BodyTerms sum_nodal_terms(const SolidModel& model, const BodyMotion& motion,
                          const BodyWork& work) noexcept {
  const NodalSums sums = sum_tile_terms(*model.tiles, work.tiles);
  BodyTerms terms;
  const Matrix3 J = symmetric(sums.J);
  terms.dissipation = sums.dissipation;
  terms.S = sums.S;
  terms.S_rate = sums.S_rate;
  terms.Theta = J.trace() * Matrix3::Identity() - J;
  const Angular Theta_w = terms.Theta.lazyProduct(motion.w);
  terms.Q = calc_frame_force(motion.w, terms.S, Theta_w, sums.S_rate, sums.G);
  if (model.tension)
    put_stiffening(*model.place, find_stiffening(model, gravity_in(model, motion), work.tiles),
                   motion.gravity, terms);
  return terms;
}

ObservedSolid observe_nodal(const SolidModel& model, const BodyState& state,
                            const Position& gravity, const BodyWork& work) noexcept {
  const FormWeights none;
  for (int p = 0; p < model.tiles->count(); ++p)
    calc_tile_terms(*model.tiles, p, state, Angular::Zero(), {}, none.all.data(), work.observed);
  ObservedSolid observed;
  observed.sums = sum_tile_terms(*model.tiles, work.observed);
  observed.sums.J = symmetric(observed.sums.J);
  observed.stiffening = find_stiffening(model, gravity, work.observed);
  return observed;
}

double calc_nodal_strain_energy(const NodalSolid& solid, const double* q) noexcept {
  double sum = 0.0;
  for (int j = 0; j < solid.K.outerSize(); ++j) {
    double force = 0.0;
    for (NodalSolid::Sparse::InnerIterator e(solid.K, j); e; ++e) force += e.value() * q[e.row()];
    sum += force * q[j];
  }
  return 0.5 * sum;
}

}  // namespace spoke::space
