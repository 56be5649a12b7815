#pragma once

// Properties of a cross section of a beam, in its own axes and about its reference point:
// compliance and mass per length. Axis 1 is the section's normal, 2 and 3 lie in the section.

#include <Eigen/Core>

#include "models/space/vectors.h"

namespace spoke::space {

/// Mass, first and second moment of a section (per length), or of a small rigid mass, about its
/// reference point.
struct MassMoments {
  double mass = 0.0;                  ///< mass [kg/m] or [kg]
  Position first = Position::Zero();  ///< int r dm [kg] or [kg m]
  Matrix3 second = Matrix3::Zero();   ///< int r r^T dm [kg m] or [kg m^2]

  bool operator==(const MassMoments&) const = default;
};

/// Properties of a section by which engineers describe a blade. y and z are its axes 2 and 3; the
/// offsets lead from the reference point. Each is linear between stations.
struct SectionProperties {
  double mass_per_length = 0.0;    ///< m [kg/m]
  double axial_stiffness = 0.0;    ///< EA [N]
  double lag_stiffness = 0.0;      ///< EIz, for bending that moves the blade along y [N m^2]
  double flap_stiffness = 0.0;     ///< EIy, for bending that moves it along z [N m^2]
  double product_stiffness = 0.0;  ///< EIyz = E int y z dA about the tension centre [N m^2]
  double torsion_stiffness = 0.0;  ///< GJ [N m^2]
  double shear_stiffness_y = 0.0;  ///< GA along y [N]; 0: rigid in shear along y
  double shear_stiffness_z = 0.0;  ///< GA along z [N]; 0: rigid in shear along z
  double lag_inertia = 0.0;        ///< int y^2 dm about the mass centre [kg m]
  double flap_inertia = 0.0;       ///< int z^2 dm about the mass centre [kg m]
  double product_inertia = 0.0;    ///< int y z dm about the mass centre [kg m]
  double mass_centre_y = 0.0, mass_centre_z = 0.0;        ///< [m]
  double tension_centre_y = 0.0, tension_centre_z = 0.0;  ///< place where tension does not bend [m]
  double shear_centre_y = 0.0, shear_centre_z = 0.0;      ///< place where shear does not twist [m]

  bool operator==(const SectionProperties&) const = default;
};

/// Full matrices of a section: stiffness of the strains (eps, gamma_y, gamma_z, kappa_x, kappa_y,
/// kappa_z), the resultants being (F_x, F_y, F_z, M_x, M_y, M_z), and mass. Each entry is linear
/// between stations.
struct StiffnessAndMass {
  TwistMatrix stiffness = TwistMatrix::Zero();  ///< [N, N m, N m^2]
  MassMoments mass;

  bool operator==(const StiffnessAndMass&) const = default;
};

/// The common form to which both are reduced.
struct SectionMatrices {
  /// Strains per resultants; zero where rigid in shear.
  TwistMatrix compliance = TwistMatrix::Zero();
  MassMoments mass;
  /// (EIy + EIz)/EA about the reference point [m^2]: torsional stiffness per tension.
  double gyration = 0.0;
};

SectionMatrices reduce(const SectionProperties& section);
SectionMatrices reduce(const StiffnessAndMass& section);

/// The place of a section where tension does not bend.
struct TensionCentre {
  double y = 0.0, z = 0.0;  ///< from the reference point, section axes [m]
  double gyration = 0.0;    ///< (EIy + EIz)/EA about it [m^2]
};
TensionCentre find_tension_centre(const SectionMatrices& section);

/// Returns (EIy + EIz)/EA about the tension centre, and the square of its distance from the shear
/// centre [m^2]: how far the fibres are from the axis about which torsion turns them.
double gyration_about_shear_centre(const SectionMatrices& section);

/// Returns the moments that a section's mass matrix holds (order x, y, z, about x, y, z).
/// Precondition: the section is thin, [m 1, -S~; S~, Theta] with S_x = 0.
MassMoments moments_of(const TwistMatrix& mass);

/// Returns (1 - t) a + t b, number by number.
SectionProperties interpolate(const SectionProperties& a, const SectionProperties& b, double t);
StiffnessAndMass interpolate(const StiffnessAndMass& a, const StiffnessAndMass& b, double t);

/// Returns C^-1 C_D C^-1 from the compliance, with the damping C_D by one factor mu [s] per strain,
/// C_D = mu^1/2 C mu^1/2 and C the stiffness.
TwistMatrix damped_compliance(const TwistMatrix& compliance, const Twist& factors);

}  // namespace spoke::space
