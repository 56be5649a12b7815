// Tests the force of bearings with matrices, and what they give an implicit step.

#include "engine/bodies/kernels/loops/bearing_force.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

namespace spoke {
namespace {

Eigen::Matrix2d two_by_two(double xx, double xy, double yx, double yy) {
  Eigen::Matrix2d matrix;
  matrix << xx, xy, yx, yy;
  return matrix;
}

TEST_CASE("bearing force: the inverse of the symmetric part, where that is definite") {
  const Eigen::Matrix2d G = two_by_two(5, 3, -1, 2);
  const Eigen::Matrix2d expected = Eigen::Matrix2d(0.5 * (G + G.transpose())).inverse();
  CHECK(calc_definite_inverse(G).isApprox(expected, 1e-14));
  CHECK(calc_definite_inverse(two_by_two(4, 0, 0, 4)) == two_by_two(0.25, 0, 0, 0.25));
  CHECK(calc_definite_inverse(two_by_two(8, 0, 0, 2)).isApprox(two_by_two(0.125, 0, 0, 0.5)));
}

TEST_CASE("bearing force: else its eigenvalues are cut at 1e-6 of the norm") {
  // Cross-coupling alone, a negative spring, a singular matrix and none.
  const Eigen::Matrix2d cross = calc_definite_inverse(two_by_two(0, 3, -3, 0));
  CHECK(cross.isApprox(1e6 / (3.0 * std::sqrt(2.0)) * Eigen::Matrix2d::Identity(), 1e-12));
  CHECK(calc_definite_inverse(two_by_two(-3, 0, 0, 4)).isApprox(two_by_two(2e5, 0, 0, 0.25)));
  const Eigen::Matrix2d singular = calc_definite_inverse(two_by_two(1, 1, 1, 1));
  CHECK(singular(0, 0) + singular(0, 1) == doctest::Approx(0.5).epsilon(1e-9));
  CHECK(singular(0, 0) - singular(0, 1) == doctest::Approx(5e5));
  const Eigen::Matrix2d none = calc_definite_inverse(Eigen::Matrix2d::Zero());
  CHECK(none.allFinite());
  CHECK(none(0, 0) > 0.0);
}

TEST_CASE("bearing force: force, compliance and what no spring stores") {
  BearingModel bearing;
  bearing.axis = space::Position::UnitZ();
  bearing.table = {{two_by_two(10, 4, -2, 20), two_by_two(3, 1, 0, 2)}};
  const Eigen::Vector2d opening(0.1, -0.2), rate(2.0, 3.0);
  const BearingForce given = calc_bearing_force(bearing, opening, rate, 7.0, 0.0, 0.0);
  CHECK(given.force.isApprox(Eigen::Vector2d(-0.2 - 9.0, 4.2 - 6.0)));
  CHECK(given.compliance.isZero(0.0));
  // The symmetric part [10, 1; 1, 20] stores.
  const double stored = Eigen::Vector2d(0.8, -3.9).dot(rate);
  CHECK(given.loss.sum() == doctest::Approx(-given.force.dot(rate) - stored));
  const BearingForce asked = calc_bearing_force(bearing, opening, rate, 7.0, 0.5, 0.25);
  CHECK(asked.force == given.force);
  CHECK((asked.compliance * two_by_two(5.75, 0.625, 0.625, 10.5))
            .isApprox(Eigen::Matrix2d::Identity(), 1e-14));
  bearing.speeds = {0.0, 10.0};
  bearing.table.push_back(bearing.table[0]);
  const BearingForce by_table = calc_bearing_force(bearing, opening, rate, 7.0, 0.0, 0.0);
  CHECK(by_table.loss.sum() == doctest::Approx(-given.force.dot(rate)));
}

TEST_CASE("bearing force: its speed is that of from against to, about the axis of to") {
  BearingModel bearing;
  bearing.axis = space::Position::UnitZ();
  PlaceMotion from, to;
  to.R = space::exponential(space::Angular(0.0, 0.5 * std::acos(-1.0), 0.0));  // z turns to x
  angular(from.twist) = space::Angular(5.0, 1.0, 2.0);
  angular(to.twist) = space::Angular(1.5, 4.0, 4.0);
  CHECK(calc_bearing_speed(bearing, from, to) == doctest::Approx(3.5));
}

}  // namespace
}  // namespace spoke
