#include "engine/body_terms.h"

#include "engine/kinematics.h"
#include "engine/lanes.h"

namespace spoke {
namespace {

using ConstVector = Eigen::Map<const Eigen::VectorXd>;

/// Pointers to the two parts of a flex vector.
struct Parts {
  const double* u;
  const double* v;
};

Parts parts(const double* flex, const FlexLayout& layout) {
  return {flex + layout.u(), flex + layout.v()};
}

/// Row i (and i + 1) of a banded product.
template <class Lane, int Half>
[[gnu::always_inline]] inline Lane row(const SymmetricBand<Half>& A, int i, const double* x) {
  Lane sum = load<Lane>(A.diagonal(-Half) + i) * load<Lane>(x + i - Half);
  for (int k = 1 - Half; k <= Half; ++k)
    sum += load<Lane>(A.diagonal(k) + i) * load<Lane>(x + i + k);
  return sum;
}

/// What the axial, or the bending, part of the deformation adds to sums over the body; m stands for
/// d0 + Mff qf.
struct PartSums {
  LaneSum S, S_rate;             // S qf, S qf'
  LaneSum inertia;               // m . qf
  LaneSum inertia_rate;          // m . qf'
  LaneSum d;                     // d0 . qf, axial only
  LaneSum centrifugal_inertia;   // qf^T KG qf, bending only
  LaneSum centrifugal_rate;      // qf^T KG qf'
};

/// Row i of H x.
double coupling_row(const AxialBendingCoupling& H, int i, const double* x) {
  using Row = Eigen::Map<const Eigen::Array<double, AxialBendingCoupling::kWidth, 1>>;
  return (Row(H.rows.data() + AxialBendingCoupling::kWidth * i) * Row(x + 2 * i + H.offset)).sum();
}

/// Entries 2 k and 2 k + 1 of H^T x.
[[gnu::always_inline]] inline Pair coupling_pair(const AxialBendingCoupling& H, int k,
                                                 const double* x) {
  const double* h = H.pairs.data() + 2 * AxialBendingCoupling::kHeight * k;
  return load<Pair>(h) * x[k - 2] + load<Pair>(h + 2) * x[k - 1] + load<Pair>(h + 4) * x[k] +
         load<Pair>(h + 6) * x[k + 1];
}

/// Axial rows of c_theta = c0 + G^T qf and Q_f = w^2 (d0 + Mff qf) + 2 w G qf' - K q_elastic, with
/// G = [0 H; -H^T 0].
PartSums calc_axial_rows(const FlexibleBody& body, double w, const Parts& q, const Parts& qd,
                         const double* q_elastic, double* c_theta, double* Q) {
  PartSums sums;
  for_each_lane(body.axial(), [&]<class Lane>(int i) {
    const Lane d = load<Lane>(body.d_axial.data() + i);
    const Lane S = load<Lane>(body.S_axial.data() + i);
    const Lane u = load<Lane>(q.u + i);
    const Lane ud = load<Lane>(qd.u + i);
    const Lane m = d + row<Lane>(body.M_axial, i, q.u);
    store(Lane(w * w * m - row<Lane>(body.K_axial, i, q_elastic)), Q + i);
    sums.S += S * u;
    sums.S_rate += S * ud;
    sums.inertia += m * u;
    sums.inertia_rate += m * ud;
    sums.d += d * u;
  });
  for (int i = 0; i < body.axial(); ++i) {
    c_theta[i] = -coupling_row(body.H, i, q.v);
    Q[i] += 2.0 * w * coupling_row(body.H, i, qd.v);
  }
  return sums;
}

/// Bending rows of the same; with geometric stiffening Q_f -= w0^2 KG qf.
template <bool kIsStiffened>
PartSums calc_bending_rows(const ChainBody& member, const BodyMotion& motion, const Parts& q,
                           const Parts& qd, const double* q_elastic, double* c_theta, double* Q) {
  const FlexibleBody& body = *member.body;
  const double w = motion.speed;
  const double ww_hub = motion.hub_speed * motion.hub_speed;
  PartSums sums;
  for (int i = 0; i < body.bending(); i += 2) {
    const Pair S = load<Pair>(body.S_bending.data() + i);
    const Pair v = load<Pair>(q.v + i);
    const Pair vd = load<Pair>(qd.v + i);
    const Pair m = row<Pair>(body.M_bending, i, q.v);
    Pair force = w * w * m - 2.0 * w * coupling_pair(body.H, i / 2, qd.u) -
                 row<Pair>(body.K_bending, i, q_elastic);
    if constexpr (kIsStiffened) {
      const Pair k = row<Pair>(*member.centrifugal_stiffness, i, q.v);
      force -= ww_hub * k;
      sums.centrifugal_inertia += k * v;
      sums.centrifugal_rate += k * vd;
    }
    store(force, Q + i);
    store(Pair(load<Pair>(body.c_bending.data() + i) + coupling_pair(body.H, i / 2, q.u)),
          c_theta + i);
    sums.S += S * v;
    sums.S_rate += S * vd;
    sums.inertia += m * v;
    sums.inertia_rate += m * vd;
  }
  return sums;
}

/// Damping D = mass_factor Mff + stiffness_factor K: the force at v_elastic, the power at qf'.
template <int Half>
double add_damping(const Damping& damping, const SymmetricBand<Half>& M,
                   const SymmetricBand<Half>& K, const double* v_elastic, const double* qd,
                   double* Q) {
  const double a = damping.mass_factor;
  const double b = damping.stiffness_factor;
  double power = 0.0;
  for (int i = 0; i < M.size(); ++i) {
    Q[i] -= a * M.row(i, v_elastic) + b * K.row(i, v_elastic);
    power += qd[i] * (a * M.row(i, qd) + b * K.row(i, qd));
  }
  return power;
}

/// Force of a load in the body frame [N].
Position resolve_force(const NodeLoad& load, double rotation, const BodyPose& pose,
                       const Rotation& R_0) {
  switch (load.frame) {
    case LoadFrame::inertial:
      return (R_0 * pose.X_HB.R).inverse() * load.force;
    case LoadFrame::hub:
      return pose.X_HB.R.inverse() * load.force;
    case LoadFrame::section:
      break;
  }
  return Rotation::from_angle(rotation) * load.force;
}

}  // namespace

void calc_body_terms(const BodyMotion& motion, const Damping& damping, BodyData& data) noexcept {
  const FlexibleBody& body = *data.model->body;
  const FlexLayout& layout = data.layout;
  const double w = motion.speed;
  const Parts q = parts(data.coordinates.q, layout);
  const Parts qd = parts(data.coordinates.v, layout);
  const Parts q_elastic = parts(data.q_elastic, layout);
  double* Q_u = data.Q_f + layout.u();
  double* Q_v = data.Q_f + layout.v();

  const PartSums axial =
      calc_axial_rows(body, w, q, qd, q_elastic.u, data.c_theta + layout.u(), Q_u);
  const auto calc_bending =
      data.model->centrifugal_stiffness ? calc_bending_rows<true> : calc_bending_rows<false>;
  const PartSums bending = calc_bending(*data.model, motion, q, qd, q_elastic.v,
                                        data.c_theta + layout.v(), Q_v);

  BodyTerms& terms = data.terms;
  terms.S = body.S0 + Position{axial.S.total(), bending.S.total()};
  terms.rotary_inertia =
      body.I0 + axial.d.total() + axial.inertia.total() + bending.inertia.total();
  terms.centrifugal_inertia = bending.centrifugal_inertia.total();
  terms.centrifugal_rate = bending.centrifugal_rate.total();
  // Q_t = w^2 (S0 + S qf) - 2 w B S qf',  Q_w = -2 w (d0 + Mff qf) . qf'
  const Position S_rate{axial.S_rate.total(), bending.S_rate.total()};
  const Position Q_t = w * w * terms.S - 2.0 * w * quarter_turn(S_rate);
  terms.Q = Twist(Q_t.x(), Q_t.y(),
                  -2.0 * w * (axial.inertia_rate.total() + bending.inertia_rate.total()));
  terms.load_power = 0.0;
  terms.dissipation = 0.0;
  if (damping.mass_factor == 0.0 && damping.stiffness_factor == 0.0) return;
  const Parts v_elastic = parts(data.v_elastic, layout);
  terms.dissipation =
      add_damping(damping, body.M_axial, body.K_axial, v_elastic.u, qd.u, Q_u) +
      add_damping(damping, body.M_bending, body.K_bending, v_elastic.v, qd.v, Q_v);
}

void add_loads(double t, const BodyPose& pose, const Twist& twist, const Rotation& R_0,
               BodyData& data) noexcept {
  const FlexLayout& layout = data.layout;
  const auto at = [&](const double* flex, int index) {
    return index < 0 ? 0.0 : flex[flex_index(index, layout)];
  };
  for (const NodeLoad& load : data.model->loads) {
    const double* q = data.coordinates.q;
    const double* qd = data.coordinates.v;
    const double factor = load.factor->value(t);
    const double rotation = at(q, load.coordinate[kRotation]);
    const Position force = factor * resolve_force(load, rotation, pose, R_0);
    const double moment = factor * load.moment;
    const Position s = load.p + Position{at(q, load.coordinate[0]), at(q, load.coordinate[1])};
    const Position sd{at(qd, load.coordinate[0]), at(qd, load.coordinate[1])};
    const double torque = s.x() * force.y() - s.y() * force.x() + moment;
    const Twist wrench(force.x(), force.y(), moment);
    data.terms.Q += Twist(force.x(), force.y(), torque);
    for (int c = 0; c < kTwist; ++c)
      if (load.coordinate[c] >= 0) data.Q_f[flex_index(load.coordinate[c], layout)] += wrench[c];
    data.terms.load_power += force.dot(Position(twist.head<kPosition>()) + sd) +
                             torque * twist[kRotation] +
                             moment * at(qd, load.coordinate[kRotation]);
  }
}

BodyInertia calc_inertia(const BodyData& data) {
  const FlexibleBody& body = *data.model->body;
  const Parts q = parts(data.coordinates.q, data.layout);
  const Parts qd = parts(data.coordinates.v, data.layout);
  BodyInertia inertia;
  inertia.rotary_inertia = body.I0;
  inertia.S = body.S0 + Position{body.S_axial.dot(ConstVector(q.u, body.axial())),
                                 body.S_bending.dot(ConstVector(q.v, body.bending()))};
  const double* h = body.H.rows.data();
  for (int i = 0; i < body.axial(); ++i, h += AxialBendingCoupling::kWidth) {
    inertia.rotary_inertia += q.u[i] * (2.0 * body.d_axial[i] + body.M_axial.row(i, q.u));
    // M_wf qf' = c0 qf' + u^T H v' - v^T H^T u'
    for (int k = 0; k < AxialBendingCoupling::kWidth; ++k) {
      const int column = 2 * i + body.H.offset + k;
      inertia.rotation_deformation += h[k] * (q.u[i] * qd.v[column] - q.v[column] * qd.u[i]);
    }
  }
  inertia.rotation_deformation += body.c_bending.dot(ConstVector(qd.v, body.bending()));
  const SymmetricBand<3>* KG = data.model->centrifugal_stiffness.get();
  for (int i = 0; i < body.bending(); ++i) {
    inertia.rotary_inertia += q.v[i] * body.M_bending.row(i, q.v);
    if (KG) inertia.centrifugal_inertia += q.v[i] * KG->row(i, q.v);
  }
  return inertia;
}

double calc_kinetic_energy(const BodyData& data, const BodyInertia& inertia, const Twist& twist,
                           double hub_speed) {
  const FlexibleBody& body = *data.model->body;
  const Parts qd = parts(data.coordinates.v, data.layout);
  const Position v = twist.head<kPosition>();
  const double w = twist[kRotation];
  const Position S_rate{body.S_axial.dot(ConstVector(qd.u, body.axial())),
                        body.S_bending.dot(ConstVector(qd.v, body.bending()))};
  double deformation = 0.0;
  for (int i = 0; i < body.axial(); ++i) deformation += qd.u[i] * body.M_axial.row(i, qd.u);
  for (int i = 0; i < body.bending(); ++i) deformation += qd.v[i] * body.M_bending.row(i, qd.v);
  return 0.5 * body.mass * v.squaredNorm() + 0.5 * inertia.rotary_inertia * w * w +
         0.5 * deformation + w * v.dot(quarter_turn(inertia.S)) + v.dot(S_rate) +
         w * inertia.rotation_deformation -
         0.5 * hub_speed * hub_speed * inertia.centrifugal_inertia;
}

double calc_strain_energy(const BodyData& data) {
  const FlexibleBody& body = *data.model->body;
  const Parts q = parts(data.coordinates.q, data.layout);
  double energy = 0.0;
  for (int i = 0; i < body.axial(); ++i) energy += q.u[i] * body.K_axial.row(i, q.u);
  for (int i = 0; i < body.bending(); ++i) energy += q.v[i] * body.K_bending.row(i, q.v);
  return 0.5 * energy;
}

}  // namespace spoke
