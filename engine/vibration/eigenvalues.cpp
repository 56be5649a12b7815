// Symmetric and quadratic eigenproblems.

#include "engine/vibration/eigenvalues.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sizes of the matrices that are left to Eigen's dense solvers.
constexpr Index kSmallSymmetric = 400;
constexpr Index kSmall = 24;
/// Below this, by the frequency of the stiffest coordinate, an eigenvalue is nothing but round-off.
constexpr double kZero = 1e-8;

bool is_symmetric(const MatrixXd& m) {
  return (m - m.transpose()).lpNorm<Eigen::Infinity>() <= 1e-9 * m.lpNorm<Eigen::Infinity>();
}

/// Unit mass, and a first large component that is real and positive.
void normalise(const Pencil& pencil, Root& root) {
  const MatrixXd mass_real = pencil.mass(root.x.real()), mass_imag = pencil.mass(root.x.imag());
  const double mass = root.x.real().dot(mass_real.col(0)) + root.x.imag().dot(mass_imag.col(0));
  Index largest = 0;
  root.x.cwiseAbs().maxCoeff(&largest);
  const std::complex<double> phase = std::abs(root.x[largest]) / root.x[largest];
  root.x *= phase / std::sqrt(mass);
  root.x = pencil.scale().asDiagonal() * root.x;
}

/// Roots of the symmetric problem K x = w^2 M x. Where K is positive definite by its inverse, which
/// keeps the digits of the lowest ones.
std::vector<Root> find_symmetric(const MatrixXd& K, const MatrixXd& M, double zero, Index count) {
  std::vector<Root> roots;
  const auto add = [&](double square, const VectorXd& x) {
    const std::complex<double> s =
        std::abs(square) <= zero * zero ? 0.0 : std::sqrt(std::complex<double>(-square));
    roots.push_back({s, x.cast<std::complex<double>>()});
  };
  const Eigen::LLT<MatrixXd> factor(K);
  if (factor.info() == Eigen::Success && factor.rcond() > 1e-15) {
    const MatrixXd half = factor.matrixL().solve(M);
    const MatrixXd flexibility = factor.matrixL().solve(half.transpose());
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(0.5 *
                                                         (flexibility + flexibility.transpose()));
    for (Index k = K.rows(); k-- > 0 && std::ssize(roots) < count;)
      add(1.0 / solver.eigenvalues()[k], factor.matrixU().solve(solver.eigenvectors().col(k)));
    return roots;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, M);
  for (Index k = 0; k < std::min(count, K.rows()); ++k)
    add(solver.eigenvalues()[k], solver.eigenvectors().col(k));
  return roots;
}

/// An eigenvalue, and the column of its vector.
struct Choice {
  std::complex<double> s;
  Index column;
};

/// Of eigenvalues those that stand for a root: of conjugate pairs one, of pairs zero one; ascending
/// by magnitude.
std::vector<Choice> choose(const Eigen::VectorXcd& values, double zero, Index count) {
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return std::abs(values[a]) < std::abs(values[b]); });
  std::vector<Choice> choices;
  int zeros = 0;
  for (const Index k : order) {
    std::complex<double> s = values[k];
    if (std::abs(s) <= zero) {
      if (++zeros % 2 == 0) continue;  // a motion that goes on has two
      s = 0.0;
    } else if (s.imag() < -1e-9 * std::abs(s)) {
      continue;
    }
    if (std::abs(s.imag()) <= 1e-9 * std::abs(s)) s = s.real();
    choices.push_back({s, k});
    if (std::ssize(choices) == count) break;
  }
  return choices;
}

/// The inverse of the first-order system less a shift, on blocks of vectors (x, x').
class Inverse {
 public:
  Inverse(const Pencil& pencil, double shift)
      : pencil_(&pencil), shift_(shift), factor_(pencil, shift) {}

  MatrixXd operator*(const MatrixXd& b) const {
    const Index n = pencil_->size();
    MatrixXd y(b.rows(), b.cols());
    y.topRows(n) =
        -factor_.solve(pencil_->mass(b.bottomRows(n)) + pencil_->damping(shift_, b.topRows(n)));
    y.bottomRows(n) = b.topRows(n) + shift_ * y.topRows(n);
    return y;
  }
  double rcond() const { return factor_.rcond(); }
  double shift() const { return shift_; }

