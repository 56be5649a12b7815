// Symmetric, positive definite, and of a thin slice.

#include "program/foreign/section_check.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace spoke::foreign {
namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;

/// Makes the matrix symmetric, unless entries differ by more than figures that were cut off do.
std::string make_symmetric(SectionMatrix& matrix, double& asymmetry) {
  constexpr double most = 1e-3;
  for (int r = 0; r < 6; ++r)
    if (!(matrix(r, r) > 0.0))
      return fmt::format("has {1} in row {0}, column {0}, expected more than 0", r + 1,
                         matrix(r, r));
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < r; ++c) {
      const double size = std::sqrt(matrix(r, r)) * std::sqrt(matrix(c, c));
      const double difference = std::abs(matrix(r, c) - matrix(c, r)) / size;
      if (!(difference <= most))
        return fmt::format(
            "is not symmetric: row {}, column {} is {}, the other is {}; expected "
            "equal ones",
            c + 1, r + 1, matrix(c, r), matrix(r, c));
      asymmetry = std::max(asymmetry, difference);
      matrix(r, c) = matrix(c, r) = 0.5 * (matrix(r, c) + matrix(c, r));
    }
  return {};
}

/// Whether the matrix, scaled to ones on its diagonal, has pivots that are more than round-off: the
/// rule of scenarios.
bool is_positive_definite(const SectionMatrix& matrix) {
  const Eigen::Matrix<double, 6, 1> scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix scaled = scale.asDiagonal() * Matrix(matrix) * scale.asDiagonal();
  const Eigen::LLT<Matrix> factor(scaled);
  constexpr double least_pivot = 1e-7;
  return factor.info() == Eigen::Success &&
         Matrix(factor.matrixL()).diagonal().minCoeff() > least_pivot;
}

std::string check_matrix(SectionMatrix& matrix, double& asymmetry) {
  std::string fault = make_symmetric(matrix, asymmetry);
  if (fault.empty() && !is_positive_definite(matrix))
    fault = "is not positive definite, expected a matrix that gives every motion energy";
  return fault;
}

}  // namespace

std::string check_stiffness(SectionMatrix& matrix, double& asymmetry) {
  return check_matrix(matrix, asymmetry);
}

std::string check_mass(SectionMatrix& m, double& asymmetry) {
  if (std::string fault = check_matrix(m, asymmetry); !fault.empty()) return fault;
  constexpr double slack = 1e-3;
  const double mass = m(2, 2), polar = m(5, 5), first = std::sqrt(mass) * std::sqrt(polar);
  const auto differ = [&](double a, double b, double size) {
    return !(std::abs(a - b) <= slack * size);
  };
  for (const int k : {0, 1})
    if (differ(m(k, k), mass, mass))
      return fmt::format(
          "has {1} in row {0}, column {0}, expected the mass per length of row 3, {2}", k + 1,
          m(k, k), mass);
  if (differ(m(0, 1), 0.0, mass) || differ(m(0, 2), 0.0, mass) || differ(m(1, 2), 0.0, mass))
    return "couples translations, expected 0 in row 1 to 3, column 1 to 3 beside the diagonal";
  if (differ(m(0, 3), 0.0, first) || differ(m(0, 4), 0.0, first) || differ(m(1, 3), 0.0, first) ||
      differ(m(1, 4), 0.0, first) || differ(m(2, 5), 0.0, first) ||
      differ(m(0, 5), -m(2, 3), first) || differ(m(1, 5), -m(2, 4), first))
    return "is not that of a slice, expected -m y, m x in rows 1 and 2 of column 6, and m y, -m x "
           "in "
           "row 3 of columns 4 and 5";
  if (differ(polar, m(3, 3) + m(4, 4), polar) || differ(m(3, 5), 0.0, polar) ||
      differ(m(4, 5), 0.0, polar))
    return fmt::format(
        "has {} in row 6, column 6, expected the sum of the two inertias before it, {}, "
        "and 0 beside it",
        polar, m(3, 3) + m(4, 4));
  return {};
}

}  // namespace spoke::foreign
