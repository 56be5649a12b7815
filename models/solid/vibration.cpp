#include "models/solid/vibration.h"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "spoke/error.h"

// K phi = W^2 M phi is solved as K^-1 M phi = theta phi, theta = 1/W^2, whose greatest values
// Spectra finds. One Krylov space need not hold all modes of one frequency: what is left without
// the modes found is looked through again.

namespace spoke::solid {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns numbers in (-1, 1), the same ones on every machine.
VectorXd fixed_numbers(Index size) {
  std::uint64_t state = 1;
  VectorXd x(size);
  for (double& value : x) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    value = static_cast<double>(static_cast<std::int64_t>(state) >> 11) * 0x1p-52;
  }
  return x;
}

/// Columns that are orthonormal with M, and M times them.
struct KnownModes {
  MatrixXd Q, MQ;

  KnownModes(const Sparse& M, MatrixXd columns) : Q(std::move(columns)), MQ(M * Q) {}
};

/// K^-1 of a vector, without its parts along modes that are known; as Spectra asks for it.
class InverseProduct {
 public:
  using Scalar = double;

  InverseProduct(const Inverse& inverse, const KnownModes& known, const std::function<void()>& tick)
      : inverse_(inverse), known_(known), tick_(tick) {}

  Index rows() const { return known_.Q.rows(); }
  Index cols() const { return rows(); }
  void set_shift(double) {}  // the spectrum is that about 0
  void perform_op(const double* x, double* y) const {
    MatrixXd solution = inverse_(Eigen::Map<const VectorXd>(x, rows()));
    remove_parts(known_.Q, known_.MQ, solution);
    Eigen::Map<VectorXd>(y, rows()) = solution;
    tick_();
  }

 private:
  const Inverse& inverse_;
  const KnownModes& known_;
  const std::function<void()>& tick_;
};

/// M times a vector.
class MassProduct {
 public:
  using Scalar = double;

  explicit MassProduct(const Sparse& M) : M_(M) {}
  Index rows() const { return M_.rows(); }
  Index cols() const { return M_.cols(); }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<VectorXd>(y, rows()).noalias() = M_ * Eigen::Map<const VectorXd>(x, rows());
  }

 private:
  const Sparse& M_;
};

/// Values theta, descending, with their modes.
struct InverseModes {
  VectorXd values;
  MatrixXd shapes;

  Index size() const { return values.size(); }
};

/// Returns the modes of both, the greatest values first, at most `most` of them.
InverseModes merge(const InverseModes& a, const InverseModes& b, Index most) {
  std::vector<Index> order;
  for (Index i = 0; i < a.size() + b.size(); ++i) order.push_back(i);
  const auto value = [&](Index i) { return i < a.size() ? a.values[i] : b.values[i - a.size()]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return value(i) > value(j); });
  order.resize(static_cast<std::size_t>(std::min<Index>(most, std::ssize(order))));
  InverseModes all{VectorXd(std::ssize(order)), MatrixXd(a.shapes.rows(), std::ssize(order))};
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index i = order[k], to = static_cast<Index>(k);
    all.values[to] = value(i);
    all.shapes.col(to) = i < a.size() ? a.shapes.col(i) : b.shapes.col(i - a.size());
  }
  return all;
}

/// Looks for modes of K, M outside of the rigid motions.
class ModeFinder {
 public:
  ModeFinder(const Sparse& M, const Inverse& inverse, const MatrixXd& rigid, const PartDone& done)
      : M_(M), inverse_(inverse), rigid_(rigid), done_(done) {}

  Index available() const { return M_.rows() - rigid_.cols(); }

  /// Finds the `count` greatest values.
  InverseModes find(Index count) {
    // A few of small matrices, or most of larger ones, are found sooner by full matrices.
    if (available() <= kSmall || 3 * count >= available()) return find_all(count);
    steps_ = 4.0 * static_cast<double>(count) + 80.0;
    InverseModes found = search(count, {});
    for (;;) {
      const InverseModes further = search(std::min<Index>(2, available() - found.size()), found);
      const double least = found.values[found.size() - 1];
      if (further.values[0] <= least * (1.0 + 1e-8)) return found;
      found = merge(found, further, count);
    }
  }

 private:
  static constexpr Index kSmall = 300;

