// Sums products of half solutions, coordinate by coordinate.

#include "engine/bodies/kinds/solid/condense_solid.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/space/nodal_memory.h"
#include "engine/bodies/space/sparse_solve.h"
#include "models/space/twist_columns.h"
#include "models/support/unroll.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Coordinates that stand side by side.
struct Stretch {
  int first, end;
};
Stretch all_of(const Solid& body) { return {0, body.coordinates()}; }
Stretch stretch_of(const FactorSlice& slice) { return {slice.first, slice.end}; }

/// Sums over coordinates of y_C^T (y_w, y_Q): three rows of translation, three of rotation.
struct HalfProducts {
  Double4 t[3]{}, w[3]{};

  static Matrix3 columns(const Double4 (&rows)[3]) {
    Matrix3 m;
    for (int i = 0; i < 3; ++i) m.row(i) << rows[i][0], rows[i][1], rows[i][2];
    return m;
  }
};

HalfProducts multiply_halves(const Stretch& s, const SolidBlock& block, const double* half) {
  HalfProducts sums;
  const double* y_C = block.y_C.data() + kSolidRow * s.first;
  half += kSolidRow * s.first;
  for (int k = s.first; k < s.end; ++k, half += kSolidRow, y_C += kSolidRow) {
    const Double4 y = load4(half);
    unroll<3>([&](auto component) {
      constexpr int c = component;
      sums.t[c] += y_C[c] * y;
      sums.w[c] += y[c] * y;
    });
  }
  return sums;
}

/// E_h (W_w, z) = y_E^T (y_w, y_Q): six rows of a handle.
struct HandleResponse {
  Double4 rows[kTwist]{};
};

HandleResponse calc_response(const Stretch& s, const double* y_E, const double* half) {
  HandleResponse response;
  y_E += kHandleRow * s.first;
  half += kSolidRow * s.first;
  for (int k = s.first; k < s.end; ++k, half += kSolidRow, y_E += kHandleRow) {
    const Double4 y = load4(half);
    unroll<kTwist>([&](auto component) {
      constexpr int c = component;
      response.rows[c] += y_E[c] * y;
    });
  }
  return response;
}

/// Calculates X_h = J_h - E_h W and b_h + E_h z of one handle.
void calc_map(const SolidBlock& block, std::size_t h, const Angular& w,
              const HandleResponse& response, const BodyWork& work) {
  const HandleMotion& handle = work.handles[h];
  TwistMatrix& X = work.condensed.X[h];
  X.setIdentity();
  X.topRightCorner<3, 3>() = -skew(handle.s);
  Eigen::Matrix<double, kTwist, 4> turned;
  for (int c = 0; c < kTwist; ++c)
    for (int i = 0; i < 4; ++i) turned(c, i) = response.rows[c][i];
  const auto turn = [&handle](auto&& columns) {
    columns.template bottomRows<3>() =
        handle.turn.H.lazyProduct(columns.template bottomRows<3>()).eval();
  };
  turn(turned);
  Eigen::Matrix<double, kTwist, 3> by_translation = block.E_W[h];
  turn(by_translation);
  X.leftCols<3>() -= by_translation;
  X.rightCols<3>() -= turned.leftCols<3>();
  work.port.free[h] = handle.bias(w) + Twist(turned.col(3));
}

/// Calculates P_ab = diag(1, H_a) Z_ab diag(1, H_b^T) + X_a S_R^-1 X_b^T for all handles a < b, and
/// for b with itself.
void calc_compliances(const SolidBlock& block, std::size_t b, const BodyWork& work) {
  const TwistMatrix& X_b = work.condensed.X[b];
  const Matrix3& H_b = work.handles[b].turn.H;
  const TwistMatrix S_X = multiply_transposed(work.condensed.S_inverse.matrix(), X_b);
  for (std::size_t a = 0; a < b; ++a) {
    const int pair = tree::MultiPort<Space>::count_pairs(static_cast<int>(b)) + static_cast<int>(a);
    const TwistMatrix& Z = block.Z_pairs[static_cast<std::size_t>(pair)];
    work.port.pairs[pair] = add_product(turn_columns(turn_rows(work.handles[a].turn.H, Z), H_b),
                                        work.condensed.X[a], S_X);
  }
  const TwistMatrix Z = turn_columns(turn_rows(H_b, block.Z_diagonal[b].matrix()), H_b);
  work.port.diagonal[b] = {add_product(Z, X_b, S_X)};
}

