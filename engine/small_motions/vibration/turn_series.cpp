// Sums waves; there are few.

#include "engine/small_motions/vibration/turn_series.h"

#include <cassert>
#include <numbers>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Complex = std::complex<double>;

/// Returns exp(i k psi_l), rows k = 0 to `highest`, columns l.
MatrixXcd make_waves(Index highest, Index parts) {
  MatrixXcd waves(highest + 1, parts);
  for (Index k = 0; k <= highest; ++k)
    for (Index l = 0; l < parts; ++l)
      waves(k, l) = std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(k * l % parts) /
                                        static_cast<double>(parts));
  return waves;
}

}  // namespace

MatrixXcd find_harmonics(const MatrixXd& values) {
  const Index parts = values.cols();
  assert(parts % 2 == 1);
  return values * make_waves((parts - 1) / 2, parts).adjoint() / static_cast<double>(parts);
}

MatrixXd sum_harmonics(const MatrixXcd& harmonics, Index parts) {
  MatrixXcd waves = 2.0 * make_waves(harmonics.cols() - 1, parts);
  waves.row(0).setOnes();
  return (harmonics * waves).real();
}

MatrixXcd differ_by_azimuth(const MatrixXcd& harmonics) {
  MatrixXcd result = harmonics;
  for (Index k = 0; k < result.cols(); ++k) result.col(k) *= Complex(0.0, static_cast<double>(k));
  return result;
}

MatrixXcd shift_azimuth(const MatrixXcd& harmonics, double angle) {
  MatrixXcd result = harmonics;
  for (Index k = 0; k < result.cols(); ++k)
    result.col(k) *= std::polar(1.0, static_cast<double>(k) * angle);
  return result;
}

}  // namespace spoke::vibration
