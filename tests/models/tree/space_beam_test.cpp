#include "models/tree/space_beam.h"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "tests/models/reader/spatial_texts.h"

using doctest::Approx;
using namespace spoke;
using spoke::spatial::make_space_beam;
using spoke::test::kBladeText;

namespace {

spatial::Beam beam_of(const std::string& text) {
  return parse_scenario(text, "f.toml").space->blades.at(0).beam;
}

/// Makes a blade with offsets, shear and inertias.
spatial::Beam general_blade() {
  spatial::Beam beam = beam_of(kBladeText);
  spatial::Sections& s = beam.sections;
  s.mass_center = {{0.1, 0.02}, {0.05, 0.0}, {0.0, -0.03}};
  s.tension_center = {{0.05, 0.0}, {0.04, 0.01}, {0.0, 0.0}};
  s.shear_center = {{-0.02, 0.0}, {0.0, 0.03}, {0.0, 0.0}};
  s.flap_inertia = {0.3, 0.2, 0.1};
  s.lag_inertia = {3.0, 2.0, 1.0};
  s.lag_shear_stiffness = {3e6, 2e6, 1e6};
  s.flap_shear_stiffness = {2e6, 1.5e6, 5e5};
  return beam;
}

void check_equal(const space::MassMoments& a, const space::MassMoments& b) {
  CHECK(a.mass == Approx(b.mass).epsilon(1e-14));
  CHECK((a.first - b.first).norm() <= 1e-14);
  CHECK((a.second - b.second).norm() <= 1e-14);
}

/// Returns the 6 x 6 mass matrix of moments.
spatial::SectionMatrix matrix_of(const space::MassMoments& m) {
  spatial::SectionMatrix matrix = spatial::SectionMatrix::Zero();
  matrix.topLeftCorner<3, 3>() = m.mass * space::Matrix3::Identity();
  matrix.topRightCorner<3, 3>() = -space::skew(m.first);
  matrix.bottomLeftCorner<3, 3>() = space::skew(m.first);
  matrix.bottomRightCorner<3, 3>() = m.second.trace() * space::Matrix3::Identity() - m.second;
  return matrix;
}

}  // namespace

TEST_CASE("a beam keeps its stations, values and twist") {
  const space::Beam beam = make_space_beam(
      general_blade(), {.flap = 0.5, .lag = 0.6, .torsion = 0.25, .lag_shear = 0.1});
  CHECK(beam.station == std::vector<double>{0.0, 3.0, 8.0});
  CHECK(beam.twist_at(1.5) == Approx(0.15));
  REQUIRE(beam.properties.size() == 3);
  CHECK(beam.properties[1].axial_stiffness == 2e7);
  CHECK(beam.properties[1].lag_stiffness == 2e4);
  CHECK(beam.properties[1].shear_stiffness_z == 1.5e6);
  CHECK(beam.properties[1].tension_centre_z == 0.01);
  CHECK(beam.properties[1].shear_centre_z == 0.03);
  CHECK(beam.properties[2].mass_centre_z == -0.03);
  CHECK(beam.matrices.empty());
  CHECK(beam.curve.is_straight());
  // By stretch, shear along y and z, twist, and curvature about y, which is flap, and z, lag.
  const std::vector<double> factors(beam.damping.begin(), beam.damping.end());
  CHECK(factors == std::vector<double>{0.0, 0.1, 0.5, 0.25, 0.5, 0.6});
}

TEST_CASE("without inertias of sections those of one material follow from the stiffnesses") {
  const space::Beam beam = make_space_beam(beam_of(kBladeText));
  CHECK(beam.properties[0].flap_inertia == Approx(3.0 * 3e3 / 3e7));
  CHECK(beam.properties[2].lag_inertia == Approx(1.0 * 1e4 / 1e7));
  CHECK(beam.properties[0].shear_stiffness_y == 0.0);
}

TEST_CASE("matrices of mass, of stiffness, or of both, are the same sections as their values") {
  const spatial::Beam values = general_blade();
  const space::Beam made = make_space_beam(values);
  spatial::Beam by_mass = values, by_stiffness = values;
  for (const double x : values.sections.station) {
    const space::SectionMatrices section = made.section(x);
    by_mass.sections.mass_6x6.push_back(matrix_of(section.mass));
    const Eigen::Matrix<double, 6, 6> compliance = section.compliance;
    by_stiffness.sections.stiffness_6x6.push_back(compliance.inverse());
  }
  spatial::Beam by_both = by_stiffness;
  by_both.sections.mass_6x6 = by_mass.sections.mass_6x6;
  for (const spatial::Beam& beam : {by_mass, by_stiffness, by_both}) {
    const space::Beam other = make_space_beam(beam);
    for (const double x : values.sections.station) {
      check_equal(other.section(x).mass, made.section(x).mass);
      CHECK(other.section(x).compliance.isApprox(made.section(x).compliance, 1e-11));
    }
  }
}

TEST_CASE("a point mass is told in the axes of its section") {
  spatial::Beam beam = general_blade();
  const spatial::PointMass point{
      3.0, 2.0, {0.1, 0.2, 0.3}, spatial::Vector(1.0, 2.0, 2.5).asDiagonal()};
  beam.point_masses = {point};
  const space::Beam made = make_space_beam(beam);
  const space::Rotation axes = made.geometry(3.0).axes;
  const space::MassMoments& moments = made.masses.at(0).moments;
  CHECK((axes * moments.first).isApprox(2.0 * point.offset, 1e-14));
  const spatial::Tensor about_axis = moments.second.trace() * spatial::Tensor::Identity() -
                                     axes.axes * moments.second * axes.axes.transpose();
  const spatial::Tensor expected =
      point.inertia + 2.0 * (point.offset.squaredNorm() * spatial::Tensor::Identity() -
                             point.offset * point.offset.transpose());
  CHECK(about_axis.isApprox(expected, 1e-14));
}
