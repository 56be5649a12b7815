// Calculates elastic and tension forces by element, then momenta, rows and sums by node.

#include "engine/bodies/kinds/beam/straight_terms.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kinds/beam/straight_forces.h"
#include "engine/bodies/space/lanes.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Takes a flex vector, six values a node from `first` on, apart by component.
void take_apart(const double* nodal, int first, int count, const LaneRows& rows) {
  const auto component = [&](int n, int c) { return nodal[kTwist * n + c]; };
  constexpr int kOrder[] = {kAxialPlace, kPlace1, kPlace2, kTorsion, kSlope2, kSlope1};
  int n = 0;
  for (; n + 4 <= count; n += 4)
    for (int c = 0; c < kTwist; ++c) {
      const Double4 values{component(n, c), component(n + 1, c), component(n + 2, c),
                           component(n + 3, c)};
      store(c == 4 ? -values : values, rows.at(kOrder[c], first + n));
    }
  for (; n < count; ++n)
    for (int c = 0; c < kTwist; ++c)
      *rows.at(kOrder[c], first + n) = c == 4 ? -component(n, c) : component(n, c);
}

void set_lanes(const FlexibleBody& body, const double* flex, LaneRows::Kind kind,
               const BodyScratch& scratch) {
  const LaneRows rows(body, scratch, kind);
  if (body.reference_frame == ReferenceFrame::clamped) {
    take_apart(flex, 1, body.elements, rows);
    return;
  }
  expand(body, flex, scratch.nodal[0]);
  take_apart(scratch.nodal[0], 0, body.node_count(), rows);
}

/// A flex vector at four nodes and their neighbours.
struct NodeMotion {
  Around u, torsion, place1, slope1, place2, slope2;

  [[gnu::always_inline]] NodeMotion(const LaneRows& rows, int k)
      : u(Around::from(rows.at(kAxialPlace, k))),
        torsion(Around::from(rows.at(kTorsion, k))),
        place1(Around::from(rows.at(kPlace1, k))),
        slope1(Around::from(rows.at(kSlope1, k))),
        place2(Around::from(rows.at(kPlace2, k))),
        slope2(Around::from(rows.at(kSlope2, k))) {}
};

/// Three components, at four nodes.
struct Triple {
  Double4 x, y, z;
};

[[gnu::always_inline]] inline Triple multiply(const NodeLanes::Momentum& m,
                                              const NodeMotion& motion) {
  return {m.axial * motion.u, m.place * motion.place1 + m.slope * motion.slope1,
          m.place * motion.place2 + m.slope * motion.slope2};
}

/// Momenta of the slots of four nodes, or their rates. For the axes that turn with the node, d_x =
/// -d_slope1, d_z = d_torsion, g_x = -g_slope2, g_y = -g_torsion.
struct LaneMomenta {
  Triple stretched, r, t;
  Double4 d_slope1, d_torsion, g_slope2, g_torsion;

  [[gnu::always_inline]] LaneMomenta(const NodeLanes& m, const NodeMotion& motion)
      : stretched(multiply(m.stretched, motion)),
        r(multiply(m.r, motion)),
        t(multiply(m.t, motion)),
        d_slope1(m.d * motion.slope1),
        d_torsion(m.d * motion.torsion),
        g_slope2(m.g * motion.slope2),
        g_torsion(m.g * motion.torsion) {}
};

/// The inertia force of a slot at zero X and q'': b = -(A mu + 2 w x mu') with A = w w^T - |w|^2 1.
struct LaneForce {
  double A[3][3], w[3];

