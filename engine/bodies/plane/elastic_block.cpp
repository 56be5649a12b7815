// Factorises the two bands of an elastic block, and solves with them.

#include "engine/bodies/plane/elastic_block.h"

#include <algorithm>
#include <cassert>

#include "models/support/unroll.h"
#include "models/support/wide_kernels.h"

namespace spoke::plane {

template <int Half>
BandFactor<Half>::BandFactor(const SymmetricBand<Half>& matrix)
    : n_(matrix.size()),
      lower_(static_cast<std::size_t>(n_ + Half) * Half, Double2{}),
      inverse_diagonal_(n_) {
  std::vector<double> d(n_);
  const auto L = [&](int i, int j) -> Double2& { return lower_[i * Half + (j - i + Half)]; };
  for (int i = 0; i < n_; ++i) {
    const int first = std::max(0, i - Half);
    for (int j = first; j < i; ++j) {
      double sum = matrix(i, j);
      for (int k = std::max(first, j - Half); k < j; ++k) sum -= L(i, k)[0] * d[k] * L(j, k)[0];
      L(i, j) = broadcast(sum / d[j]);
    }
    double sum = matrix(i, i);
    for (int k = first; k < i; ++k) sum -= L(i, k)[0] * L(i, k)[0] * d[k];
    assert(sum > 0.0 && "positive definite");
    d[i] = sum;
    inverse_diagonal_[i] = 1.0 / sum;
  }
}

namespace {

/// Substitutes two right-hand sides, row by row; the last `Half` solutions are kept.
template <int Half>
class Substitution {
 public:
  explicit Substitution(const BandSystem<Half>& system, Double2* scratch)
      : L_(system.factor->row(0)),
        inverse_diagonal_(system.factor->inverse_diagonal()),
        a_(system.a),
        b_(system.b),
        x_(system.x),
        y_(system.y),
        scratch_(scratch) {}

  /// Takes row i of L, for i = 0, 1, ...
  [[gnu::always_inline]] void forward(int i) {
    Double2 sum{a_[i], b_[i]};
    for (int k = 0; k < Half; ++k) sum -= L_[Half * i + k] * last_[k];
    push(sum);
    scratch_[i] = sum;
  }

  void turn_back() {
    for (Double2& value : last_) value = Double2{};
  }

  /// Takes row i of D L^T, for i = n - 1, n - 2, ...
  [[gnu::always_inline]] Double2 backward(int i) {
    Double2 sum = inverse_diagonal_[i] * scratch_[i];
    // Column i of L below the diagonal: L(i + Half - k, i) stands in row i + Half - k.
    for (int k = 0; k < Half; ++k) sum -= L_[Half * (i + Half - k) + k] * last_[k];
    push(sum);
    return sum;
  }
  /// Takes rows i + 1 and i. Results go out in pairs of neighbours, as they will be loaded: loading
  /// two values at once that were stored one by one stalls the processor.
  [[gnu::always_inline]] void backward_pair(int i) {
    const Double2 second = backward(i + 1);
    const Double2 first = backward(i);
    store_aligned(Double2{first[0], second[0]}, x_ + i);
    store_aligned(Double2{first[1], second[1]}, y_ + i);
  }
  /// Takes row i, the last of an odd number.
  void backward_last(int i) {
    const Double2 last = backward(i);
    store_aligned(Double2{last[0], 0.0}, x_ + i);
    store_aligned(Double2{last[1], 0.0}, y_ + i);
  }

 private:
  /// Pushes the values one by one: Clang takes a loop for memmove, and then keeps them in memory.
  [[gnu::always_inline]] void push(Double2 newest) {
    unroll<Half - 1>([&](auto k) { last_[k] = last_[k + 1]; });
    last_[Half - 1] = newest;
  }

