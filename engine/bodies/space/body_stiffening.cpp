// Sums over the elements in their own axes, both bending planes side by side.

#include "engine/bodies/space/body_stiffening.h"

#include <cassert>

#include "engine/bodies/space/element_products.h"
#include "engine/bodies/space/plane_coordinates.h"
#include "engine/bodies/space/tension_weights.h"
#include "engine/bodies/space/turned_sections.h"
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

Turn<Double2> turn_of(const PlaneCoordinates& q) {
  return {Double2{q.torsion[0], q.torsion[1]}, Double2{-q.slope[0][1], -q.slope[1][1]},
          Double2{q.slope[0][0], q.slope[1][0]}};
}

/// Returns the products of a matrix over both nodes, by its entries 11, 12, 22.
Turn<Double2> multiply_turn(const std::array<double, 3>& K, const Turn<Double2>& th) {
  const Double2 inner{K[0], K[1]}, outer{K[1], K[2]};
  const auto product = [&](const Double2& x) { return x[0] * inner + x[1] * outer; };
  return {product(th.x), product(th.y), product(th.z)};
}

/// Forms of rotations and of their rates.
struct TurnSums {
  TurnForms<Double2> value, rate;
};

/// Adds what the turned sections of an element take off. For sections that are symmetric about both
/// axes, P_23 is zero.
void add_turned_sections(const ElementStiffening& matrices, bool is_symmetric, const SpinWeights& W,
                         const PlaneCoordinates& q, const PlaneCoordinates& v, PlaneCoordinates& f,
                         TurnSums& sums) {
  const auto dot = [](const Double2& a, const Double2& b) { return a * b; };
  const Turn<Double2> th = turn_of(q), rate = turn_of(v);
  Turn<Double2> force{};
  const Turn<Double2> K22 = multiply_turn(matrices.turning[0], th);
  add_forces_22(W, K22, force);
  add_forms_22(K22, th, dot, sums.value.of_22);
  add_forms_22(K22, rate, dot, sums.rate.of_22);
  const Turn<Double2> K33 = multiply_turn(matrices.turning[2], th);
  add_forces_33(W, K33, force);
  add_forms_33(K33, th, dot, sums.value.of_33);
  add_forms_33(K33, rate, dot, sums.rate.of_33);
  if (!is_symmetric) {
    const Turn<Double2> K23 = multiply_turn(matrices.turning[1], th);
    add_forces_23(W, K23, force);
    add_forms_23(K23, th, dot, sums.value.of_23);
    add_forms_23(K23, rate, dot, sums.rate.of_23);
  }
  for (int node = 0; node < 2; ++node) {
    f.torsion[node] += force.x[node];
    f.slope[node] += Double2{force.z[node], -force.y[node]};
  }
}

/// Moves Lambda of turned sections to the sums; those of an element begin anew.
void take_turned(const Matrix3& axes, TurnSums& turned, StiffeningSums& sums) {
  const auto in_B = [&axes](const TurnForms<Double2>& forms) {
    const Matrix3 half = axes.lazyProduct(forms.inertia([](const Double2& s) { return total(s); }));
    return Matrix3(half.lazyProduct(axes.transpose()));
  };
  sums.value.inertias += in_B(turned.value);
  sums.rate.inertias += in_B(turned.rate);
  turned = {};
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
  TurnSums turned;
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
    const Angular w =
        kIsStraight ? weights.w : Angular(element.axes.transpose().lazyProduct(weights.w));
    add_turned_sections(element.stiffening, body.is_decoupled, SpinWeights(w), x, rate, f, turned);
    if constexpr (!kIsStraight) take_turned(element.axes, turned, sums);
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
  if constexpr (kIsStraight) take_turned(Matrix3::Identity(), turned, sums);
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

/// Returns Lambda in B: (e.c) 1 - 1/2 (e c^T + c e^T), and the share of what turns.
Matrix3 calc_inertia(const TensionPlace& place, const StiffeningForms& forms) {
  const Position e = Position::UnitX();
  const Position c = forms.tension.carried + forms.tension.KL * place.origin + forms.tension.Kx * e;
  Matrix3 inertia = forms.inertias - 0.5 * (e * c.transpose() + c * e.transpose());
  inertia.diagonal().array() += c.x();
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
