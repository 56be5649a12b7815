#include "models/space/beam.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "models/space/symmetric_twist_matrix.h"
#include "tests/models/space/beams.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {
namespace {

SectionProperties offset_section() {
  SectionProperties section{2.0, 3e5, 400.0, 150.0, 20.0, 90.0, 7e4, 5e4, 3e-2, 6e-3, 1e-3};
  section.mass_centre_y = 0.03;
  section.mass_centre_z = -0.02;
  section.tension_centre_y = -0.04;
  section.tension_centre_z = 0.05;
  section.shear_centre_y = 0.02;
  section.shear_centre_z = 0.06;
  return section;
}

}  // namespace

TEST_CASE("centres of a section are where tension does not bend and shear does not twist") {
  const SectionProperties section = offset_section();
  const TwistMatrix C = reduce(section).compliance;
  const auto at = [](double y, double z, const Position& force) {
    return make_twist(force, cross(Position(0.0, y, z), force));
  };
  const Twist stretched =
      C * at(section.tension_centre_y, section.tension_centre_z, {1.0, 0.0, 0.0});
  CHECK(stretched.tail<2>().norm() < 1e-18);
  CHECK(stretched[0] + section.tension_centre_z * stretched[4] ==
        doctest::Approx(1.0 / section.axial_stiffness).epsilon(1e-12));
  const Twist sheared = C * at(section.shear_centre_y, section.shear_centre_z, {0.0, 0.6, -0.8});
  CHECK(std::abs(sheared[3]) < 1e-18);
  CHECK(sheared[1] == doctest::Approx(0.6 / section.shear_stiffness_y).epsilon(1e-12));
  CHECK(sheared[2] == doctest::Approx(-0.8 / section.shear_stiffness_z).epsilon(1e-12));
}

TEST_CASE("properties of a section and its full matrices say the same") {
  const SectionMatrices expected = reduce(offset_section());
  const Eigen::Matrix<double, kTwist, kTwist> compliance = expected.compliance;
  StiffnessAndMass full{compliance.inverse(), {}};
  // The mass matrix of velocities at the reference point.
  const MassMoments& mass = expected.mass;
  TwistMatrix M = TwistMatrix::Zero();
  M.topLeftCorner<3, 3>() = mass.mass * Matrix3::Identity();
  M.bottomLeftCorner<3, 3>() = skew(mass.first);
  M.topRightCorner<3, 3>() = skew(mass.first).transpose();
  M.bottomRightCorner<3, 3>() = mass.second.trace() * Matrix3::Identity() - mass.second;
  full.mass = moments_of(M);
  const SectionMatrices found = reduce(full);
  CHECK((found.compliance - expected.compliance).norm() < 1e-12 * expected.compliance.norm());
  CHECK(found.mass.mass == mass.mass);
  CHECK((found.mass.first - mass.first).norm() == 0.0);
  CHECK((found.mass.second - mass.second).norm() < 1e-15);
  CHECK(found.gyration == doctest::Approx(expected.gyration).epsilon(1e-9));
}

TEST_CASE("a section that is rigid in shear has no shear strain under any force at its centre") {
  SectionProperties section = offset_section();
  section.shear_stiffness_y = section.shear_stiffness_z = 0.0;
  section.shear_centre_y = section.shear_centre_z = 0.0;
  const TwistMatrix C = reduce(section).compliance;
  CHECK(C.middleRows<2>(1).isZero(0.0));
  CHECK(C.middleCols<2>(1).isZero(0.0));
}

