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
  TurnedInertia turned;
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
    const TurnedMasses masses{element.stiffening.turning, element.inertias};
    if constexpr (kHasForces) {
      subtract_forces<kIsStraight>(element, f, force);
      subtract_turned(masses, weights.w, q, v, force, turned);
      v += kTwist;
      force += kTwist;
    } else {
      add_turned(masses, q, turned.value);
    }
    q += kTwist;
  }
  take_carried(*carried, tension[0], sums);
  sums.value.tension.KL = total(tension[1].value);
  sums.rate.tension.KL = total(tension[1].rate);
  sums.value.tension.Kx = total(tension[2].value);
  sums.rate.tension.Kx = total(tension[2].rate);
  sums.value.inertias = turned.value;
  sums.rate.inertias = turned.rate;
  return sums;
}

}  // namespace

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
