// Solves one Hermitian form after the other.

#include "engine/small_motions/vibration/equal_roots.h"

#include <algorithm>
#include <cmath>

#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr double kEqual = 1e-7;      // largest difference of equal roots, by their magnitude
constexpr double kSame = 1e-6;       // largest difference of equal features, by a vector's mass
constexpr double kDependent = 1e-3;  // below this vectors are dependent: their roots only meet

/// Turns columns by features from `kind` on.
void separate(const std::vector<MatrixXcd>& features, std::size_t kind,
              Eigen::Ref<MatrixXcd> columns) {
  if (columns.cols() < 2 || kind == features.size()) return;
  const MatrixXcd seen = features[kind] * columns;
  const HermitianEigen eigen = solve_hermitian(seen.adjoint() * seen);
  const Eigen::VectorXd sizes = eigen.values.reverse();
  const double same = kSame * std::max(1.0, sizes[0]);
  if (sizes[0] - sizes[sizes.size() - 1] <= same) {
    separate(features, kind + 1, columns);
    return;
  }
  columns = (columns * eigen.vectors.rowwise().reverse()).eval();
  for (Index begin = 0, end = 0; begin < columns.cols(); begin = end) {
    ++end;
    while (end < columns.cols() && sizes[begin] - sizes[end] <= same) ++end;
    separate(features, kind + 1, columns.middleCols(begin, end - begin));
  }
}

/// Returns the matrix of x_i^H M x_k.
MatrixXcd multiply_by_mass(const Pencil& pencil, const MatrixXcd& vectors) {
  const MatrixXcd x = pencil.scale().cwiseInverse().asDiagonal() * vectors;
  MatrixXcd momentum(x.rows(), x.cols());
  momentum.real() = pencil.mass(x.real());
  momentum.imag() = pencil.mass(x.imag());
  return x.adjoint() * momentum;
}

/// Separates `count` vectors that have one root.
void separate_group(const Pencil& pencil,
                    const std::function<Features(const Eigen::VectorXcd&)>& features_of,
                    Root* roots, Index count) {
  MatrixXcd vectors(roots[0].x.size(), count);
  for (Index k = 0; k < count; ++k) vectors.col(k) = roots[k].x;
  const HermitianEigen eigen = solve_hermitian(multiply_by_mass(pencil, vectors));
  if (eigen.values[0] < kDependent) return;
  vectors = (vectors * eigen.inverse_square_root()).eval();
  std::vector<MatrixXcd> features;
  for (Index k = 0; k < count; ++k) {
    const Features own = features_of(vectors.col(k));
    if (features.empty())
      for (const Eigen::VectorXcd& feature : own) features.emplace_back(feature.size(), count);
    for (std::size_t kind = 0; kind < own.size(); ++kind) features[kind].col(k) = own[kind];
  }
  MatrixXcd columns = MatrixXcd::Identity(count, count);
  separate(features, 0, columns);
  vectors = (vectors * columns).eval();
  for (Index k = 0; k < count; ++k) {
    Eigen::VectorXcd& x = roots[k].x;
    x = vectors.col(k);
    Index largest = 0;
    x.cwiseAbs().maxCoeff(&largest);
    x *= std::abs(x[largest]) / x[largest];
  }
}

}  // namespace

void separate_equal_roots(const Pencil& pencil,
                          const std::function<Features(const Eigen::VectorXcd&)>& features_of,
                          std::vector<Root>& roots) {
  for (std::size_t first = 0, end = 0; first < roots.size(); first = end) {
    ++end;
    while (end < roots.size() &&
           std::abs(roots[end].s - roots[first].s) <= kEqual * std::abs(roots[first].s))
      ++end;
    if (end - first > 1)
      separate_group(pencil, features_of, &roots[first], static_cast<Index>(end - first));
  }
}

}  // namespace spoke::vibration
