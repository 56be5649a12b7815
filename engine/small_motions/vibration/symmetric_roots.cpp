// Solves symmetric eigenproblems from shifted inverses.

#include "engine/small_motions/vibration/symmetric_roots.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/small_motions/vibration/choose_roots.h"
#include "engine/small_motions/vibration/rigid_motions.h"
#include "engine/small_motions/vibration/symmetric_space.h"
#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Largest size of the matrices that Eigen's dense solver takes.
constexpr Index kSmall = 400;
constexpr double kDigit = std::numeric_limits<double>::epsilon();
/// Least reciprocal condition of a stiffness that is inverted as it is.
constexpr double kRegular = 1e-13;

/// Roots from one inverse, and the frequency up to which it has them with enough digits.
struct Group {
  std::vector<Root> roots;
  double reach = 0.0;
};

/// Leaves out roots of which the inverse has too few digits: round-off of the largest of its values
/// counts for the others by the squares of their frequencies.
Group make_group(ChosenRoots chosen, const VectorXd& inverse) {
  constexpr double kReach = 1e3;
  const double largest = inverse.cwiseAbs().maxCoeff();
  const auto is_known = [&](const Checked& pair) {
    return kReach * kReach * std::abs(inverse[pair.column]) >= largest;
  };
  const auto left_out = std::find_if_not(chosen.checked.begin(), chosen.checked.end(), is_known);
  chosen.roots.resize(chosen.roots.size() -
                      static_cast<std::size_t>(chosen.checked.end() - left_out));
  return {std::move(chosen.roots), kReach / std::sqrt(largest)};
}

/// K + shift^2 M factorised, with the smallest of some shifts that makes it positive definite.
struct ShiftedFactor {
  double square = 0.0;
  CholeskyFactor factor;
};
ShiftedFactor factorise(const MatrixXd& K, const MatrixXd& M, const Pencil& pencil) {
  const VectorXd diagonal = K.diagonal();
  if (pencil.is_held() && diagonal.minCoeff() > 0.0) {
    const VectorXd balance = diagonal.cwiseSqrt().cwiseInverse();
    const CholeskyFactor balanced(balance.asDiagonal() * K * balance.asDiagonal());
    if (balanced.is_positive_definite() && balanced.rcond() > kRegular)
      return {0.0, CholeskyFactor(K)};
  }
  for (double shift = kShift * pencil.softest();; shift *= 4.0) {
    ShiftedFactor shifted{shift * shift, CholeskyFactor(K + shift * shift * M)};
    if (shifted.factor.is_positive_definite() || !std::isfinite(shift)) return shifted;
  }
}

/// Returns the lowest roots from all of the whole matrix.
Group find_all(const Pencil& pencil, Index count) {
  const auto symmetric = [](const MatrixXd& A) { return MatrixXd(0.5 * (A + A.transpose())); };
  const MatrixXd M = symmetric(pencil.dense_mass()), K = symmetric(pencil.dense_stiffness());
  const ShiftedFactor shifted = factorise(K, M, pencil);
  const MatrixXd half = shifted.factor.solve_lower(M);
  const MatrixXd flexibility = shifted.factor.solve_lower(half.transpose());
  const SymmetricEigen eigen = solve_symmetric(symmetric(flexibility));
  const VectorXd& inverse = eigen.values;
  const auto& factor = shifted.factor;
  const double square = shifted.square;
  // Round-off of the inverse of K is judged by its trace, because single coordinates may have
  // little mass.
  const double trace = factor.solve_lower(MatrixXd::Identity(K.rows(), K.rows())).squaredNorm();
  const Spectrum spectrum{(square - inverse.array().inverse()).cast<Complex>().sqrt(),
                          [&](Index k) -> VectorXcd {
                            return factor.solve_upper(eigen.vectors.col(k)).cast<Complex>();
                          },
                          [=](Complex s) {
                            const double distance = std::abs(square - s * s);
                            return 10.0 * kDigit * trace * distance * distance;
                          }};
  const MatrixXd rigid = find_rigid_motions_below(std::sqrt(square), pencil);
  return make_group(choose_roots(pencil, spectrum, rigid, count), inverse);
}