  explicit LaneForce(const Angular& speed) : w{speed[0], speed[1], speed[2]} {
    const double ww = speed.squaredNorm();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) A[i][j] = (i == j ? ww : 0.0) - w[i] * w[j];
  }
  [[gnu::always_inline]] Double4 still(int i, const Double4& x, const Double4& y,
                                       const Double4& z) const {
    return A[i][0] * x + A[i][1] * y + A[i][2] * z;
  }
  [[gnu::always_inline]] Double4 x(const Triple& mu, const Triple& rate) const {
    return still(0, mu.x, mu.y, mu.z) + 2.0 * (w[2] * rate.y - w[1] * rate.z);
  }
  [[gnu::always_inline]] Double4 y(const Triple& mu, const Triple& rate) const {
    return still(1, mu.x, mu.y, mu.z) + 2.0 * (w[0] * rate.z - w[2] * rate.x);
  }
  [[gnu::always_inline]] Double4 z(const Triple& mu, const Triple& rate) const {
    return still(2, mu.x, mu.y, mu.z) + 2.0 * (w[1] * rate.x - w[0] * rate.y);
  }
};

/// Stores four values each of four nodes: row i of BodyWork::rows of up to four.
[[gnu::always_inline]] inline void store_row(int i, const Double4& x, const Double4& y,
                                             const Double4& z, const Double4& force, int nodes,
                                             double* rows) {
  const Double4 a = __builtin_shufflevector(x, y, 0, 4, 2, 6);
  const Double4 b = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Double4 c = __builtin_shufflevector(z, force, 0, 4, 2, 6);
  const Double4 d = __builtin_shufflevector(z, force, 1, 5, 3, 7);
  rows += 4 * i;
  store(__builtin_shufflevector(a, c, 0, 1, 4, 5), rows);
  if (nodes > 1) store(__builtin_shufflevector(b, d, 0, 1, 4, 5), rows + kNodeRows);
  if (nodes > 2) store(__builtin_shufflevector(a, c, 2, 3, 6, 7), rows + 2 * kNodeRows);
  if (nodes > 3) store(__builtin_shufflevector(b, d, 2, 3, 6, 7), rows + 3 * kNodeRows);
}

/// Elastic and tension forces of four nodes.
struct NodeForces {
  LaneRows inner, outer;

  [[gnu::always_inline]] Double4 at(int component, int k) const {
    return load4(inner.at(component, k)) + load4(outer.at(component, k));
  }
};

/// Sets the rows of C_w^T and Q_f: for each coordinate Xi^T (e_a x mu) for a = x, y, z, then Xi^T b
/// + force.
[[gnu::always_inline]] inline void set_rows(const LaneMomenta& mu, const LaneMomenta& rate,
                                            const Double4& d_y, const Double4& g_z,
                                            const LaneForce& b, const NodeForces& force, int k,
                                            int nodes, double* rows) {
  const Double4 zero{};
  const Triple d{-mu.d_slope1, d_y, mu.d_torsion}, d_rate{-rate.d_slope1, zero, rate.d_torsion};
  const Triple g{-mu.g_slope2, -mu.g_torsion, g_z}, g_rate{-rate.g_slope2, -rate.g_torsion, zero};
  store_row(0, zero, mu.stretched.z, -mu.stretched.y,
            b.x(mu.stretched, rate.stretched) + force.at(kAxialPlace, k), nodes, rows);
  store_row(1, -mu.r.z, zero, mu.r.x, b.y(mu.r, rate.r) + force.at(kPlace1, k), nodes, rows);
  store_row(2, mu.r.y, -mu.r.x, zero, b.z(mu.r, rate.r) + force.at(kPlace2, k), nodes, rows);
  store_row(3, d_y + g_z, -d.x, -g.x, b.z(d, d_rate) - b.y(g, g_rate) + force.at(kTorsion, k),
            nodes, rows);
  store_row(4, -mu.t.y, mu.t.x + g_z, -g.y,
            b.x(g, g_rate) - b.z(mu.t, rate.t) - force.at(kSlope2, k), nodes, rows);
  store_row(5, -mu.t.z, -d.z, mu.t.x + d_y,
            b.y(mu.t, rate.t) - b.x(d, d_rate) + force.at(kSlope1, k), nodes, rows);
}

/// The inertia Theta = tr(J) 1 - J. A product with the matrix itself would wait for it to be
/// stored.
struct Inertia {
  double xx, yy, zz, xy, xz, yz;

