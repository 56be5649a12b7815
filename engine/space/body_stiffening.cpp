// Sums over the elements in their own axes, both bending planes side by side.

#include "engine/space/body_stiffening.h"

#include "engine/space/element_products.h"
#include "models/space/gauss_rule.h"

namespace spoke::space {
namespace {

/// What each matrix counts at a speed of the hub.
struct Weights {
  std::array<double, ElementStiffening::kWeights> tension;
  Position w;  ///< the hub's angular velocity, in B [rad/s]
};

/// W0 = |w|^2 1 - w w^T, x component of W0 c.
double along_x(const Position& w, const Position& c) {
  return w.squaredNorm() * c.x() - w.x() * w.dot(c);
}

Weights calc_weights(const TensionPlace& place, const BodyMotion& motion) {
  const Position w = place.R_HB.inverse() * motion.hub_w;
  const double gravity = (place.R_HB.inverse() * motion.gravity).x();
  return {{along_x(w, place.outboard_moment) + gravity * place.outboard_mass,
           along_x(w, place.origin) + gravity, along_x(w, Position::UnitX())},
          w};
}

/// Coordinates of an element's two nodes along its axes. Both planes lie side by side: (v, w) and
/// (tz, -ty), the signs of the plane.
struct PlaneCoordinates {
  Double2 bending[4];
  double torsion[2];
};

PlaneCoordinates in_element_axes(const BeamElement& element, bool is_straight, const double* q) {
  PlaneCoordinates planes;
  for (int node = 0; node < 2; ++node, q += kTwist) {
    if (is_straight) {
      planes.bending[2 * node] = Double2{q[1], q[2]};
      planes.bending[2 * node + 1] = Double2{q[5], -q[4]};
      planes.torsion[node] = q[3];
      continue;
    }
    const Matrix3& e = element.axes;
    const auto along = [&](int axis, const double* x) {
      return e(0, axis) * x[0] + e(1, axis) * x[1] + e(2, axis) * x[2];
    };
    planes.bending[2 * node] = Double2{along(1, q), along(2, q)};
    planes.bending[2 * node + 1] = Double2{along(2, q + kRotation), -along(1, q + kRotation)};
    planes.torsion[node] = along(0, q + kRotation);
  }
  return planes;
}

/// force -= forces along the element's axes.
void subtract_forces(const BeamElement& element, bool is_straight, const PlaneCoordinates& f,
                     double* force) {
  for (int node = 0; node < 2; ++node, force += kTwist) {
    const Double2 shear = f.bending[2 * node], moment = f.bending[2 * node + 1];
    if (is_straight) {
      force[1] -= shear[0];
      force[2] -= shear[1];
      force[3] -= f.torsion[node];
      force[4] += moment[1];
      force[5] -= moment[0];
      continue;
    }
    const Matrix3& e = element.axes;
    for (int i = 0; i < 3; ++i) {
      force[i] -= e(i, 1) * shear[0] + e(i, 2) * shear[1];
      force[3 + i] -= e(i, 0) * f.torsion[node] - e(i, 1) * moment[1] + e(i, 2) * moment[0];
    }
  }
}

struct PairSums {
  double value = 0.0, rate = 0.0;
};

/// Adds factor times one tension matrix times q to f; returns q^T K q and q^T K q'.
PairSums add_tension(const ElementStiffening& matrices, int k, double factor,
                     const PlaneCoordinates& q, const PlaneCoordinates& v, PlaneCoordinates& f) {
  const double* K = matrices.bending[static_cast<std::size_t>(k)].data();
  Double2 value{}, rate{};
  for (int i = 0; i < 4; ++i, K += 4) {
    const Double2 product =
        K[0] * q.bending[0] + K[1] * q.bending[1] + K[2] * q.bending[2] + K[3] * q.bending[3];
    f.bending[i] += factor * product;
    value += product * q.bending[i];
    rate += product * v.bending[i];
  }
  const double trapeze = matrices.torsion[static_cast<std::size_t>(k)];
  const double product = trapeze * (q.torsion[1] - q.torsion[0]);
  f.torsion[0] -= factor * product;
  f.torsion[1] += factor * product;
  return {total(value) + product * (q.torsion[1] - q.torsion[0]),
          total(rate) + product * (v.torsion[1] - v.torsion[0])};
}

/// The same of a propeller matrix.
PairSums add_propeller(const std::array<double, 3>& K, double factor, const PlaneCoordinates& q,
                       const PlaneCoordinates& v, PlaneCoordinates& f) {
  const double inner = K[0] * q.torsion[0] + K[1] * q.torsion[1];
  const double outer = K[1] * q.torsion[0] + K[2] * q.torsion[1];
  f.torsion[0] += factor * inner;
  f.torsion[1] += factor * outer;
  return {inner * q.torsion[0] + outer * q.torsion[1], inner * v.torsion[0] + outer * v.torsion[1]};
}

/// F += sum over ab of f_ab e_a e_b^T, for ab = 22, 23 and 32, 33; `f`: 22, 23, 33.
void add_tensor(const BeamElement& element, bool is_straight, const Position& f, Matrix3& F) {
  if (is_straight) {
    F(1, 1) += f[0];
    F(1, 2) += f[1];
    F(2, 1) += f[1];
    F(2, 2) += f[2];
    return;
  }
  const Position e2 = element.axes.col(1), e3 = element.axes.col(2);
  F += e2 * (f[0] * e2 + f[1] * e3).transpose() + e3 * (f[1] * e2 + f[2] * e3).transpose();
}

/// The propeller terms of an element: (w x e_a).(w x e_b) P_ab, a, b = 2, 3.
void add_propellers(const BeamElement& element, bool is_straight, const Position& w_B,
                    const PlaneCoordinates& q, const PlaneCoordinates& v, PlaneCoordinates& f,
                    StiffeningSums& sums) {
  const Position w = is_straight ? w_B : Position(element.axes.transpose().lazyProduct(w_B));
  const auto& K = element.stiffening.propeller;
  const PairSums p22 = add_propeller(K[0], w[0] * w[0] + w[2] * w[2], q, v, f);
  const PairSums p23 = add_propeller(K[1], -2.0 * w[1] * w[2], q, v, f);
  const PairSums p33 = add_propeller(K[2], w[0] * w[0] + w[1] * w[1], q, v, f);
  add_tensor(element, is_straight, {p22.value, p23.value, p33.value}, sums.value.propeller);
  add_tensor(element, is_straight, {p22.rate, p23.rate, p33.rate}, sums.rate.propeller);
}

/// Lambda of a second moment P that turns by a, or its bilinear form in a and b:
/// a.b (tr(P) 1 - P) - (a.P b) 1 + 1/4 [a (P b)^T + b (P a)^T + transposes].
Matrix3 turning_inertia(const Matrix3& P, const Position& a, const Position& b) {
  const Position P_a = P.lazyProduct(a), P_b = P.lazyProduct(b);
  const Matrix3 half = a * P_b.transpose() + b * P_a.transpose();
  Matrix3 inertia = 0.25 * (half + half.transpose()) - a.dot(b) * P;
  inertia.diagonal().array() += a.dot(b) * P.trace() - a.dot(P_b);
  return inertia;
}

/// Small masses, to second order in the rotation th of their section: T gets
/// - 1/2 th^T [tr(P W0) 1 - 1/2 (W0 P + P W0)] th.
void add_inertias(const BeamElement& element, const Position& w, const double* q, const double* v,
                  double* force, StiffeningSums& sums) {
  using Coordinates = Eigen::Matrix<double, 2 * kTwist, 1>;
  for (const PointInertia& point : element.inertias) {
    const Matrix3& P = point.second;
    const Position th = point.rotation.lazyProduct(Eigen::Map<const Coordinates>(q));
    const Position rate = point.rotation.lazyProduct(Eigen::Map<const Coordinates>(v));
    const Matrix3 W0 = w.squaredNorm() * Matrix3::Identity() - w * w.transpose();
    const Matrix3 W0_P = W0.lazyProduct(P);
    const Position moment = W0_P.trace() * th - 0.5 * (W0_P + W0_P.transpose()).lazyProduct(th);
    Eigen::Map<Coordinates>(force, 2 * kTwist) -= point.rotation.transpose().lazyProduct(moment);
    sums.value.inertias += turning_inertia(P, th, th);
    sums.rate.inertias += turning_inertia(P, th, rate);
  }
}

}  // namespace

StiffeningSums add_stiffening(const BodyModel& model, const BodyMotion& motion, const double* q,
                              const double* v, double* force) noexcept {
  const FlexibleBody& body = *model.body;
  const Weights weights = calc_weights(*model.tension, motion);
  StiffeningSums sums;
  for (const BeamElement& element : body.beam) {
    const PlaneCoordinates x = in_element_axes(element, body.is_straight, q);
    const PlaneCoordinates rate = in_element_axes(element, body.is_straight, v);
    PlaneCoordinates f{};
    for (int k = 0; k < ElementStiffening::kWeights; ++k) {
      const double weight = weights.tension[static_cast<std::size_t>(k)];
      const PairSums pair = add_tension(element.stiffening, k, weight, x, rate, f);
      sums.value.tension[k] += pair.value;
      sums.rate.tension[k] += pair.rate;
    }
    add_propellers(element, body.is_straight, weights.w, x, rate, f, sums);
    subtract_forces(element, body.is_straight, f, force);
    add_inertias(element, weights.w, q, v, force, sums);
    q += kTwist;
    v += kTwist;
    force += kTwist;
  }
  return sums;
}

double sum_slope_products(const FlexibleBody& body, const double* q, const double* p, int element,
                          double xi) noexcept {
  Double2 sum{};
  const int whole = xi < 1.0 ? element : element + 1;
  for (int e = 0; e < whole; ++e, q += kTwist, p += kTwist) {
    const BeamElement& passed = body.beam[static_cast<std::size_t>(e)];
    const PlaneCoordinates x = in_element_axes(passed, body.is_straight, q);
    const PlaneCoordinates y = in_element_axes(passed, body.is_straight, p);
    const Matrix4& K1 = passed.stiffening.bending[0];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) sum += x.bending[i] * (K1(i, j) * y.bending[j]);
  }
  if (whole > element) return total(sum);
  const BeamElement& last = body.beam[static_cast<std::size_t>(element)];
  const PlaneCoordinates x = in_element_axes(last, body.is_straight, q);
  const PlaneCoordinates y = in_element_axes(last, body.is_straight, p);
  for (int k = 0; k < GaussRule::kPoints; ++k) {
    const Eigen::Vector4d h = hermite_slope(xi * GaussRule::places[k], last.length);
    Double2 slope_x{}, slope_y{};
    for (int i = 0; i < 4; ++i) {
      slope_x += h[i] * x.bending[i];
      slope_y += h[i] * y.bending[i];
    }
    sum += (GaussRule::weights[k] * xi * last.length) * slope_x * slope_y;
  }
  return total(sum);
}