/// Whether pairs have converged: the error of a value is the square of its remainder, in its size.
bool have_converged(const SymmetricSpace& space, const SymmetricSpace::Pairs& pairs,
                    const std::vector<Checked>& checked) {
  constexpr double kDigits = 1e-9;
  const double largest = pairs.ritz.values.cwiseAbs().maxCoeff();
  const double lost = 100.0 * (pairs.round_off + kDigit * largest);
  return std::all_of(checked.begin(), checked.end(), [&](const Checked& pair) {
    const double digits = kDigits * std::abs(pairs.ritz.values[pair.column]);
    return space.find_remainder(pairs.ritz, pair.column) <= digits + lost;
  });
}

/// Returns the lowest roots beside known motions, of which the first ones are `rigid`, from Ritz
/// values of a shifted inverse in a space that grows by blocks.
Group iterate(const Pencil& pencil, double shift, const MatrixXd& known, const MatrixXd& rigid,
              Index count) {
  const Index width = std::min(pencil.size(), std::ssize(pencil.subsystems()) + 1);
  SymmetricSpace space(pencil, shift, known, width);
  Index wanted = count + 2 * width + 8;
  while (true) {
    while (!space.is_all() && space.size() < wanted) space.grow();
    const SymmetricSpace::Pairs pairs = space.find_pairs();
    const VectorXd& inverse = pairs.ritz.values;
    const double largest = inverse.cwiseAbs().maxCoeff();
    const Spectrum spectrum{(shift * shift - inverse.array().inverse()).cast<Complex>().sqrt(),
                            [&](Index k) -> VectorXcd {
                              return (space.basis() * pairs.ritz.vectors.col(k)).cast<Complex>();
                            },
                            [=](Complex s) {
                              const double distance = std::abs(shift * shift - s * s);
                              return 10.0 * (kDigit * largest + pairs.round_off) * distance *
                                     distance;
                            }};
    ChosenRoots chosen = choose_roots(pencil, spectrum, rigid, count);
    if (space.is_all() ||
        (std::ssize(chosen.roots) == count && have_converged(space, pairs, chosen.checked)))
      return make_group(std::move(chosen), inverse);
    wanted = space.size() + std::max<Index>(count, 2 * width);
  }
}

/// Motions that nothing holds make the stiffness singular: the shift makes it regular.
double choose_shift(const Pencil& pencil) {
  if (!pencil.has_hub() && pencil.is_held() &&
      PencilFactor(pencil, PencilWeights{0.0, 0.0, 1.0}).rcond() > kRegular)
    return 0.0;
  return kShift * pencil.softest();
}

Group find_lowest(const Pencil& pencil, Index count) {
  if (pencil.size() <= kSmall) return find_all(pencil, count);
  const double shift = choose_shift(pencil);
  const MatrixXd rigid = find_rigid_motions_below(shift, pencil);
  return iterate(pencil, shift, rigid, rigid, count);
}

}  // namespace

MatrixXd find_rigid_motions_below(double shift, const Pencil& pencil) {
  constexpr double kBelow = 0.02;
  return shift > 0.0 ? find_rigid_motions(pencil, kBelow * shift) : MatrixXd(pencil.size(), 0);
}

std::vector<Root> find_symmetric_roots(const Pencil& pencil, Index count) {
  auto [roots, reach] = find_lowest(pencil, count);
  while (std::ssize(roots) < count) {
    MatrixXd known(pencil.size(), std::ssize(roots));
    for (Index k = 0; k < known.cols(); ++k)
      known.col(k) = roots[static_cast<std::size_t>(k)].x.real();
    const MatrixXd none(pencil.size(), 0);
    Group next = iterate(pencil, reach, known, none, count - known.cols());
    if (next.roots.empty()) break;
    std::move(next.roots.begin(), next.roots.end(), std::back_inserter(roots));
    reach = next.reach;
  }
  return std::move(roots);
}

}  // namespace spoke::vibration
