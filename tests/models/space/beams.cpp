#include "tests/models/space/beams.h"

#include <Eigen/Dense>
#include <cmath>

namespace spoke::space::test {
namespace {

double draw(std::mt19937& random, double from, double to) {
  return std::uniform_real_distribution(from, to)(random);
}

/// Draws a positive definite matrix that couples everything, in the given sizes.
TwistMatrix draw_stiffness(const Twist& sizes, std::mt19937& random) {
  TwistMatrix L = TwistMatrix::Identity();
  for (int i = 0; i < kTwist; ++i)
    for (int j = 0; j < i; ++j) L(i, j) = draw(random, -0.3, 0.3);
  const Twist root = sizes.cwiseSqrt();
  return root.asDiagonal() * (L * L.transpose()) * root.asDiagonal();
}

SectionProperties draw_properties(double size, std::mt19937& random) {
  SectionProperties section;
  section.mass_per_length = size * draw(random, 2.0, 3.0);
  section.axial_stiffness = size * draw(random, 2e5, 3e5);
  section.lag_stiffness = size * draw(random, 300.0, 400.0);
  section.flap_stiffness = size * draw(random, 100.0, 150.0);
  section.product_stiffness = size * draw(random, -30.0, 30.0);
  section.torsion_stiffness = size * draw(random, 80.0, 120.0);
  section.shear_stiffness_y = size * draw(random, 5e4, 9e4);
  section.shear_stiffness_z = size * draw(random, 5e4, 9e4);
  section.lag_inertia = size * draw(random, 2e-2, 4e-2);
  section.flap_inertia = size * draw(random, 4e-3, 9e-3);
  section.product_inertia = size * draw(random, -2e-3, 2e-3);
  for (double SectionProperties::*offset :
       {&SectionProperties::mass_centre_y, &SectionProperties::mass_centre_z,
        &SectionProperties::tension_centre_y, &SectionProperties::tension_centre_z,
        &SectionProperties::shear_centre_y, &SectionProperties::shear_centre_z})
    section.*offset = draw(random, -0.06, 0.06);
  return section;
}

StiffnessAndMass draw_matrices(double size, std::mt19937& random) {
  Twist sizes;
  sizes << 3e5, 8e4, 6e4, 100.0, 120.0, 350.0;
  return {draw_stiffness(size * sizes, random), reduce(draw_properties(size, random)).mass};
}

}  // namespace

Beam make_uniform_beam(const SectionProperties& section, double length) {
  Beam beam;
  beam.station = {0.0, length};
  beam.properties = {section, section};
  return beam;
}

Beam make_random_beam(const BeamOptions& options, std::mt19937& random) {
  const double L = draw(random, 2.0, 4.0);
  Beam beam;
  for (const double part : {0.0, 0.37, 0.71, 1.0}) {
    beam.station.push_back(part * L);
    const double size = 1.0 - 0.5 * part;
    if (options.has_matrices)
      beam.matrices.push_back(draw_matrices(size, random));
    else
      beam.properties.push_back(draw_properties(size, random));
    beam.twist.push_back(1.3 * part + draw(random, -0.1, 0.1));
  }
  if (options.is_bent)
    beam.curve = ReferenceCurve({{0.0, 0.0, 0.0},
                                 {0.45 * L, draw(random, -0.03, 0.03) * L, 0.05 * L},
                                 {L, 0.05 * L, L / 6.0}});
  if (options.has_masses) {
    MassMoments moments;
    moments.mass = draw(random, 0.3, 0.6);
    moments.first = moments.mass * Position(0.02, -0.03, 0.01);
    moments.second = Matrix3::Identity() * 2e-3;
    moments.second(0, 1) = moments.second(1, 0) = 5e-4;
    beam.masses = {{0.55 * L, moments}, {L, moments}};
  }
  return beam;
}

std::vector<double> make_unequal_stations(const Beam& beam, int elements, std::mt19937& random) {
  std::vector<double> stations{0.0};
  for (int e = 0; e < elements; ++e) stations.push_back(stations.back() + draw(random, 1.0, 2.0));
  for (double& x : stations) x *= beam.station.back() / stations.back();
  stations.back() = beam.station.back();
  return stations;
}

Eigen::MatrixXd to_dense(const FlexibleBody& body, const BlockTridiagonal& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(body.coordinates(), body.coordinates());
  const auto fill = [&](int a, int b, const TwistMatrix& block) {
    for (int i = 0; i < kTwist; ++i)
      for (int j = 0; j < kTwist; ++j) {
        const int row = body.coordinate(a, i), column = body.coordinate(b, j);
        if (row >= 0 && column >= 0) dense(row, column) = block(i, j);
      }
  };
  for (int k = 0; k < body.node_count(); ++k) {
    fill(k, k, matrix.diagonal[static_cast<std::size_t>(k)]);
    if (k == body.elements) break;
    const TwistMatrix& below = matrix.below[static_cast<std::size_t>(k)];
    fill(k + 1, k, below);
    fill(k, k + 1, below.transpose());
  }
  return dense;
}

}  // namespace spoke::space::test
