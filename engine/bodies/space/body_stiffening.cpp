// Sums over the elements in their own axes, both bending planes side by side.

#include "engine/bodies/space/body_stiffening.h"

#include <cassert>

#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/plane_coordinates.h"
#include "engine/bodies/space/tension_weights.h"
#include "models/support/gauss_rule.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// What the sums over the elements are for. Energies need the forms q^T K q alone.
enum class Wanted { energies, forces };

/// Sums of q^T K q and q^T K q' of one tension matrix, in two parts that are added at the end.
struct TensionSums {
  Double2 value{}, rate{};
};

/// Adds factor K q of one tension matrix K to f, and its forms to the sums.
template <Wanted kWanted>
void add_tension(const ElementStiffening& matrices, int k, double factor, const PlaneCoordinates& q,
                 const PlaneCoordinates& v, PlaneCoordinates& f, TensionSums& sums) {
  const PlaneCoordinates product =
      multiply_planes(matrices.bending[static_cast<std::size_t>(k)], q);
  const double turn = q.torsion[1] - q.torsion[0];
  const double trapeze = matrices.torsion[static_cast<std::size_t>(k)] * turn;
  sums.value += sum_products(product, q) + Double2{trapeze * turn, 0.0};
  if constexpr (kWanted == Wanted::energies) return;
  f.rise += factor * product.rise;
  for (int node = 0; node < 2; ++node) f.slope[node] += factor * product.slope[node];
  f.torsion[0] -= factor * trapeze;
  f.torsion[1] += factor * trapeze;
  sums.rate += sum_products(product, v) + Double2{trapeze * (v.torsion[1] - v.torsion[0]), 0.0};
}

struct PairSums {
  double value = 0.0, rate = 0.0;
};

/// Adds factor K q of a propeller matrix K to f; returns its forms.
PairSums add_propeller(const std::array<double, 3>& K, double factor, const PlaneCoordinates& q,
                       const PlaneCoordinates& v, PlaneCoordinates& f) {
  const double inner = K[0] * q.torsion[0] + K[1] * q.torsion[1];
  const double outer = K[1] * q.torsion[0] + K[2] * q.torsion[1];
  f.torsion[0] += factor * inner;
  f.torsion[1] += factor * outer;
  return {inner * q.torsion[0] + outer * q.torsion[1], inner * v.torsion[0] + outer * v.torsion[1]};
}

/// Adds the sum over ab of f_ab e_a e_b^T to F, for ab = 22, 23 and 32, 33; `f`: 22, 23, 33.
template <bool kIsStraight>
void add_tensor(const BeamElement& element, const Position& f, Matrix3& F) {
  if constexpr (kIsStraight) {
    F(1, 1) += f[0];
    F(1, 2) += f[1];
    F(2, 1) += f[1];
    F(2, 2) += f[2];
    return;
  }
  const Position e2 = element.axes.col(1), e3 = element.axes.col(2);
  F += e2 * (f[0] * e2 + f[1] * e3).transpose() + e3 * (f[1] * e2 + f[2] * e3).transpose();
}

/// Adds the propeller terms of an element: (w x e_a).(w x e_b) P_ab, a, b = 2, 3. For sections that
/// are symmetric about both axes, P_23 is zero.
template <bool kIsStraight>
void add_propellers(const BeamElement& element, bool is_symmetric, const Position& w_B,
                    const PlaneCoordinates& q, const PlaneCoordinates& v, PlaneCoordinates& f,
                    StiffeningSums& sums) {
  const Position w = kIsStraight ? w_B : Position(element.axes.transpose().lazyProduct(w_B));
  const auto& K = element.stiffening.propeller;
  const PairSums p22 = add_propeller(K[0], w[0] * w[0] + w[2] * w[2], q, v, f);
  PairSums p23;
  if (!is_symmetric) p23 = add_propeller(K[1], -2.0 * w[1] * w[2], q, v, f);
  const PairSums p33 = add_propeller(K[2], w[0] * w[0] + w[1] * w[1], q, v, f);
  add_tensor<kIsStraight>(element, {p22.value, p23.value, p33.value}, sums.value.propeller);
  add_tensor<kIsStraight>(element, {p22.rate, p23.rate, p33.rate}, sums.rate.propeller);
}