namespace {

/// (e.c) 1 - 1/2 (e c^T + c e^T), and of the propeller terms tr(F) 1 - F, in B.
Matrix3 calc_inertia(const TensionPlace& place, const StiffeningForms& forms) {
  const Position e = Position::UnitX();
  const Position c = forms.tension[0] * place.outboard_moment + forms.tension[1] * place.origin +
                     forms.tension[2] * e;
  Matrix3 inertia =
      -0.5 * (e * c.transpose() + c * e.transpose()) - forms.propeller + forms.inertias;
  inertia.diagonal().array() += c.x() + forms.propeller.trace();
  return inertia;
}

Matrix3 turn(const Rotation& R, const Matrix3& tensor) {
  const Matrix3 half = R.axes.lazyProduct(tensor);
  return half.lazyProduct(R.axes.transpose());
}

}  // namespace

Position calc_tension_moment(const TensionPlace& place, const StiffeningSums& sums) noexcept {
  const double form = place.outboard_mass * sums.value.tension[0] + sums.value.tension[1];
  return 0.5 * form * place.R_HB.axes.col(0);
}

HubStiffening calc_hub_stiffening(const TensionPlace& place, const Position& gravity,
                                  const StiffeningSums& sums) noexcept {
  HubStiffening stiffening;
  stiffening.inertia = turn(place.R_HB, calc_inertia(place, sums.value));
  stiffening.rate = turn(place.R_HB, 2.0 * calc_inertia(place, sums.rate));
  stiffening.moment = cross(gravity, calc_tension_moment(place, sums));
  return stiffening;
}

}  // namespace spoke::space
