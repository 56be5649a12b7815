// Looks through places, strains and coordinates of a solid.

#include "engine/bodies/space/solid_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bodies/space/solid_output.h"

namespace spoke::space {
namespace {

/// Returns the largest displacement of a place by the extent, or its rotation.
double deflection_of(const SolidPlace& place, double extent, const double* q) {
  Twist moved = Twist::Zero();
  for (std::size_t i = 0; i < place.at.size(); ++i) moved += q[place.at[i]] * place.columns[i];
  return std::max(Position(linear(moved)).norm() / extent, Angular(angular(moved)).norm());
}

/// Returns the largest strain of a node: its von Mises stress by Young's modulus.
double find_largest_strain(const SolidConstants& body, const double* q) {
  if (body.strain_modes.size() == 0) return 0.0;
  double largest = 0.0;
  for (Eigen::Index row = 0; row < body.strain_modes.rows(); row += 6) {
    Stress s{};
    for (std::size_t i = 0; i < s.size(); ++i)
      for (Eigen::Index k = 0; k < body.strain_modes.cols(); ++k)
        s[i] += body.strain_modes(row + static_cast<Eigen::Index>(i), k) * q[k];
    largest = std::max(largest, square_von_mises(s));
  }
  return std::sqrt(largest);
}

}  // namespace

double find_largest_deflection(const Solid& solid, const double* q) noexcept {
  const SolidConstants& body = *solid.constants;
  double largest = deflection_of(body.tip, body.extent, q);
  for (int i = 0; i < body.interfaces; ++i)
    largest =
        std::max(largest, deflection_of(body.places[static_cast<std::size_t>(i)], body.extent, q));
  return std::max(largest, kStrainWeight * find_largest_strain(body, q));
}

double calc_surely_linear(const Solid& solid, double range) {
  const SolidConstants& body = *solid.constants;
  const double ratio = range / body.extent;
  double steepest = 0.0;  // the square of what coordinates of one deform at most
  const auto add = [&](const SolidPlace& place) {
    double place_squares = 0.0, turn_squares = 0.0;
    for (const Twist& column : place.columns) {
      place_squares += column.head<3>().squaredNorm();
      turn_squares += column.tail<3>().squaredNorm();
    }
    steepest = std::max({steepest, place_squares / (body.extent * body.extent), turn_squares});
  };
  add(body.tip);
  for (int i = 0; i < body.interfaces; ++i) add(body.places[static_cast<std::size_t>(i)]);
  for (Eigen::Index row = 0; row < body.strain_modes.rows(); row += 6)
    // Von Mises' stress is at most sqrt(3) times the norm of the six.
    steepest = std::max(steepest, kStrainWeight * kStrainWeight * 3.0 *
                                      body.strain_modes.middleRows(row, 6).squaredNorm());
  return steepest > 0.0 ? ratio * ratio / steepest : std::numeric_limits<double>::infinity();
}

ModeViolation find_limit_violation(const Solid& body, const double* q) noexcept {
  ModeViolation worst;
  for (int k = 0; k < body.coordinates(); ++k) {
    const double limit = body.constants->limits[static_cast<std::size_t>(k)];
    if (!std::isfinite(q[k])) return {k, q[k], limit};
    const bool is_worst =
        worst.coordinate < 0 || std::abs(q[k]) / limit > std::abs(worst.value) / worst.limit;
    if (std::abs(q[k]) > limit && is_worst) worst = {k, q[k], limit};
  }
  return worst;
}

}  // namespace spoke::space