using Coordinates = Eigen::Matrix<double, 2 * kTwist, 1>;

/// Adds the form of a small mass.
[[gnu::always_inline]] inline void add_inertia_form(const PointInertia& point, const double* q,
                                                    StiffeningSums& sums) {
  const Position th = point.rotation.lazyProduct(Eigen::Map<const Coordinates>(q));
  sums.value.inertias += turning_inertia(point.second, th, th);
}

/// Adds small masses, to second order in the rotation th of their section: T gets
/// - 1/2 th^T [tr(P W0) 1 - 1/2 (W0 P + P W0)] th.
[[gnu::always_inline]] inline void add_inertias(const BeamElement& element, const Position& w,
                                                const double* q, const double* v, double* force,
                                                StiffeningSums& sums) {
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

/// Moves the sums of K1 to the forms, weighted by the masses that the elements carry; the sums
/// begin anew.
void take_carried(const CarriedMass& carried, TensionSums& K1, StiffeningSums& sums) {
  const auto take = [&carried](double form, TensionForms& forms) {
    forms.carried += form * carried.moment;
    forms.carried_mass += form * carried.mass;
  };
  take(total(K1.value), sums.value.tension);
  take(total(K1.rate), sums.rate.tension);
  K1 = {};
}

/// Where energies are wanted, motion, v and force do not matter, and the sums of rates are not set.
template <bool kIsStraight, Wanted kWanted>
StiffeningSums add_all(const BodyModel& model, const BodyMotion& motion, const double* q,
                       const double* v, double* force) {
  constexpr bool kHasForces = kWanted == Wanted::forces;
  const FlexibleBody& body = *model.body;
  TensionWeights weights = calc_tension_weights(*model.tension, motion);
  StiffeningSums sums;
  TensionSums tension[ElementStiffening::kWeights];
  const CarriedMass* carried = model.tension->carried.data();
  weights.tension[0] = carried_tension(*carried, weights);
  for (int e = 0; e < body.elements; ++e) {
    if (e == carried->end) {
      take_carried(*carried, tension[0], sums);
      weights.tension[0] = carried_tension(*++carried, weights);
    }
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    const PlaneCoordinates x = in_element_axes<kIsStraight>(element, q);
    PlaneCoordinates rate{};
    if constexpr (kHasForces) rate = in_element_axes<kIsStraight>(element, v);
    PlaneCoordinates f{};
    for (int k = 0; k < ElementStiffening::kWeights; ++k)
      add_tension<kWanted>(element.stiffening, k, weights.tension[static_cast<std::size_t>(k)], x,
                           rate, f, tension[k]);
    add_propellers<kIsStraight>(element, body.is_decoupled, weights.w, x, rate, f, sums);
    if constexpr (kHasForces) {
      subtract_forces<kIsStraight>(element, f, force);
      add_inertias(element, weights.w, q, v, force, sums);
      v += kTwist;
      force += kTwist;
    } else {
      for (const PointInertia& point : element.inertias) add_inertia_form(point, q, sums);
    }
    q += kTwist;
  }
  take_carried(*carried, tension[0], sums);
  sums.value.tension.KL = total(tension[1].value);
  sums.rate.tension.KL = total(tension[1].rate);
  sums.value.tension.Kx = total(tension[2].value);
  sums.rate.tension.Kx = total(tension[2].rate);
  return sums;
}

}  // namespace

Matrix3 turning_inertia(const Matrix3& P, const Position& a, const Position& b) noexcept {
  const Position P_a = P.lazyProduct(a), P_b = P.lazyProduct(b);
  const Matrix3 half = a * P_b.transpose() + b * P_a.transpose();
  Matrix3 inertia = 0.25 * (half + half.transpose()) - a.dot(b) * P;
  inertia.diagonal().array() += a.dot(b) * P.trace() - a.dot(P_b);
  return inertia;
}

