// Solves quadratic eigenproblems.

#include "engine/small_motions/vibration/eigenvalues.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "engine/small_motions/vibration/arnoldi_space.h"
#include "engine/small_motions/vibration/choose_roots.h"
#include "engine/small_motions/vibration/symmetric_roots.h"
#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Largest size of the matrices that Eigen's dense solver takes.
constexpr Index kSmall = 24;
constexpr double kDigit = std::numeric_limits<double>::epsilon();

/// Scales the vector to unit mass, its largest component real and positive.
void normalise(const Pencil& pencil, Root& root) {
  root.x = to_unit_mass(pencil, root.x);
  Index largest = 0;
  root.x.cwiseAbs().maxCoeff(&largest);
  root.x *= std::abs(root.x[largest]) / root.x[largest];
  root.x = pencil.scale().asDiagonal() * root.x;
}

/// The inverse of the first-order system less a shift, on blocks of vectors (f x, x'). The
/// frequency f makes both parts equally large where the inverse is largest.
class Inverse {
 public:
  Inverse(const Pencil& pencil, double shift)
      : pencil_(&pencil), shift_(shift), factor_(pencil, shift) {
    if (factor_.rcond() > 0.0) find_frequency();
  }

  MatrixXd operator*(const MatrixXd& b) const {
    const Index n = pencil_->size();
    MatrixXd y(b.rows(), b.cols());
    const MatrixXd x = b.topRows(n) / frequency_;
    y.topRows(n) = -factor_.solve(pencil_->mass(b.bottomRows(n)) + pencil_->damping(shift_, x));
    y.bottomRows(n) = x + shift_ * y.topRows(n);
    y.topRows(n) *= frequency_;
    return y;
  }
  double rcond() const { return factor_.rcond(); }
  double shift() const { return shift_; }

 private:
  /// Finds f by vector iteration: the inverse is as large as the reciprocal of the least root.
  void find_frequency() {
    VectorXd x = VectorXd::Ones(pencil_->size());
    for (int k = 0; k < 4; ++k) {
      const VectorXd y = factor_.solve(pencil_->mass(x));
      const double grown = y.norm() / x.norm();
      if (!(grown > 0.0) || !std::isfinite(grown)) return;
      frequency_ = 1.0 / std::sqrt(grown);
      x = y / y.norm();
    }
  }

  const Pencil* pencil_;
  double shift_;
  PencilFactor factor_;
  double frequency_ = 1.0;
};

/// Returns roots and vectors of the inverse's eigenvalues. The error of a root follows from
/// round-off of the inverse, by its largest eigenvalue.
Spectrum make_spectrum(const VectorXcd& eigenvalues, double shift,
                       std::function<VectorXcd(Index)> vector) {
  constexpr double kRoundOff = 100.0 * kDigit;
  const double largest = eigenvalues.size() > 0 ? eigenvalues.cwiseAbs().maxCoeff() : 0.0;
  return {shift + eigenvalues.array().inverse(), std::move(vector), [=](Complex s) {
            const double distance = std::abs(s - shift);
            return kRoundOff * largest * distance * distance * distance;
          }};
}

/// Returns the roots of a small pencil from the whole matrix of the inverse, which keeps the digits
/// of the roots of least magnitude; in the matrix itself stiff coordinates would take them away.
std::vector<Root> find_small(const Pencil& pencil, const Inverse& inverse, Index count) {
  const Index n = pencil.size();
  const GeneralEigen eigen = solve_general(inverse * MatrixXd::Identity(2 * n, 2 * n));
  const Spectrum spectrum = make_spectrum(eigen.values, inverse.shift(), [&](Index k) {
    return VectorXcd(eigen.vectors.col(k).head(n));
  });
  return choose_roots(pencil, spectrum, find_rigid_motions_below(inverse.shift(), pencil), count)
      .roots;
}

/// Eigenvalues of the projection of the inverse on a space, and their vectors in its basis.
using RitzPairs = GeneralEigen;
RitzPairs find_pairs(const ArnoldiSpace& space) { return solve_general(space.projected()); }

/// Returns the remainder of the equation of the inverse for a pair whose vector has length one.
double find_remainder(const ArnoldiSpace& space, const RitzPairs& pairs, Index k) {
  const VectorXcd x = pairs.vectors.col(k), y = pairs.values[k] * x;
  const double real = (space.image() * x.real() - space.basis() * y.real()).squaredNorm();
  const double imag = (space.image() * x.imag() - space.basis() * y.imag()).squaredNorm();
  return std::sqrt(real + imag) / x.norm();
}

/// Whether eigenvalues have converged: to 11 digits; where two are close, which would leave half of
/// the digits, to round-off of the largest eigenvalues of the inverse.
bool have_converged(const ArnoldiSpace& space, const RitzPairs& pairs,
                    const std::vector<Checked>& checked) {
  const double lost = 100.0 * kDigit * space.image().colwise().norm().maxCoeff();
  return std::all_of(checked.begin(), checked.end(), [&](const Checked& pair) {
    const double digits = pair.is_double ? 0.0 : 1e-11 * std::abs(pairs.values[pair.column]);
    return find_remainder(space, pairs, pair.column) <= digits + lost;
  });
}

/// Returns the roots from Ritz values of the inverse in a space that grows by blocks, until those
/// that are wanted have converged or the space is complete.
std::vector<Root> iterate(const Pencil& pencil, const Inverse& inverse, Index count) {
  const Index n = pencil.size(), size = 2 * n;
  const Index width = std::min(size, std::ssize(pencil.subsystems()) + 1);
  const MatrixXd rigid = find_rigid_motions_below(inverse.shift(), pencil);
  ArnoldiSpace space(size, width);
  Index wanted = 2 * count + 2 * width + 8;
  while (true) {
    while (!space.is_all() && space.size() < wanted) space.grow(inverse);
    const RitzPairs pairs = find_pairs(space);
    const auto vector = [&](Index k) {
      VectorXcd x(n);
      x.real() = space.basis().topRows(n) * pairs.vectors.col(k).real();
      x.imag() = space.basis().topRows(n) * pairs.vectors.col(k).imag();
      return x;
    };
    ChosenRoots chosen =
        choose_roots(pencil, make_spectrum(pairs.values, inverse.shift(), vector), rigid, count);
    if (space.is_all() ||
        (std::ssize(chosen.roots) == count && have_converged(space, pairs, chosen.checked)))
      return std::move(chosen.roots);
    wanted = space.size() + std::max<Index>(count, 2 * width);
  }
}

/// Motions that nothing holds make the stiffness singular: the shift makes it regular.
Inverse make_inverse(const Pencil& pencil) {
  if (!pencil.has_hub() && pencil.is_held()) {
    Inverse plain(pencil, 0.0);
    if (plain.rcond() > 1e-13) return plain;
  }
  return Inverse(pencil, kShift * pencil.softest());
}

}  // namespace

std::vector<Root> find_roots(const Pencil& pencil, Index count) {
  assert(count >= 0 && count <= pencil.size());
  const Index n = pencil.size();
  std::vector<Root> roots;
  if (n == 0) return roots;
  if (pencil.is_symmetric()) {
    roots = find_symmetric_roots(pencil, count);
  } else {
    const Inverse inverse = make_inverse(pencil);
    roots = n <= kSmall ? find_small(pencil, inverse, count) : iterate(pencil, inverse, count);
  }
  for (Root& root : roots) normalise(pencil, root);
  return roots;
}

}  // namespace spoke::vibration
