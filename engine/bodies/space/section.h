#pragma once

// A cross section anywhere on a spatial body: its motion, loads on it, and its stress resultants.

#include <array>
#include <memory>

#include "engine/bodies/space/body_data.h"
#include "models/space/solid.h"

namespace spoke::space {

/// A section, which follows the coordinates (u, th) of the two nodes of its element, in B: its
/// place is s0 + N q, by the field of the slots, and its rotation vector N_th q, whose bending part
/// is the slope of that field.
struct Section {
  int element = 0;
  Position s0 = Position::Zero();  ///< undeformed place of its reference point in B [m]
  Rotation axes;                   ///< undeformed, from the section to B
  ElementShape N = ElementShape::Zero();
  ElementShape N_th = ElementShape::Zero();
  /// Maps the wrench on the element's outer node, in B, to the resultants in the section's axes.
  TwistMatrix W = TwistMatrix::Zero();
  TwistMatrix compliance = TwistMatrix::Zero();  ///< maps resultants to strains, section axes
  double xi = 0.0;  ///< 0 at the inner node of the element, 1 at the outer
  /// Integrals int N'^T N' ds of the element up to the section, for the rise of the outer node
  /// above the inner and the slopes of both: entries 11, 12, 13, 22, 23, 33.
  std::array<double, 6> slopes{};
  /// On a solid: the place that is the section, and its number among those of the solid's
  /// constants; -1: it is none of these, and its tension is not known.
  std::shared_ptr<const SolidPlace> place;
  int place_number = -1;
};

/// Makes the section of a body at a station of its beam [m]. Between two elements, it is that of
/// the inner one.
Section make_section(const Beam& beam, const FlexibleBody& body, double station);

/// Returns the place of a section within its element: 0 at the inner node, 1 at the outer one.
double place_in_element(const FlexibleBody& body, const Section& section) noexcept;

/// Makes a section at a place in the frame of a rigid body [m], which moves with it.
Section make_rigid_section(const Position& place);

/// Makes the section at a place of a solid, by its number among those of its constants, and at a
/// node of its mesh.
Section make_solid_section(const Solid& body, int place);
Section make_node_section(const Solid& body, int node);

/// Returns the motion of a section at the flex vectors q and v, against B: place s0 + N q, rotation
/// exp((N_th q)~).
HandleMotion calc_section_motion(const FlexibleBody& body, const Section& section, const double* q,
                                 const double* v) noexcept;

/// Returns the acceleration of a section less gravity, in B: J (X; q'') + b at the acceleration X
/// and the angular velocity w of B and the flex vector a = q''. `motion`: at the state.
Twist calc_section_acceleration(const FlexibleBody& body, const Section& section,
                                const HandleMotion& motion, const Twist& X, const Angular& w,
                                const double* a) noexcept;

/// Adds a wrench (f, m), in B, on a section that moves as given to a body's terms and rows: Q +=
/// (f, m + s x f), Q_f += N^T f + N_th^T H^T m.
void add_section_wrench(const Section& section, const HandleMotion& motion, const Twist& wrench,
                        BodyTerms& terms, const BodyWork& work) noexcept;

/// Load of a section by the deformation of its element, in its axes: resultants W Phi^-1 G q,
/// strains C^-1 (resultants).
struct SectionLoad {
  Twist resultants;  ///< force and moment of the outer part on the inner [N, N m]
  Twist strains;     ///< (eps, gamma_y, gamma_z, kappa_x, kappa_y, kappa_z) [1, 1/m]
};
SectionLoad calc_section_load(const FlexibleBody& body, const Section& section,
                              const double* q) noexcept;
/// Returns the resultants by the damping of the element and stiffness_factor [s] times its
/// stiffness, at flex vectors q and velocities v.
Twist calc_section_damping(const FlexibleBody& body, const Section& section,
                           double stiffness_factor, const double* q, const double* v) noexcept;
/// Returns the resultants of forces that are the stiffness times a flex vector, to first order.
Twist calc_section_stress(const FlexibleBody& body, const Section& section,
                          const double* flex) noexcept;

}  // namespace spoke::space
