// Reduces the properties of a section to compliance and mass about its reference point.

#include "models/space/section_matrices.h"

#include <Eigen/Dense>
#include <array>
#include <cassert>
#include <cmath>

namespace spoke::space {
namespace {

double inverse_or_zero(double value) { return value > 0.0 ? 1.0 / value : 0.0; }

/// The map to strains at the centres (of tension: eps; of shear: gamma) from strains at the
/// reference point.
TwistMatrix strains_at_centres(const SectionProperties& section) {
  TwistMatrix T = TwistMatrix::Identity();
  T(0, 4) = section.tension_centre_z;
  T(0, 5) = -section.tension_centre_y;
  T(1, 3) = -section.shear_centre_z;
  T(2, 3) = section.shear_centre_y;
  return T;
}

TwistMatrix compliance_at_centres(const SectionProperties& section) {
  TwistMatrix F = TwistMatrix::Zero();
  F(0, 0) = 1.0 / section.axial_stiffness;
  F(1, 1) = inverse_or_zero(section.shear_stiffness_y);
  F(2, 2) = inverse_or_zero(section.shear_stiffness_z);
  F(3, 3) = 1.0 / section.torsion_stiffness;
  Eigen::Matrix2d bending;
  bending << section.flap_stiffness, -section.product_stiffness, -section.product_stiffness,
      section.lag_stiffness;
  F.bottomRightCorner<2, 2>() = bending.inverse();
  return F;
}

MassMoments mass_of(const SectionProperties& section) {
  const Position centre(0.0, section.mass_centre_y, section.mass_centre_z);
  MassMoments mass;
  mass.mass = section.mass_per_length;
  mass.first = mass.mass * centre;
  mass.second << 0.0, 0.0, 0.0,  //
      0.0, section.lag_inertia, section.product_inertia, 0.0, section.product_inertia,
      section.flap_inertia;
  mass.second += mass.mass * centre * centre.transpose();
  return mass;
}

}  // namespace

SectionMatrices reduce(const SectionProperties& section) {
  assert(section.axial_stiffness > 0.0 && section.torsion_stiffness > 0.0);
  assert(section.lag_stiffness > 0.0 && section.flap_stiffness > 0.0);
  // The inverse of T, which is 1 plus a nilpotent matrix, is 2 - T.
  const TwistMatrix T_inverse = 2.0 * TwistMatrix::Identity() - strains_at_centres(section);
  SectionMatrices reduced;
  reduced.compliance = T_inverse * compliance_at_centres(section) * T_inverse.transpose();
  reduced.mass = mass_of(section);
  reduced.gyration = (section.lag_stiffness + section.flap_stiffness) / section.axial_stiffness +
                     section.tension_centre_y * section.tension_centre_y +
                     section.tension_centre_z * section.tension_centre_z;
  return reduced;
}

SectionMatrices reduce(const StiffnessAndMass& section) {
  const TwistMatrix& C = section.stiffness;
  const Eigen::Matrix<double, kTwist, kTwist> identity = TwistMatrix::Identity();
  SectionMatrices reduced;
  reduced.compliance = Eigen::Matrix<double, kTwist, kTwist>(C).llt().solve(identity);
  reduced.mass = section.mass;
  reduced.gyration = (C(4, 4) + C(5, 5)) / C(0, 0);
  return reduced;
}

TensionCentre find_tension_centre(const SectionMatrices& section) {
  // Resultants F_x, M_x, M_y, M_z, no shear forces: stiffness of their strains.
  constexpr int kAt[] = {0, 3, 4, 5};
  Eigen::Matrix4d compliance;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) compliance(i, j) = section.compliance(kAt[i], kAt[j]);
  const Eigen::Matrix4d S = compliance.inverse();
  const double y = -S(0, 3) / S(0, 0), z = S(0, 2) / S(0, 0);
  return {y, z, (S(2, 2) + S(3, 3)) / S(0, 0) - (y * y + z * z)};
}