  Matrix3 matrix() const {
    Matrix3 Theta;
    Theta << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return Theta;
  }
  Angular operator*(const Angular& w) const {
    return {xx * w[0] + xy * w[1] + xz * w[2], xy * w[0] + yy * w[1] + yz * w[2],
            xz * w[0] + yz * w[1] + zz * w[2]};
  }
};

/// Sums over the nodes; J_.. are those of P, with J = J0 + (P + P^T)/2.
struct NodeSums {
  Double4 S[3]{}, S_rate[3]{};
  Double4 J_xx{}, J_yy{}, J_zz{}, J_xy{}, J_xz{}, J_yz{};
  Double4 G[3][3]{};

  [[gnu::always_inline]] static void add_moment(const NodeLanes& m, const NodeMotion& q,
                                                Double4 (&sum)[3]) {
    sum[0] += lanes(m.axial) * q.u.own;
    sum[1] += lanes(m.place) * q.place1.own + lanes(m.slope) * q.slope1.own;
    sum[2] += lanes(m.place) * q.place2.own + lanes(m.slope) * q.slope2.own;
  }
  /// Adds P = sum of (displacement of a slot) (its momentum, undeformed and now)^T.
  [[gnu::always_inline]] void add_inertia(const NodeLanes& m, const NodeMotion& q,
                                          const LaneMomenta& mu) {
    const Double4 u = q.u.own, th = q.torsion.own, v = q.place1.own, s1 = q.slope1.own,
                  w = q.place2.own, s2 = q.slope2.own;
    const Double4 d_y = 2.0 * lanes(m.d_undeformed), g_z = 2.0 * lanes(m.g_undeformed);
    const Double4 r_x = mu.r.x + lanes(m.r.undeformed), t_x = mu.t.x + lanes(m.t.undeformed);
    J_xx +=
        u * (mu.stretched.x + lanes(m.stretched.undeformed)) + s1 * mu.d_slope1 + s2 * mu.g_slope2;
    J_yy += v * mu.r.y + s1 * mu.t.y + th * mu.g_torsion;
    J_zz += w * mu.r.z + s2 * mu.t.z + th * mu.d_torsion;
    J_xy +=
        u * mu.stretched.y - s1 * d_y + s2 * mu.g_torsion + v * r_x + s1 * t_x + th * mu.g_slope2;
    J_xz +=
        u * mu.stretched.z - s1 * mu.d_torsion - s2 * g_z + w * r_x + s2 * t_x - th * mu.d_slope1;
    J_yz += v * mu.r.z + s1 * mu.t.z - th * g_z + w * mu.r.y + s2 * mu.t.y + th * d_y;
  }
  /// Adds G = sum of (momentum of a slot) (rate of its displacement)^T.
  [[gnu::always_inline]] void add_rates(const NodeLanes& m, const NodeMotion& v,
                                        const LaneMomenta& mu) {
    const Double4 d_y = lanes(m.d_undeformed), g_z = lanes(m.g_undeformed);
    const Double4 th = v.torsion.own, s1 = v.slope1.own, s2 = v.slope2.own;
    const Double4 r[3] = {mu.r.x, mu.r.y, mu.r.z}, t[3] = {mu.t.x, mu.t.y, mu.t.z};
    const Double4 stretched[3] = {mu.stretched.x, mu.stretched.y, mu.stretched.z};
    const Double4 d[3] = {-mu.d_slope1, d_y, mu.d_torsion},
                  g[3] = {-mu.g_slope2, -mu.g_torsion, g_z};
    for (int i = 0; i < 3; ++i) {
      G[i][0] += stretched[i] * v.u.own - d[i] * s1 - g[i] * s2;
      G[i][1] += r[i] * v.place1.own + t[i] * s1 - g[i] * th;
      G[i][2] += r[i] * v.place2.own + t[i] * s2 + d[i] * th;
    }
  }
  Inertia inertia_sum(const Matrix3& J0) const {
    const double xx = J0(0, 0) + total(J_xx), yy = J0(1, 1) + total(J_yy),
                 zz = J0(2, 2) + total(J_zz);
    return {yy + zz,
            xx + zz,
            xx + yy,
            -(J0(1, 0) + 0.5 * total(J_xy)),
            -(J0(2, 0) + 0.5 * total(J_xz)),
            -(J0(2, 1) + 0.5 * total(J_yz))};
  }
  Matrix3 rate_sum() const {
    Matrix3 sum;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum(i, j) = total(G[i][j]);
    return sum;
  }
};

