// Multiplies by the matrices of the stiffening.

#include "engine/bodies/space/solid_tension.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/space/reduced_products.h"
#include "engine/bodies/space/solid_block.h"

namespace spoke::space {
namespace {

double dot(int n, const double* a, const double* b) {
  double sum = 0.0;
  for (int k = 0; k < n; ++k) sum += a[k] * b[k];
  return sum;
}

/// Forms q^T K q and q^T K q'.
struct SolidForm {
  double value = 0.0, rate = 0.0;
};

/// Adds -factor K q to the force; returns the forms.
SolidForm add_spring(const SolidTensionColumns& columns, const std::vector<double>& K,
                     double factor, const double* q, const double* v, double* product,
                     double* force) {
  multiply_symmetric(K.data(), columns.stride, q, product);
  if (factor != 0.0)
    for (int k = 0; k < columns.modes; ++k) force[k] -= factor * product[k];
  return {dot_padded(columns.stride, q, product), dot_padded(columns.stride, v, product)};
}

/// Returns the symmetric matrix whose form in w is the sum of the monomials times these values.
Matrix3 make_form_matrix(const std::array<double, kSpins>& values) {
  Matrix3 m;
  m << values[0], 0.5 * values[5], 0.5 * values[4], 0.5 * values[5], values[1], 0.5 * values[3],
      0.5 * values[4], 0.5 * values[3], values[2];
  return m;
}

/// Pads a vector with zeros; returns it.
double* pad(const SolidTensionColumns& columns, const double* x, double* padded) {
  copy_padded(x, columns.modes, columns.stride, padded);
  return padded;
}

}  // namespace

SolidTensionColumns make_tension_columns(const SolidConstants& constants,
                                         const SolidTension* tension) {
  assert(constants.is_stiffened);
  SolidTensionColumns columns;
  columns.modes = constants.coordinates;
  columns.nodal = constants.nodal();
  if (columns.nodal) return columns;
  const ReducedSolid* solid = constants.reduced();
  columns.stride = padded_size(columns.modes);
  for (std::size_t k = 0; k < kSpins; ++k)
    columns.spin[k] = pad_square(tension ? tension->spin[k] : solid->own[k]);
  for (std::size_t c = 0; tension && c < 3; ++c)
    columns.gravity[c] = pad_square(tension->gravity[c]);
  for (const auto& matrices : solid->places) {
    auto& forces = columns.forces.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) forces[c] = pad_square(matrices[c]);
  }
  return columns;
}

SolidStiffening make_stiffening(const double* values, const double* rates,
                                const Position& gravity) noexcept {
  std::array<double, kSpins> spin{}, spin_rate{};
  for (std::size_t k = 0; k < kSpins; ++k) {
    spin[k] = values[k];
    spin_rate[k] = 2.0 * rates[k];
  }
  SolidStiffening sums;
  sums.Lambda = make_form_matrix(spin);
  sums.Lambda_rate = make_form_matrix(spin_rate);
  if (gravity.isZero(0.0)) return sums;
  for (int c = 0; c < 3; ++c) {
    sums.gamma.value[c] = 0.5 * values[kSpins + c];
    sums.gamma.rate[c] = rates[kSpins + c];
  }
  return sums;
}

SolidStiffening add_solid_stiffening(const SolidTensionColumns& columns, const Angular& w,
                                     const Position& gravity, const double* q, const double* v,
                                     double* product, double* force) noexcept {
  const std::array<double, kSpins> monomials = spin_monomials(w);
  std::array<double, kSpins> values{}, rates{};
  for (std::size_t k = 0; k < kSpins; ++k) {
    const SolidForm form = add_spring(columns, columns.spin[k], monomials[k], q, v, product, force);
    values[k] = form.value;
    rates[k] = 2.0 * form.rate;
  }
  SolidStiffening sums;
  sums.Lambda = make_form_matrix(values);
  sums.Lambda_rate = make_form_matrix(rates);
  if (columns.gravity[0].empty() || gravity.isZero(0.0)) return sums;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto axis = static_cast<Eigen::Index>(c);
    const SolidForm form =
        add_spring(columns, columns.gravity[c], gravity[axis], q, v, product, force);
    sums.gamma.value[axis] = 0.5 * form.value;
    sums.gamma.rate[axis] = form.rate;
  }
  return sums;
}

PlaceDrawn calc_place_drawn(const SolidTensionColumns& columns, std::size_t place, const double* q,
                            const double* v, const double* a, double* padded) noexcept {
  assert(place < columns.forces.size());
  const int n = columns.modes;
  const double* x = pad(columns, q, padded);
  const double* rate = pad(columns, v, padded + columns.stride);
  double *Kq = padded + 2 * columns.stride, *Kv = padded + 3 * columns.stride;
  PlaceDrawn drawn;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto axis = static_cast<Eigen::Index>(c);
    const double* K = columns.forces[place][c].data();
    multiply_symmetric(K, columns.stride, x, Kq);
    drawn.place[axis] = -0.5 * dot_padded(columns.stride, x, Kq);
    drawn.rate[axis] = -dot_padded(columns.stride, rate, Kq);
    if (!a) continue;
    multiply_symmetric(K, columns.stride, rate, Kv);
    drawn.acceleration[axis] = -dot_padded(columns.stride, rate, Kv) - dot(n, a, Kq);
  }
  return drawn;
}

Angular add_place_tension(const SolidTensionColumns& columns, std::size_t place, const Position& N,
                          const double* q, const double* v, const BodyWork& work,
                          double& power) noexcept {
  assert(place < columns.forces.size());
  const double* x = pad(columns, q, work.scratch);
  double* product = work.scratch + columns.stride;
  Position drawn;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto axis = static_cast<Eigen::Index>(c);
    multiply_symmetric(columns.forces[place][c].data(), columns.stride, x, product);
    drawn[axis] = -0.5 * dot_padded(columns.stride, x, product);
    power -= N[axis] * dot(columns.modes, v, product);
    for (int k = 0; k < columns.modes; ++k) work.rows[kSolidRow * k + 3] -= N[axis] * product[k];
  }
  return cross(drawn, N);
}

}  // namespace spoke::space