  const Double2* L_;
  const double* inverse_diagonal_;
  const double* a_;
  const double* b_;
  double* x_;
  double* y_;
  Double2* scratch_;
  Double2 last_[Half] = {};  // last_[k]: the solution Half - k rows back (then ahead)
};

}  // namespace

namespace {

void solve(const BandSystem<1>& axial, const BandSystem<3>& bending, Double2* scratch) {
  assert(bending.factor->size() == 2 * axial.factor->size());
  const int n = axial.factor->size();
  Substitution<1> u(axial, scratch);
  Substitution<3> v(bending, scratch + n);
  for (int i = 0; i < n; ++i) {
    u.forward(i);
    v.forward(2 * i);
    v.forward(2 * i + 1);
  }
  u.turn_back();
  v.turn_back();
  int i = n;
  if (n % 2 != 0) {
    --i;
    v.backward_pair(2 * i);
    u.backward_last(i);
  }
  for (i -= 2; i >= 0; i -= 2) {
    v.backward_pair(2 * i + 2);
    v.backward_pair(2 * i);
    u.backward_pair(i);
  }
}

}  // namespace

void solve_together(const BandSystem<1>& axial, const BandSystem<3>& bending,
                    Double2* scratch) noexcept {
  run_kernel([&]() noexcept { solve(axial, bending, scratch); });
}

template <int Half>
Eigen::VectorXd BandFactor<Half>::solve(const Eigen::VectorXd& b) const {
  assert(b.size() >= n_);
  std::vector<Double2> scratch(n_);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n_ + n_ % 2), y = x;
  Substitution<Half> substitution({this, b.data(), b.data(), x.data(), y.data()}, scratch.data());
  for (int i = 0; i < n_; ++i) substitution.forward(i);
  substitution.turn_back();
  for (int i = n_ - 1; i >= 0; --i) x[i] = substitution.backward(i)[0];
  return x;
}

template class BandFactor<1>;
template class BandFactor<3>;

namespace {

template <int Half>
SymmetricBand<Half> combine(double a, const SymmetricBand<Half>& A, double b,
                            const SymmetricBand<Half>& B) {
  assert(A.size() == B.size());
  SymmetricBand<Half> sum(A.size());
  sum.add_scaled(a, A);
  sum.add_scaled(b, B);
  return sum;
}

ElasticBlock::BendingColumn make_column(const FlexibleBody& body, const BandFactor<3>& factor,
                                        bool outboard, int component) {
  ElasticBlock::BendingColumn column;
  column.outboard = outboard;
  column.component = component;
  const Handle& handle = outboard ? body.outboard : body.inboard;
  column.coordinate = handle.coordinate[component] - body.axial();
  column.Z =
      factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(body.bending(), column.coordinate)));
  return column;
}

void fill_handle_compliances(ElasticBlock& block) {
  TwistMatrix Z_oo = TwistMatrix::Zero();
  Z_oo(0, 0) = block.Z_axial[block.axial_coordinate];
  for (const auto& a : block.columns)
    for (const auto& b : block.columns) {
      const double z = b.Z[a.coordinate];
      if (a.outboard && b.outboard) Z_oo(a.component, b.component) = z;
      if (!a.outboard && b.outboard) block.Z_io[b.component] = z;
      if (!a.outboard && !b.outboard) block.Z_ii = z;
    }
  block.Z_oo = {Z_oo(0, 0), Z_oo(1, 0), Z_oo(1, 1), Z_oo(2, 0), Z_oo(2, 1), Z_oo(2, 2)};
}

}  // namespace

ElasticBlock make_elastic_block(const FlexibleBody& body, double mass_factor,
                                double stiffness_factor, double damping_factor) {
  ElasticBlock block;
  block.axial =
      BandFactor<1>(combine(mass_factor, body.M_axial,
                            stiffness_factor + damping_factor * body.damping.axial, body.K_axial));
  block.bending = BandFactor<3>(combine(mass_factor, body.M_bending,
                                        stiffness_factor + damping_factor * body.damping.bending,
                                        body.K_bending));
  block.W_x = block.axial.solve(body.S_axial);
  block.W_y = block.bending.solve(body.S_bending);
  block.S_Wx = body.S_axial.dot(block.W_x);
  block.S_Wy = body.S_bending.dot(block.W_y);

  block.axial_coordinate = body.outboard.coordinate[0];
  block.Z_axial = block.axial.solve(
      Eigen::VectorXd(Eigen::VectorXd::Unit(body.padded_axial(), body.axial() - 1)));
  // These are the free bending coordinates at the handles: v and psi outboard (clamped), or psi at
  // both ends.
  const bool clamped = body.reference_frame == ReferenceFrame::clamped;
  block.columns[0] = make_column(body, block.bending, clamped, clamped ? 1 : kRotation);
  block.columns[1] = make_column(body, block.bending, true, kRotation);
  fill_handle_compliances(block);
  return block;
}

}  // namespace spoke::plane