 private:
  const Pencil* pencil_;
  double shift_;
  PencilFactor factor_;
};

/// All roots of a small pencil, from the whole matrix of the inverse: it keeps the digits of the
/// roots of least magnitude, which stiff coordinates would take away from the matrix itself.
std::vector<Root> find_small(const Pencil& pencil, const Inverse& inverse, double zero,
                             Index count) {
  const Index n = pencil.size();
  const Eigen::EigenSolver<MatrixXd> solver(inverse * MatrixXd::Identity(2 * n, 2 * n));
  const Eigen::VectorXcd values = inverse.shift() + solver.eigenvalues().array().inverse();
  std::vector<Root> roots;
  for (const Choice& choice : choose(values, zero, count))
    roots.push_back({choice.s, solver.eigenvectors().col(choice.column).head(n)});
  return roots;
}

/// Takes out of a block what lies in a basis.
void project_out(const MatrixXd& basis, MatrixXd& block) {
  block.noalias() -= basis * (basis.transpose() * block).eval();
}

/// Makes the columns of a block orthonormal, among themselves and to a basis. What is left of a
/// column that depends on others is thrown dice for.
void orthonormalise(const MatrixXd& basis, std::mt19937& dice, MatrixXd& block) {
  std::normal_distribution<double> normal;
  for (int twice = 0; twice < 2; ++twice) {
    VectorXd before = block.colwise().norm();
    project_out(basis, block);
    for (Index k = 0; k < block.cols(); ++k)
      for (int trial = 0; trial < 3; ++trial) {
        VectorXd column = block.col(k);
        for (int again = 0; again < 2; ++again)
          column -= block.leftCols(k) * (block.leftCols(k).transpose() * column);
        const double after = column.norm();
        block.col(k) = column / after;
        if (after > 1e-12 * before[k]) break;
        MatrixXd thrown = MatrixXd::NullaryExpr(block.rows(), 1, [&] { return normal(dice); });
        project_out(basis, thrown);
        block.col(k) = thrown;
        before[k] = thrown.norm();
      }
  }
}

/// The space that an operator spans from a block of vectors on.
class BlockSpace {
 public:
  BlockSpace(Index size, Index width) : block_(size, width), basis_(size, 0), image_(size, 0) {
    std::normal_distribution<double> normal;
    for (Index k = 0; k < width; ++k)
      for (Index i = 0; i < size; ++i) block_(i, k) = normal(dice_);
  }

  Index size() const { return basis_.cols(); }
  bool is_all() const { return basis_.cols() == basis_.rows(); }
  const MatrixXd& basis() const { return basis_; }
  const MatrixXd& image() const { return image_; }  ///< of the basis, by the operator

  /// Adds the image of the last block.
  void grow(const Inverse& inverse) {
    const Index rows = basis_.rows(), used = basis_.cols();
    block_.conservativeResize(rows, std::min(block_.cols(), rows - used));
    orthonormalise(basis_, dice_, block_);
    const Index added = block_.cols();
    basis_.conservativeResize(rows, used + added);
    image_.conservativeResize(rows, used + added);
    basis_.rightCols(added) = block_;
    image_.rightCols(added) = inverse * block_;
    block_ = image_.rightCols(added);
  }

 private:
  std::mt19937 dice_{1};
  MatrixXd block_, basis_, image_;
};

/// Eigenvalues of the inverse as a space has them, those of the pencil, and their vectors in the
/// basis.
struct RitzPairs {
  Eigen::VectorXcd inverse, values;
  MatrixXcd vectors;
};
RitzPairs find_pairs(const BlockSpace& space, double shift) {
  const Eigen::EigenSolver<MatrixXd> solver(MatrixXd(space.basis().transpose() * space.image()));
  const Eigen::VectorXcd& inverse = solver.eigenvalues();
  return {inverse, shift + inverse.array().inverse(), solver.eigenvectors()};
}