  /// Finds `count` modes besides `found`.
  InverseModes search(Index count, const InverseModes& found) {
    MatrixXd columns(M_.rows(), rigid_.cols() + found.size());
    columns.leftCols(rigid_.cols()) = rigid_;
    if (found.size() > 0) columns.rightCols(found.size()) = found.shapes;
    const KnownModes known(M_, std::move(columns));
    const std::function<void()> tick = [this] { count_step(); };
    InverseProduct inverse(inverse_, known, tick);
    MassProduct mass(M_);
    const VectorXd start = M_ * fixed_numbers(M_.rows());
    VectorXd first(M_.rows());
    inverse.perform_op(start.data(), first.data());
    const Index most = available() - found.size();
    for (Index width = std::max<Index>(2 * count + 8, 20);; width *= 2) {
      Spectra::SymGEigsShiftSolver<InverseProduct, MassProduct, Spectra::GEigsMode::ShiftInvert>
          solver(inverse, mass, count, std::min(width, most), 0.0);
      solver.init(first.data());
      solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-12);
      if (solver.info() == Spectra::CompInfo::Successful)
        // Spectra returns W^2, in an order of its own.
        return merge({solver.eigenvalues().cwiseInverse(), solver.eigenvectors()}, {}, count);
      if (width >= most)
        throw InputError("modes of vibration are not found, expected a mesh of sound elements",
                         {.key = "mesh"});
    }
  }

  /// Finds them by full matrices.
  InverseModes find_all(Index count) const {
    const MatrixXd M(M_);
    const MatrixXd product = M * inverse_(M);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(
        0.5 * (product + product.transpose()), M);
    return {eigen.eigenvalues().reverse().head(count),
            eigen.eigenvectors().rowwise().reverse().leftCols(count)};
  }

  void count_step() {
    part_ += (1.0 - part_) / steps_;
    if (done_) done_(part_);
  }

  const Sparse& M_;
  const Inverse& inverse_;
  const MatrixXd& rigid_;
  const PartDone& done_;
  double steps_ = 1.0, part_ = 0.0;
};

/// Counts the values that are wanted; -1: there may be more.
Index count_wanted(const InverseModes& found, Index available, const ModeChoice& choice) {
  if (!choice.up_to) return choice.count;
  Index below = 0;
  while (below < found.size() && 1.0 <= *choice.up_to * found.values[below]) ++below;
  return below < found.size() || below == available ? below : -1;
}

}  // namespace

void remove_parts(const Eigen::Ref<const Eigen::MatrixXd>& Q,
                  const Eigen::Ref<const Eigen::MatrixXd>& MQ, Eigen::MatrixXd& X) {
  const Eigen::MatrixXd parts = MQ.transpose() * X;
  X.noalias() -= Q * parts;
}

void fix_signs(Eigen::MatrixXd& columns) {
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    const double largest = columns.col(c).cwiseAbs().maxCoeff();
    for (const double value : columns.col(c)) {
      if (std::abs(value) < (1.0 - 1e-6) * largest) continue;
      if (value < 0.0) columns.col(c) *= -1.0;
      break;
    }
  }
}

VibrationModes find_modes(const Sparse& M, const Inverse& inverse, const Eigen::MatrixXd& rigid,
                          const ModeChoice& choice, const PartDone& done) {
  ModeFinder finder(M, inverse, rigid, done);
  const Index available = finder.available();
  assert(choice.up_to || choice.count <= available);
  VibrationModes modes;
  modes.shapes.resize(M.rows(), 0);
  if ((!choice.up_to && choice.count == 0) || available == 0) return modes;
  constexpr Index kFirst = 24;  // where a frequency says how many
  Index count = choice.up_to ? std::min(kFirst, available) : Index{choice.count};
  for (;; count = std::min(2 * count, available)) {
    if (choice.up_to && choice.require) choice.require(static_cast<int>(count));
    const InverseModes found = finder.find(count);
    const Index wanted = count_wanted(found, available, choice);
    if (wanted < 0) continue;
    modes.squares = found.values.head(wanted).cwiseInverse();
    modes.shapes = found.shapes.leftCols(wanted);
    fix_signs(modes.shapes);
    return modes;
  }
}

}  // namespace spoke::solid
