// Sums over the rows of a body's band matrices, two rows at a time.

#include "engine/bodies/kernels/plane/body_energies.h"

#include <cassert>

#include "engine/bodies/kernels/plane/body_terms.h"
#include "engine/bodies/plane/band_products.h"
#include "engine/bodies/plane/nonlinear_strain.h"

namespace spoke::plane {
namespace {

/// Returns a . b, for n even. Pairs at even and at odd places are summed apart: two additions at
/// once.
double dot(const double* a, const double* b, int n) {
  assert(n % 2 == 0);
  Double2 even{}, odd{};
  int i = 0;
  for (; i + 4 <= n; i += 4) {
    even += load_aligned(a + i) * load_aligned(b + i);
    odd += load_aligned(a + i + 2) * load_aligned(b + i + 2);
  }
  Double2 sum = even + odd;
  if (i < n) sum += load_aligned(a + i) * load_aligned(b + i);
  return total(sum);
}

/// Sums over the coordinates of a body, axial before bending.
struct EnergySums {
  double rotary_inertia;              // M_ww [kg m^2]
  double rotation_deformation = 0.0;  // M_wf qf' [kg m^2/s]
  double deformation = 0.0;           // qf'^T Mff qf' [J]
  double elastic = 0.0;               // qf^T K qf [J]
  double centrifugal_inertia = 0.0;   // qf^T KG qf [kg m^2]
};

/// Adds row i of u^T H v' - v^T H^T u': `h` begins the row, v and vd are at its first column.
[[gnu::always_inline]] inline void add_coupling(const double* h, double u, double ud,
                                                const double* v, const double* vd, double& sum) {
  for (int k = 0; k < AxialBendingCoupling::kWidth; k += 2)
    add_in_order(load_aligned(h + k) * (u * load(vd + k) - load(v + k) * ud), sum);
}

void add_axial(const FlexibleBody& body, const FlexParts& q, const FlexParts& qd,
               EnergySums& sums) {
  EnergySums sum = sums;
  const double *u = q.u, *ud = qd.u;
  const double *v = q.v + body.H.offset, *vd = qd.v + body.H.offset;
  const double *d0 = body.d_axial.data(), *h = body.H.rows.data();
  const double *M = body.M_axial.pairs(), *K = body.K_axial.pairs();
  const int n = body.axial();
  constexpr int kStride = 2 * SymmetricBand<1>::kWidth;
  constexpr int kWidth = AxialBendingCoupling::kWidth;
  for (int i = 0; i < n; i += 2, M += kStride, K += kStride, h += 2 * kWidth, v += 4, vd += 4) {
    const Double2 u_i = load_aligned(u + i), ud_i = load_aligned(ud + i);
    add_in_order(u_i * (2.0 * load_aligned(d0 + i) + band_rows<1>(M, i, u)), sum.rotary_inertia);
    add_in_order(ud_i * band_rows<1>(M, i, ud), sum.deformation);
    add_in_order(u_i * band_rows<1>(K, i, u), sum.elastic);
    add_coupling(h, u[i], ud[i], v, vd, sum.rotation_deformation);
    add_coupling(h + kWidth, u[i + 1], ud[i + 1], v + 2, vd + 2, sum.rotation_deformation);
  }
  sums = sum;
}

template <bool kIsStiffened>
void add_bending(const TreeBody<Plane>& member, const double* v, const double* vd,
                 EnergySums& sums) {
  EnergySums sum = sums;
  const FlexibleBody& body = *member.body;
  const double *M = body.M_bending.pairs(), *K = body.K_bending.pairs();
  const double* KG = kIsStiffened ? centrifugal_of(member)->pairs() : nullptr;
  const int n = body.bending();
  constexpr int kStride = 2 * SymmetricBand<3>::kWidth;
  for (int i = 0; i < n; i += 2, M += kStride, K += kStride) {
    const Double2 v_i = load_aligned(v + i);
    add_in_order(v_i * band_rows<3>(M, i, v), sum.rotary_inertia);
    add_in_order(load_aligned(vd + i) * band_rows<3>(M, i, vd), sum.deformation);
    add_in_order(v_i * band_rows<3>(K, i, v), sum.elastic);
    if constexpr (kIsStiffened) {
      add_in_order(v_i * band_rows<3>(KG, i, v), sum.centrifugal_inertia);
      KG += kStride;
    }
  }
  sums = sum;
}

}  // namespace

BodyEnergies calc_body_energies(const BodyData<Plane>& data, const Twist& twist,
                                double hub_speed) noexcept {
  assert(data.layout.axial == data.model->body->axial());
  assert(data.layout.bending == data.model->body->bending());
  const FlexibleBody& body = *data.model->body;
  const FlexParts q = flex_parts(data.coordinates.q, data.layout);
  const FlexParts qd = flex_parts(data.coordinates.v, data.layout);
  EnergySums sums{body.I0};
  add_axial(body, q, qd, sums);
  if (centrifugal_of(*data.model))
    add_bending<true>(*data.model, q.v, qd.v, sums);
  else
    add_bending<false>(*data.model, q.v, qd.v, sums);
  sums.rotation_deformation += dot(body.c_bending.data(), qd.v, body.bending());
  const auto moment = [&](const FlexParts& x) {
    return Position{dot(body.S_axial.data(), x.u, body.padded_axial()),
                    dot(body.S_bending.data(), x.v, body.bending())};
  };
  const Position S = body.S0 + moment(q), S_rate = moment(qd);
  const Position v = twist.head<kPosition>();
  const double w = twist[kRotation], w0 = has_turning(body) ? w : hub_speed;
  const double kinetic = 0.5 * body.mass * v.squaredNorm() + 0.5 * sums.rotary_inertia * w * w +
                         0.5 * sums.deformation + w * v.dot(quarter_turn(S)) + v.dot(S_rate) +
                         w * sums.rotation_deformation - 0.5 * w0 * w0 * sums.centrifugal_inertia;
  const double strain =
      body.is_nonlinear() ? calc_nonlinear_energy(body, data.layout, data.coordinates.q) : 0.0;
  return {kinetic, 0.5 * sums.elastic + strain, S};
}

double calc_strain_energy(const BodyData<Plane>& data) noexcept {
  return calc_body_energies(data, Twist::Zero(), 0.0).strain;
}

}  // namespace spoke::plane