/// What is left of the equation of the inverse by a pair, its vector being of length one.
double find_remainder(const BlockSpace& space, const RitzPairs& pairs, Index k) {
  const Eigen::VectorXcd x = pairs.vectors.col(k), y = pairs.inverse[k] * x;
  const double real = (space.image() * x.real() - space.basis() * y.real()).squaredNorm();
  const double imag = (space.image() * x.imag() - space.basis() * y.imag()).squaredNorm();
  return std::sqrt(real + imag) / x.norm();
}

/// Whether all eigenvalues up to the last choice have converged, to round-off of the largest ones
/// of the inverse.
bool have_converged(const BlockSpace& space, const RitzPairs& pairs,
                    const std::vector<Choice>& choices) {
  constexpr double kRoundOff = 100.0 * std::numeric_limits<double>::epsilon();
  const double lost = kRoundOff * space.image().colwise().norm().maxCoeff();
  const double last = std::abs(choices.back().s) * (1.0 + 1e-9);
  for (Index k = 0; k < pairs.values.size(); ++k) {
    if (std::abs(pairs.values[k]) > last || pairs.values[k].imag() < 0.0) continue;
    if (find_remainder(space, pairs, k) > 1e-11 * std::abs(pairs.inverse[k]) + lost) return false;
  }
  return true;
}

std::vector<Root> make_roots(const BlockSpace& space, const RitzPairs& pairs,
                             const std::vector<Choice>& choices, Index size) {
  std::vector<Root> roots;
  for (const Choice& choice : choices) {
    const Eigen::VectorXcd x = pairs.vectors.col(choice.column);
    Root root{choice.s, Eigen::VectorXcd(size)};
    root.x.real() = space.basis().topRows(size) * x.real();
    root.x.imag() = space.basis().topRows(size) * x.imag();
    roots.push_back(std::move(root));
  }
  return roots;
}

/// Ritz values of the inverse in a space that grows by blocks, until those that are wanted have
/// converged or the space is all.
std::vector<Root> iterate(const Pencil& pencil, const Inverse& inverse, double zero, Index count) {
  const Index size = 2 * pencil.size();
  const Index width = std::min(size, std::ssize(pencil.trees()) + 1);
  BlockSpace space(size, width);
  Index wanted = 2 * count + 2 * width + 8;
  while (true) {
    while (!space.is_all() && space.size() < wanted) space.grow(inverse);
    const RitzPairs pairs = find_pairs(space, inverse.shift());
    const std::vector<Choice> choices = choose(pairs.values, zero, count);
    if (space.is_all() || (std::ssize(choices) == count && have_converged(space, pairs, choices)))
      return make_roots(space, pairs, choices, pencil.size());
    wanted = space.size() + std::max<Index>(count, 2 * width);
  }
}

/// A hub that can turn makes the stiffness singular: the shift leaves something to divide by.
Inverse make_inverse(const Pencil& pencil) {
  Inverse plain(pencil, 0.0);
  if (!pencil.has_hub() && plain.rcond() > 1e-15) return plain;
  return Inverse(pencil, 0.05 * pencil.softest());
}

}  // namespace

std::vector<Root> find_roots(const Pencil& pencil, Index count) {
  const double zero = kZero * pencil.stiffest();
  const Index n = pencil.size();
  std::vector<Root> roots;
  if (n <= kSmallSymmetric) {
    const MatrixXd M = pencil.dense_mass(), C = pencil.dense_damping();
    const MatrixXd K = pencil.dense_stiffness();
    // M is of unit diagonal: C is a rate, to be compared with the frequencies.
    if (is_symmetric(K) && C.lpNorm<Eigen::Infinity>() <= 1e-9 * pencil.softest())
      roots = find_symmetric(0.5 * (K + K.transpose()), 0.5 * (M + M.transpose()), zero, count);
  }
  if (roots.empty()) {
    const Inverse inverse = make_inverse(pencil);
    roots = n <= kSmall ? find_small(pencil, inverse, zero, count)
                        : iterate(pencil, inverse, zero, count);
  }
  for (Root& root : roots) normalise(pencil, root);
  return roots;
}

}  // namespace spoke::vibration