StiffeningSums add_stiffening(const BodyModel& model, const BodyMotion& motion, const double* q,
                              const double* v, double* force) noexcept {
  assert(model.tension && !model.tension->carried.empty());
  assert(model.tension->carried.back().end >= model.body->elements);
  return run_large_kernel([&]() noexcept {
    return model.body->is_straight ? add_all<true, Wanted::forces>(model, motion, q, v, force)
                                   : add_all<false, Wanted::forces>(model, motion, q, v, force);
  });
}

StiffeningForms calc_stiffening_forms(const BodyModel& model, const double* q) noexcept {
  assert(model.tension && !model.tension->carried.empty());
  const BodyMotion none{Angular::Zero(), Angular::Zero(), Position::Zero()};
  return run_large_kernel([&]() noexcept {
    return model.body->is_straight
               ? add_all<true, Wanted::energies>(model, none, q, nullptr, nullptr).value
               : add_all<false, Wanted::energies>(model, none, q, nullptr, nullptr).value;
  });
}

double sum_slope_products(const FlexibleBody& body, const double* q, const double* p, int element,
                          double xi) noexcept {
  assert(element >= 0 && element < body.elements && xi >= -1e-9 && xi <= 1.0 + 1e-9);
  Double2 sum{};
  const int whole = xi < 1.0 ? element : element + 1;
  for (int e = 0; e < whole; ++e, q += kTwist, p += kTwist) {
    const BeamElement& passed = body.beam[static_cast<std::size_t>(e)];
    const PlaneCoordinates x = in_axes_of(passed, body.is_straight, q);
    const PlaneCoordinates y = in_axes_of(passed, body.is_straight, p);
    sum += sum_products(multiply_planes(passed.stiffening.bending[0], x), y);
  }
  if (whole > element) return total(sum);
  const BeamElement& last = body.beam[static_cast<std::size_t>(element)];
  const PlaneCoordinates x = in_axes_of(last, body.is_straight, q);
  const PlaneCoordinates y = in_axes_of(last, body.is_straight, p);
  for (int k = 0; k < GaussRule<6>::kPoints; ++k) {
    const Eigen::Vector4d h = hermite_slope(xi * GaussRule<6>::places[k], last.length);
    const Double2 slope_x = h[2] * x.rise + h[1] * x.slope[0] + h[3] * x.slope[1];
    const Double2 slope_y = h[2] * y.rise + h[1] * y.slope[0] + h[3] * y.slope[1];
    sum += (GaussRule<6>::weights[k] * xi * last.length) * slope_x * slope_y;
  }
  return total(sum);
}

namespace {

/// Returns Lambda in B: (e.c) 1 - 1/2 (e c^T + c e^T), tr(F) 1 - F of the propeller terms, and the
/// share of small masses.
Matrix3 calc_inertia(const TensionPlace& place, const StiffeningForms& forms) {
  const Position e = Position::UnitX();
  const Position c = forms.tension.carried + forms.tension.KL * place.origin + forms.tension.Kx * e;
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

Position calc_tension_moment(const TensionPlace& place, const StiffeningForms& forms) noexcept {
  const double form = forms.tension.carried_mass + forms.tension.KL;
  return 0.5 * form * place.R_HB.axes.col(0);
}

Matrix3 calc_hub_inertia(const TensionPlace& place, const StiffeningForms& forms) noexcept {
  return run_large_kernel([&]() noexcept { return turn(place.R_HB, calc_inertia(place, forms)); });
}

HubStiffening calc_hub_stiffening(const TensionPlace& place, const Position& gravity,
                                  const StiffeningSums& sums) noexcept {
  return run_large_kernel([&]() noexcept {
    HubStiffening stiffening;
    stiffening.inertia = turn(place.R_HB, calc_inertia(place, sums.value));
    stiffening.rate = turn(place.R_HB, 2.0 * calc_inertia(place, sums.rate));
    stiffening.moment = cross(gravity, calc_tension_moment(place, sums.value));
    return stiffening;
  });
}

}  // namespace spoke::space
