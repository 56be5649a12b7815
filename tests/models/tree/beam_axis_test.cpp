#include "models/tree/beam_axis.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

using doctest::Approx;
using namespace spoke::spatial;

namespace {

bool is_rotation(const Tensor& R) {
  return R.isUnitary(1e-13) && std::abs(R.determinant() - 1.0) < 1e-13;
}

}  // namespace

TEST_CASE("the smallest rotation turns one direction into the other about what is normal to both") {
  const Vector from(1.0, 2.0, -0.5), to(-0.3, 1.0, 4.0);
  const Tensor R = smallest_rotation(from, to);
  CHECK(is_rotation(R));
  CHECK((R * from.normalized()).isApprox(to.normalized(), 1e-14));
  Vector normal(from.y() * to.z() - from.z() * to.y(), from.z() * to.x() - from.x() * to.z(),
                from.x() * to.y() - from.y() * to.x());
  CHECK((R * normal).isApprox(normal, 1e-13));
  CHECK(smallest_rotation(from, 3.0 * from).isApprox(Tensor::Identity(), 1e-14));
}

TEST_CASE("opposite directions are half a turn apart, about x where that is across") {
  const Tensor down = smallest_rotation(Vector::UnitZ(), -Vector::UnitZ());
  CHECK(is_rotation(down));
  CHECK((down * Vector::UnitZ()).isApprox(-Vector::UnitZ(), 1e-15));
  CHECK((down * Vector::UnitX()).isApprox(Vector::UnitX(), 1e-15));
  const Tensor back = smallest_rotation(Vector::UnitX(), -Vector::UnitX());
  CHECK(is_rotation(back));
  CHECK((back * Vector::UnitX()).isApprox(-Vector::UnitX(), 1e-15));
}

TEST_CASE("twist turns the section's y towards z") {
  Sections sections;
  sections.station = {0.0, 2.0};
  sections.twist = {0.0, std::numbers::pi};
  const BeamAxis axis(sections);
  CHECK((axis.axes(1.0) * Vector::UnitY()).isApprox(Vector::UnitZ(), 1e-15));
  CHECK((axis.axes(1.0) * Vector::UnitX()).isApprox(Vector::UnitX(), 1e-15));
  CHECK(axis.place(1.5) == Vector(1.5, 0.0, 0.0));
  CHECK(axis.stretch(1.5) == 1.0);
}

TEST_CASE("an axis that is not straight goes through its points, and sections are normal to it") {
  Sections sections;
  sections.station = {0.0, 1.0, 3.0};
  sections.sweep = {0.0, 0.2, 0.9};
  sections.prebend = {0.0, -0.1, -0.4};
  sections.twist = {0.3, 0.2, 0.1};
  const BeamAxis axis(sections);
  CHECK(axis.place(1.0).isApprox(Vector(1.0, 0.2, -0.1), 1e-15));
  CHECK(axis.place(3.0).isApprox(Vector(3.0, 0.9, -0.4), 1e-15));
  const double h = 1e-6;
  const Vector along = (axis.place(2.0 + h) - axis.place(2.0 - h)) / (2.0 * h);
  CHECK(axis.stretch(2.0) == Approx(along.norm()).epsilon(1e-9));
  CHECK((axis.axes(2.0) * Vector::UnitX()).isApprox(along.normalized(), 1e-8));
  CHECK(is_rotation(axis.axes(2.0)));
}