/// Calculates condensed inertia and multi-port from the products; `respond`: returns the response
/// of a handle.
template <class Respond>
void condense_by(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                 const Angular& w, const HalfProducts& products, Respond&& respond,
                 BodyWork& work) {
  // S_R = M_RR - C W and p = Q - C z follow, with M_RR = [m 1, -S~; S~, Theta].
  Condensed& condensed = work.condensed;
  condensed.S_inverse = invert(SymmetricTwistMatrix::from_blocks(
      body.constants->mass * Matrix3::Identity() - block.C_W,
      skew(terms.S) - HalfProducts::columns(products.t).transpose(),
      terms.Theta - HalfProducts::columns(products.w)));
  for (int c = 0; c < 3; ++c) {
    condensed.p[c] = terms.Q[c] - products.t[c][3];
    condensed.p[kRotation + c] = terms.Q[kRotation + c] - products.w[c][3];
  }
  const Twist X_free = condensed.S_inverse * condensed.p;
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    if (block.y_E[h].empty()) {
      // The frame is clamped there, at its origin: X_h = 1.
      condensed.X[h].setIdentity();
      work.port.free[h] = X_free;
    } else {
      calc_map(block, h, w, respond(h), work);
      work.port.free[h] += condensed.X[h].lazyProduct(X_free);
    }
    calc_compliances(block, h, work);
  }
}

void condense_modes(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                    const Angular& w, BodyWork& work) {
  const Stretch all = all_of(body);
  solve_half(block, body.coordinates(), work.rows, work.half);
  condense_by(
      body, block, terms, w, multiply_halves(all, block, work.half),
      [&](std::size_t h) { return calc_response(all, block.y_E[h].data(), work.half); }, work);
}

// The products of a slice, as they lie in memory: six rows of HalfProducts, and those of the
// handles' responses.

constexpr int kProducts = 4 * kTwist;

double* products_of(const Solid& body, std::size_t slice, const BodyWork& work) {
  return work.products + slice * count_products(body);
}

void store_products(const Solid& body, const SolidBlock& block, const Stretch& stretch,
                    std::size_t slice, const BodyWork& work) {
  double* place = products_of(body, slice, work);
  const HalfProducts products = multiply_halves(stretch, block, work.half);
  for (int i = 0; i < 3; ++i) {
    store(products.t[i], place + 4 * i);
    store(products.w[i], place + 4 * (3 + i));
  }
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    place += kProducts;
    HandleResponse response;
    if (!block.y_E[h].empty()) response = calc_response(stretch, block.y_E[h].data(), work.half);
    for (int c = 0; c < kTwist; ++c) store(response.rows[c], place + 4 * c);
  }
}

/// Returns the sum over all slices, and what is between them, in their order.
HalfProducts sum_products(const Solid& body, const SolidBlock& block, const BodyWork& work) {
  HalfProducts sums;
  for (std::size_t p = 0; p <= block.factor->slices.size(); ++p) {
    const double* place = products_of(body, p, work);
    for (int i = 0; i < 3; ++i) {
      sums.t[i] += load4(place + 4 * i);
      sums.w[i] += load4(place + 4 * (3 + i));
    }
  }
  return sums;
}
HandleResponse sum_responses(const Solid& body, const SolidBlock& block, std::size_t h,
                             const BodyWork& work) {
  HandleResponse sums;
  for (std::size_t p = 0; p <= block.factor->slices.size(); ++p)
    for (int c = 0; c < kTwist; ++c)
      sums.rows[c] +=
          load4(products_of(body, p, work) + kProducts * (1 + h) + 4 * static_cast<std::size_t>(c));
  return sums;
}

/// Sets the right-hand sides of the pass back: y_Q - y_C X + sum y_E f.
void combine_halves(const Solid& body, const SolidBlock& block, const Stretch& s, const Twist& X,
                    const Twist* wrenches, const BodyWork& work, double* b) {
  const double x[kTwist] = {X[0], X[1], X[2], X[3], X[4], X[5]};
  const double *y_C = block.y_C.data() + kSolidRow * s.first, *y = work.half + kSolidRow * s.first;
  for (int k = s.first; k < s.end; ++k, y_C += kSolidRow, y += kSolidRow)
    b[k] = y[3] - (y_C[0] * x[0] + y_C[1] * x[1] + y_C[2] * x[2]) -
           (y[0] * x[3] + y[1] * x[4] + y[2] * x[5]);
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    if (block.y_E[h].empty()) continue;
    Twist f = wrenches[h];
    angular(f) = work.handles[h].turn.H.transpose().lazyProduct(Angular(angular(wrenches[h])));
    const double* y_E = block.y_E[h].data() + kHandleRow * s.first;
    for (int k = s.first; k < s.end; ++k, y_E += kHandleRow)
      b[k] += (y_E[0] * f[0] + y_E[1] * f[1] + y_E[2] * f[2]) +
              (y_E[3] * f[3] + y_E[4] * f[4] + y_E[5] * f[5]);
  }
}