/// Sets the rows of all nodes that have coordinates, and returns the sums over them.
NodeSums sum_nodes(const FlexibleBody& body, const Angular& w, const BodyScratch& scratch,
                   double* rows) {
  const LaneRows q(body, scratch, LaneRows::coordinates), v(body, scratch, LaneRows::velocities);
  const NodeForces force{LaneRows(body, scratch, LaneRows::inner_forces),
                         LaneRows(body, scratch, LaneRows::outer_forces)};
  const LaneForce b(w);
  NodeSums sums;
  int k = body.first_node();
  for (const NodeLanes& m : body.directions->nodes) {
    const NodeMotion x(q, k), x_rate(v, k);
    LaneMomenta mu(m, x);
    const LaneMomenta rate(m, x_rate);
    mu.stretched.x += lanes(m.stretched.undeformed);
    mu.r.x += lanes(m.r.undeformed);
    mu.t.x += lanes(m.t.undeformed);
    NodeSums::add_moment(m, x, sums.S);
    NodeSums::add_moment(m, x_rate, sums.S_rate);
    sums.add_inertia(m, x, mu);
    sums.add_rates(m, x_rate, mu);
    set_rows(mu, rate, lanes(m.d_undeformed), lanes(m.g_undeformed), b, force, k,
             std::min(4, body.node_count() - k), rows + kNodeRows * k);
    k += 4;
  }
  return sums;
}

Position take(const Double4 (&sum)[3]) { return {total(sum[0]), total(sum[1]), total(sum[2])}; }

BodyTerms calc_terms(const BodyModel& model, const BodyState& state, const BodyMotion& motion,
                     const BodyWork& work) {
  const FlexibleBody& body = *model.body;
  const ScratchRoom room(body, work);
  const BodyScratch& scratch = *room;
  std::fill_n(scratch.lanes, count_lanes(body), 0.0);
  set_lanes(body, state.q, LaneRows::coordinates, scratch);
  set_lanes(body, state.v, LaneRows::velocities, scratch);
  const bool is_at_state = state.q_elastic == state.q;
  if (!is_at_state) set_lanes(body, state.q_elastic, LaneRows::elastic_coordinates, scratch);
  BodyTerms terms;
  calc_straight_forces(model, motion,
                       is_at_state ? LaneRows::coordinates : LaneRows::elastic_coordinates, scratch,
                       terms);
  if (body.first_node() > 0) std::fill_n(work.rows, kNodeRows, 0.0);
  const NodeSums sums = sum_nodes(body, motion.w, scratch, work.rows);
  const Inertia Theta = sums.inertia_sum(body.J0);
  const Position S = body.S0 + take(sums.S);
  terms.S = S;
  terms.S_rate = take(sums.S_rate);
  terms.Theta = Theta.matrix();
  terms.Q = calc_frame_force(motion.w, S, Theta * motion.w, terms.S_rate, sums.rate_sum());
  return terms;
}

}  // namespace

BodyTerms calc_straight_terms(const BodyModel& model, const BodyState& state,
                              const BodyMotion& motion, const BodyWork& work) noexcept {
  assert(model.body && model.body->directions);
  assert(state.q && state.v && state.q_elastic);
  return run_large_kernel([&]() noexcept { return calc_terms(model, state, motion, work); });
}

}  // namespace spoke::space
