// Tests the matrices of bearings by their speed.

#include "models/system/bearing_model.h"

#include <doctest/doctest.h>

#include "models/system/loop_model.h"

namespace spoke {
namespace {

Eigen::Matrix2d matrix_of(double xx, double xy, double yx, double yy) {
  Eigen::Matrix2d matrix;
  matrix << xx, xy, yx, yy;
  return matrix;
}

Loop make_bearing_loop(const spatial::Vector& axis) {
  Loop loop;
  loop.kind = LoopKind::bearing;
  loop.axes[0] = axis;
  loop.matrices = BearingMatrices{{}, {matrix_of(5, 1, -2, 7)}, {}};
  return loop;
}

TEST_CASE("bearing model: constant matrices are those of any speed") {
  const BearingModel bearing = *make_loop(make_bearing_loop({0, 0, 2}), false).bearing;
  for (const double speed : {-300.0, 0.0, 40.0}) {
    CHECK(bearing.at(speed).stiffness == matrix_of(5, 1, -2, 7));
    CHECK(bearing.at(speed).damping.isZero(0.0));
  }
  // A spring stores what the symmetric part does.
  CHECK(bearing.storing() == matrix_of(5, -0.5, -0.5, 7));
}

TEST_CASE("bearing model: tables are linear between speeds and stay beyond them") {
  Loop loop = make_bearing_loop({0, 0, 1});
  loop.matrices->speed = {-10.0, 30.0, 50.0};
  loop.matrices->stiffness = {matrix_of(1, 2, 3, 4), matrix_of(5, 6, 7, 8), matrix_of(1, 0, 0, 1)};
  loop.matrices->damping = {matrix_of(4, 0, 0, 4), matrix_of(8, 0, 0, 8), matrix_of(0, 1, -1, 0)};
  const BearingModel bearing = *make_loop(loop, false).bearing;
  CHECK(bearing.at(-11.0).stiffness == matrix_of(1, 2, 3, 4));
  CHECK(bearing.at(-10.0).stiffness == matrix_of(1, 2, 3, 4));
  CHECK(bearing.at(0.0).stiffness == matrix_of(2, 3, 4, 5));
  CHECK(bearing.at(0.0).damping == matrix_of(5, 0, 0, 5));
  CHECK(bearing.at(30.0).stiffness == matrix_of(5, 6, 7, 8));
  CHECK(bearing.at(40.0).damping == matrix_of(4, 0.5, -0.5, 4));
  CHECK(bearing.at(1e3).damping == matrix_of(0, 1, -1, 0));
  CHECK(bearing.storing().isZero(0.0));
}

TEST_CASE("bearing model: its rows are two displacements across the axis, never rigid") {
  const LoopModel made = make_loop(make_bearing_loop({0, 0, 3}), false);
  REQUIRE(made.rows.size() == 2);
  CHECK(made.rows[0].axis == space::Position(1, 0, 0));
  CHECK(made.rows[1].axis == space::Position(0, 1, 0));
  CHECK(made.bearing->axis == space::Position(0, 0, 1));
  Loop none = make_bearing_loop({0, 0, 1});
  none.matrices->stiffness[0].setZero();
  for (const LoopRow& row : make_loop_rows(none, false)) CHECK_FALSE(row.is_rigid());
  none.matrices.reset();
  for (const LoopRow& row : make_loop_rows(none, false)) CHECK(row.is_rigid());
  CHECK_FALSE(make_loop(none, false).bearing.has_value());
}

}  // namespace
}  // namespace spoke