TEST_CASE("a bent curve goes smoothly through its points, and straight through points on a line") {
  const std::vector<Position> points{
      {0.0, 0.0, 0.0}, {1.0, 0.1, 0.0}, {1.7, 0.1, 0.3}, {3.0, -0.2, 0.5}};
  const ReferenceCurve curve(points);
  for (const Position& point : points) CHECK((curve.at(point.x()) - point).norm() < 1e-15);
  for (const double x : {0.5, 1.0, 1.3, 1.7, 2.9}) {
    const double h = 1e-5;
    const Position slope = (curve.at(x + h) - curve.at(x - h)) / (2.0 * h);
    CHECK((curve.slope(x) - slope).norm() < 1e-8);
    // The slope is smooth, too, where cubics meet.
    CHECK((curve.slope(x + h) + curve.slope(x - h) - 2.0 * curve.slope(x)).norm() < 1e-8);
  }
  const ReferenceCurve line({{0.0, 0.0, 0.0}, {1.0, 0.2, -0.1}, {3.0, 0.6, -0.3}});
  CHECK((line.at(2.2) - Position(2.2, 0.44, -0.22)).norm() < 1e-15);
  CHECK((line.slope(0.4) - Position(1.0, 0.2, -0.1)).norm() < 1e-15);
}

TEST_CASE("twist turns sections right-handed about the tangent, from the root's axes") {
  Beam beam = make_uniform_beam(offset_section(), 2.0);
  beam.twist = {0.0, 0.8};
  const Matrix3 axes = beam.geometry(1.0).axes.axes;
  const double c = std::cos(0.4), s = std::sin(0.4);
  CHECK((axes.col(0) - Position::UnitX()).norm() < 1e-15);
  CHECK((axes.col(1) - Position(0.0, c, s)).norm() < 1e-15);
  CHECK((axes.col(2) - Position(0.0, -s, c)).norm() < 1e-15);
  beam.curve = ReferenceCurve({{0.0, 0.0, 0.0}, {1.0, 0.1, 0.2}, {2.0, 0.5, 0.3}});
  const SectionAt bent = beam.geometry(0.7);
  CHECK((bent.axes.axes.col(0) - bent.tangent.normalized()).norm() < 1e-15);
  CHECK((bent.axes.axes.transpose() * bent.axes.axes - Matrix3::Identity()).norm() < 1e-14);
}

TEST_CASE("a blade that is cut into bodies has all of its mass, and each small mass once") {
  std::mt19937 random(51);
  Beam beam = make_random_beam({true, true, false}, random);
  const double L = beam.station.back();
  MassMoments moments;
  moments.mass = 0.5;
  beam.masses = {{0.0, moments}, {0.5 * L, moments}, {L, moments}};
  const FlexibleBody whole =
      make_beam_body(beam, equal_stations(0.0, L, 4), ReferenceFrame::clamped, {0, 4});
  const FlexibleBody inner =
      make_beam_body(beam, equal_stations(0.0, 0.5 * L, 2), ReferenceFrame::clamped, {0, 2});
  const FlexibleBody outer =
      make_beam_body(beam, equal_stations(0.5 * L, L, 2), ReferenceFrame::clamped, {0, 2});
  CHECK(inner.mass + outer.mass == doctest::Approx(whole.mass).epsilon(1e-12));
  // First moments about the beam's origin.
  const auto moment = [](const FlexibleBody& body) -> Position {
    return body.mass * body.pose.p + body.pose.R * body.S0;
  };
  CHECK((moment(inner) + moment(outer) - moment(whole)).norm() < 1e-12 * whole.mass * L);
  // The outer body begins where the inner one ends.
  const Position end = inner.pose.p + inner.pose.R * inner.nodes.back();
  CHECK((end - outer.pose.p).norm() < 1e-14);
  const double first = inner.mass, second = outer.mass;
  beam.masses.clear();
  const auto lighter = [&](double from, double to) {
    return make_beam_body(beam, equal_stations(from, to, 2), ReferenceFrame::clamped, {0, 2}).mass;
  };
  CHECK(first - lighter(0.0, 0.5 * L) == doctest::Approx(1.0));
  CHECK(second - lighter(0.5 * L, L) == doctest::Approx(0.5));
}

}  // namespace spoke::space::test