double gyration_about_shear_centre(const SectionMatrices& section) {
  const TwistMatrix& C = section.compliance;
  const TensionCentre at = find_tension_centre(section);
  // In-plane displacement of the reference point, and from it of the tension centre, per twist.
  const double along_y = C(1, 3) / C(3, 3) - at.z, along_z = C(2, 3) / C(3, 3) + at.y;
  return at.gyration + along_y * along_y + along_z * along_z;
}

MassMoments moments_of(const TwistMatrix& mass) {
  assert(mass(0, 0) > 0.0);
  // S_x = 0, and the same mass in all directions.
  assert(mass(4, 2) == 0.0 && mass(5, 1) == 0.0 && mass(1, 1) == mass(0, 0));
  MassMoments moments;
  moments.mass = mass(0, 0);
  moments.first = Position(0.0, mass(3, 2), -mass(3, 1));
  moments.second << 0.0, 0.0, 0.0,  //
      0.0, mass(5, 5), -mass(4, 5), 0.0, -mass(4, 5), mass(4, 4);
  return moments;
}

namespace {

/// The numbers of a section, of which all are linear between stations.
constexpr std::array kProperties{
    &SectionProperties::mass_per_length,   &SectionProperties::axial_stiffness,
    &SectionProperties::lag_stiffness,     &SectionProperties::flap_stiffness,
    &SectionProperties::product_stiffness, &SectionProperties::torsion_stiffness,
    &SectionProperties::shear_stiffness_y, &SectionProperties::shear_stiffness_z,
    &SectionProperties::lag_inertia,       &SectionProperties::flap_inertia,
    &SectionProperties::product_inertia,   &SectionProperties::mass_centre_y,
    &SectionProperties::mass_centre_z,     &SectionProperties::tension_centre_y,
    &SectionProperties::tension_centre_z,  &SectionProperties::shear_centre_y,
    &SectionProperties::shear_centre_z};
static_assert(sizeof(SectionProperties) == kProperties.size() * sizeof(double));

}  // namespace

SectionProperties interpolate(const SectionProperties& a, const SectionProperties& b, double t) {
  SectionProperties between;
  for (const auto property : kProperties)
    between.*property = a.*property + t * (b.*property - a.*property);
  return between;
}

StiffnessAndMass interpolate(const StiffnessAndMass& a, const StiffnessAndMass& b, double t) {
  return {a.stiffness + t * (b.stiffness - a.stiffness),
          {a.mass.mass + t * (b.mass.mass - a.mass.mass),
           a.mass.first + t * (b.mass.first - a.mass.first),
           a.mass.second + t * (b.mass.second - a.mass.second)}};
}

TwistMatrix damped_compliance(const TwistMatrix& compliance, const Twist& factors) {
  assert(factors.minCoeff() >= 0.0);
  using Matrix = Eigen::Matrix<double, kTwist, kTwist>;
  // Without couplings each strain has its factor, to the last bit: the zeros of decoupled bodies
  // stay zeros.
  if (const Twist own = compliance.diagonal(); compliance == TwistMatrix(own.asDiagonal()))
    return TwistMatrix(factors.cwiseProduct(own).asDiagonal());
  // A section that is rigid in shear has no stiffness matrix: any generalised inverse G, with F G F
  // = F, stands for it. It is taken of F scaled to a unit diagonal, whose rank shows.
  Twist scale = Twist::Ones();
  for (int i = 0; i < kTwist; ++i)
    if (compliance(i, i) > 0.0) scale[i] = 1.0 / std::sqrt(compliance(i, i));
  const Matrix scaled = scale.asDiagonal() * compliance * scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
  decomposition.setThreshold(1e-10);
  decomposition.compute(scaled);
  const Matrix stiffness =
      scale.asDiagonal() * Matrix(decomposition.pseudoInverse()) * scale.asDiagonal();
  const Twist root = factors.cwiseSqrt();
  return compliance * root.asDiagonal() * stiffness * root.asDiagonal() * compliance;
}

}  // namespace spoke::space
