// Calculates mass terms, right-hand side, loads and energies of a body, with axial and bending
// parts apart.

#include "engine/bodies/kernels/plane/body_terms.h"

#include <cassert>
#include <type_traits>

#include "engine/bodies/plane/band_products.h"
#include "engine/bodies/plane/nonlinear_strain.h"
#include "models/support/wide_kernels.h"

namespace spoke::plane {
namespace {

/// Returns two rows of H x; `rows` begins the first, and `x` is at its first column.
[[gnu::always_inline]] inline Double2 coupling_rows(const double* rows, const double* x) {
  const auto row = [](const double* h, const double* at) -> Double2 {
    return load_aligned(h) * load(at) + load_aligned(h + 2) * load(at + 2) +
           load_aligned(h + 4) * load(at + 4);
  };
  const Double2 first = row(rows, x);
  const Double2 second = row(rows + AxialBendingCoupling::kWidth, x + 2);
  return Double2{total(first), total(second)};
}

/// Returns a pair of entries of H^T x; `x` is at the second of its axial neighbours. The first
/// neighbour does not exist in a clamped frame, whose pairs belong to one node each.
template <bool kIsClamped>
[[gnu::always_inline]] inline Double2 coupling_pair(const double* h, const double* x) {
  const Double2 sum =
      load_aligned(h + 2) * x[-1] + load_aligned(h + 4) * x[0] + load_aligned(h + 6) * x[1];
  return kIsClamped ? sum : sum + load_aligned(h) * x[-2];
}

/// Shares of the axial, or the bending, part of the deformation in sums over the body; m stands for
/// d0 + Mff qf.
struct PartSums {
  double S = 0.0, S_rate = 0.0;      // S qf, S qf'
  double inertia = 0.0;              // (d0 + m) . qf
  double inertia_rate = 0.0;         // m . qf'
  double centrifugal_inertia = 0.0;  // qf^T KG qf
  double centrifugal_rate = 0.0;     // qf^T KG qf'
};

// The loops below take all pointers out first: a store of a pair may alias anything to the
// compiler.

/// Calculates the axial rows of c_theta = c0 + G^T qf and Q_f = w^2 (d0 + Mff qf) + 2 w G qf' - K
/// q_elastic, with G = [0 H; -H^T 0].
PartSums calc_axial_rows(const FlexibleBody& body, double w, const FlexParts& q,
                         const FlexParts& qd, const double* q_elastic, double* c_theta, double* Q) {
  Double2 S_sum{}, S_rate{};
  Double2 inertia{}, inertia_rate{};
  const double *u = q.u, *ud = qd.u;
  const double *d0 = body.d_axial.data(), *S = body.S_axial.data();
  const double *M = body.M_axial.pairs(), *K = body.K_axial.pairs();
  const double* h = body.H.rows.data();
  const double *v = q.v + body.H.offset, *vd = qd.v + body.H.offset;
  const int n = body.axial();
  constexpr int kStride = 2 * SymmetricBand<1>::kWidth;
  for (int i = 0; i < n; i += 2, M += kStride, K += kStride) {
    const Double2 m = load_aligned(d0 + i) + band_rows<1>(M, i, u);
    store_aligned(
        w * w * m + 2.0 * w * coupling_rows(h, vd + 2 * i) - band_rows<1>(K, i, q_elastic), Q + i);
    store_aligned(-coupling_rows(h, v + 2 * i), c_theta + i);
    h += 2 * AxialBendingCoupling::kWidth;
    S_sum += load_aligned(S + i) * load_aligned(u + i);
    S_rate += load_aligned(S + i) * load_aligned(ud + i);
    inertia += (load_aligned(d0 + i) + m) * load_aligned(u + i);
    inertia_rate += m * load_aligned(ud + i);
  }
  return {total(S_sum), total(S_rate), total(inertia), total(inertia_rate), 0.0, 0.0};
}

/// Calculates the bending rows of c_theta and Q_f; with geometric stiffening Q_f -= w0^2 KG qf, and
/// likewise with the turning of small masses, of which the speed is that of the body.
template <bool kIsClamped, bool kIsStiffened>
PartSums calc_bending_rows(const TreeBody<Plane>& member, const BodyMotion& motion,
                           const FlexParts& q, const FlexParts& qd, const double* q_elastic,
                           double* c_theta, double* Q) {
  const FlexibleBody& body = *member.body;
  const double w = motion.speed;
  const double w0 = has_turning(body) ? w : motion.hub_speed;
  const double ww_hub = w0 * w0;
  Double2 S_sum{}, S_rate{};
  Double2 inertia{}, inertia_rate{};
  Double2 centrifugal_inertia{}, centrifugal_rate{};
  const double *v = q.v, *vd = qd.v, *u = q.u, *ud = qd.u;
  const double *S = body.S_bending.data(), *c0 = body.c_bending.data();
  const double *M = body.M_bending.pairs(), *K = body.K_bending.pairs();
  const double* KG = kIsStiffened ? centrifugal_of(member)->pairs() : nullptr;
  const double* h = body.H.pairs.data();
  const int n = body.bending();
  constexpr int kStride = 2 * SymmetricBand<3>::kWidth;
  for (int i = 0; i < n; i += 2, M += kStride, K += kStride, ++u, ++ud) {
    const Double2 m = band_rows<3>(M, i, v);
    Double2 force =
        w * w * m - 2.0 * w * coupling_pair<kIsClamped>(h, ud) - band_rows<3>(K, i, q_elastic);
    if constexpr (kIsStiffened) {
      const Double2 k = band_rows<3>(KG, i, v);
      force -= ww_hub * k;
      centrifugal_inertia += k * load_aligned(v + i);
      centrifugal_rate += k * load_aligned(vd + i);
      KG += kStride;
    }
    store_aligned(force, Q + i);
    store_aligned(load_aligned(c0 + i) + coupling_pair<kIsClamped>(h, u), c_theta + i);
    S_sum += load_aligned(S + i) * load_aligned(v + i);
    S_rate += load_aligned(S + i) * load_aligned(vd + i);
    inertia += m * load_aligned(v + i);
    inertia_rate += m * load_aligned(vd + i);
    h += 2 * AxialBendingCoupling::kHeight;
  }
  return {total(S_sum),
          total(S_rate),
          total(inertia),
          total(inertia_rate),
          total(centrifugal_inertia),
          total(centrifugal_rate)};
}

PartSums calc_bending(const TreeBody<Plane>& member, const BodyMotion& motion, const FlexParts& q,
                      const FlexParts& qd, const double* q_elastic, double* c_theta, double* Q) {
  const bool is_stiffened = centrifugal_of(member) != nullptr;
  const auto calc = [&](auto is_clamped) {
    constexpr bool kIsClamped = decltype(is_clamped)::value;
    return is_stiffened
               ? calc_bending_rows<kIsClamped, true>(member, motion, q, qd, q_elastic, c_theta, Q)
               : calc_bending_rows<kIsClamped, false>(member, motion, q, qd, q_elastic, c_theta, Q);
  };
  return member.body->reference_frame == ReferenceFrame::clamped ? calc(std::true_type{})
                                                                 : calc(std::false_type{});
}

/// Adds the damping D = a Mff + b K: the force at v_elastic, the power at qf'.
template <int Half>
double add_damping(double a, double b, const SymmetricBand<Half>& M, const SymmetricBand<Half>& K,
                   const double* v_elastic, const double* qd, double* Q) {
  double power = 0.0;
  for (int i = 0; i < M.size(); ++i) {
    Q[i] -= a * M.row(i, v_elastic) + b * K.row(i, v_elastic);
    power += qd[i] * (a * M.row(i, qd) + b * K.row(i, qd));
  }
  return power;
}

void calc_terms(const BodyMotion& motion, const Damping& damping, BodyData<Plane>& data) {
  assert(data.layout.axial == data.model->body->axial());
  assert(data.layout.bending == data.model->body->bending());
  assert(data.q_elastic && data.v_elastic);
  const FlexibleBody& body = *data.model->body;
  const FlexLayout& layout = data.layout;
  const double w = motion.speed;
  const FlexParts q = flex_parts(data.coordinates.q, layout);
  const FlexParts qd = flex_parts(data.coordinates.v, layout);
  const FlexParts q_elastic = flex_parts(data.q_elastic, layout);
  double* Q_u = data.Q_f + layout.u();
  double* Q_v = data.Q_f + layout.v();

  const PartSums bending =
      calc_bending(*data.model, motion, q, qd, q_elastic.v, data.c_theta + layout.v(), Q_v);
  const PartSums axial =
      calc_axial_rows(body, w, q, qd, q_elastic.u, data.c_theta + layout.u(), Q_u);

  Terms& terms = data.terms;
  terms.S = body.S0 + Position{axial.S, bending.S};
  terms.rotary_inertia = body.I0 + axial.inertia + bending.inertia;
  terms.stiffening = {bending.centrifugal_inertia, bending.centrifugal_rate, 0.0};
  // Q_t = w^2 (S0 + S qf) - 2 w B S qf',  Q_w = -2 w (d0 + Mff qf) . qf'
  const Position S_rate{axial.S_rate, bending.S_rate};
  const Position Q_t = w * w * terms.S - 2.0 * w * quarter_turn(S_rate);
  terms.Q = Twist(Q_t.x(), Q_t.y(), -2.0 * w * (axial.inertia_rate + bending.inertia_rate));
  if (has_turning(body)) {
    terms.rotary_inertia -= terms.stiffening.inertia;
    terms.Q[kRotation] += calc_stiffening_moment(terms.stiffening, w);
    terms.stiffening = {};
  }
  terms.load_power = 0.0;
  terms.dissipation = 0.0;
  const double a = damping.mass_factor, b = damping.stiffness_factor;
  if (a == 0.0 && b == 0.0 && body.damping.is_zero()) return;
  const FlexParts v_elastic = flex_parts(data.v_elastic, layout);
  terms.dissipation =
      add_damping(a, b + body.damping.axial, body.M_axial, body.K_axial, v_elastic.u, qd.u, Q_u) +
      add_damping(a, b + body.damping.bending, body.M_bending, body.K_bending, v_elastic.v, qd.v,
                  Q_v);
}

}  // namespace

void calc_body_terms(const BodyMotion& motion, const Damping& damping,
                     BodyData<Plane>& data) noexcept {
  run_kernel([&]() noexcept { calc_terms(motion, damping, data); });
  // Bands of K are zero then.
  if (data.model->body->is_nonlinear())
    data.terms.dissipation +=
        subtract_strain_forces(*data.model->body, data.layout, damping.stiffness_factor,
                               data.q_elastic, data.v_elastic, data.Q_f);
}

}  // namespace spoke::plane
