// Turns the hub's components across its axis.

#include "engine/small_motions/vibration/standing_axes.h"

#include <cmath>
#include <stdexcept>

namespace spoke::vibration {

using Eigen::MatrixXd;

MatrixXd Turning::at(double psi) const {
  return mean + std::cos(psi) * cosine + std::sin(psi) * sine;
}

StandingAxes make_standing_axes(const std::vector<int>& components, bool is_spatial, double speed) {
  const Eigen::Index size = is_spatial ? 6 : 3;
  MatrixXd along = MatrixXd::Zero(size, size), across = along, turned = along;
  for (Eigen::Index k = 0; k < size; ++k) {
    const Eigen::Index place = k % 3;
    (place == 2 ? along : across)(k, k) = 1.0;
    if (place != 0) continue;
    turned(k, k + 1) = -1.0;
    turned(k + 1, k) = 1.0;
  }
  const auto chosen = [&](const MatrixXd& m) { return MatrixXd(m(components, components)); };
  StandingAxes axes{{chosen(along), chosen(across), chosen(turned)}, {}, speed};
  if (axes.T.sine.squaredNorm() != axes.T.cosine.sum())
    throw std::logic_error("the hub has one component across its axis without the other");
  axes.W = speed * axes.T.sine;
  return axes;
}

SecondOrder stand_columns(const SecondOrder& columns, const StandingAxes& axes) {
  return stand_columns(columns, axes.W);
}

SecondOrder stand_columns(const SecondOrder& columns, const MatrixXd& W) {
  return {columns.M, columns.C - 2.0 * columns.M * W,
          columns.K - columns.C * W + columns.M * W * W};
}

}  // namespace spoke::vibration