Twist calc_frame_acceleration(const Solid& body, const Twist* wrenches, const BodyWork& work) {
  Twist force = work.condensed.p;
  for (std::size_t h = 0; h < body.handles.size(); ++h)
    force += work.condensed.X[h].transpose().lazyProduct(wrenches[h]);
  return work.condensed.S_inverse * force;
}

Twist recover_modes(const Solid& body, const SolidBlock& block, const Twist* wrenches,
                    const BodyWork& work, double* a) {
  Twist X = calc_frame_acceleration(body, wrenches, work);
  combine_halves(body, block, all_of(body), X, wrenches, work, a);
  solve_back(block, body.coordinates(), a);
  return X;
}

int count_slices(const SolidBlock& block) { return static_cast<int>(block.factor->slices.size()); }

}  // namespace

void condense_slice(const Solid& body, const SolidBlock& block, int p, BodyWork& work) noexcept {
  assert(block.factor && work.products);
  solve_half_slice(*block.factor, p, work.rows, work.half);
  const auto slice = static_cast<std::size_t>(p);
  const Stretch stretch = stretch_of(block.factor->slices[slice]);
  run_large_kernel([&]() noexcept { store_products(body, block, stretch, slice, work); });
}

void condense_between(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                      const Angular& w, BodyWork& work) noexcept {
  assert(std::cmp_equal(body.handles.size(), work.port.handles));
  solve_half_between(*block.factor, work.rows, work.half);
  const std::size_t last = block.factor->slices.size();
  run_large_kernel([&]() noexcept {
    store_products(body, block, stretch_of(block.factor->between), last, work);
    condense_by(
        body, block, terms, w, sum_products(body, block, work),
        [&](std::size_t h) { return sum_responses(body, block, h, work); }, work);
  });
}

Twist recover_between(const Solid& body, const SolidBlock& block, const Twist* wrenches,
                      const BodyWork& work) noexcept {
  assert(wrenches && work.solution);
  Twist X;
  run_large_kernel([&]() noexcept {
    X = calc_frame_acceleration(body, wrenches, work);
    combine_halves(body, block, stretch_of(block.factor->between), X, wrenches, work,
                   work.solution);
  });
  solve_back_between(*block.factor, work.solution);
  return X;
}

void recover_slice(const Solid& body, const SolidBlock& block, int p, const Twist& X,
                   const Twist* wrenches, const BodyWork& work) noexcept {
  const Stretch stretch = stretch_of(block.factor->slices[static_cast<std::size_t>(p)]);
  run_large_kernel(
      [&]() noexcept { combine_halves(body, block, stretch, X, wrenches, work, work.solution); });
  solve_back_slice(*block.factor, p, work.solution);
}

void condense_solid(const Solid& body, const SolidBlock& block, const BodyTerms& terms,
                    const Angular& w, BodyWork& work) noexcept {
  assert(std::cmp_equal(body.handles.size(), work.port.handles));
  assert(block.y_E.size() == body.handles.size());
  if (!block.factor)
    return run_large_kernel([&]() noexcept { condense_modes(body, block, terms, w, work); });
  for (int p = 0; p < count_slices(block); ++p) condense_slice(body, block, p, work);
  condense_between(body, block, terms, w, work);
}

Twist recover_solid(const Solid& body, const SolidBlock& block, const Twist* wrenches,
                    const BodyWork& work, double* a) noexcept {
  assert(wrenches && a && block.y_E.size() == body.handles.size());
  if (!block.factor)
    return run_large_kernel(
        [&]() noexcept { return recover_modes(body, block, wrenches, work, a); });
  Twist X = recover_between(body, block, wrenches, work);
  for (int p = 0; p < count_slices(block); ++p) recover_slice(body, block, p, X, wrenches, work);
  std::copy_n(work.solution, body.coordinates(), a);
  return X;
}

}  // namespace spoke::space
