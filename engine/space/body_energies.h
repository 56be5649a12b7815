#pragma once

// Energies and first moment of a spatial body, for the sensors.

#include "engine/space/body_data.h"
#include "engine/space/section.h"

namespace spoke::space {

/// What the sensors show of a body at a state.
struct BodyEnergies {
  double kinetic = 0.0;           ///< stiffening term included [J]
  double strain = 0.0;            ///< elastic energy 1/2 q^T K q [J]
  double tension = 0.0;           ///< of gravity's tension, g . gamma [J]
  Position S = Position::Zero();  ///< first moment [kg m]
};

/// `twist`: of the body's frame, in it. Uses the memory within kernels of `work`.
BodyEnergies calc_body_energies(const BodyModel& model, const BodyState& state, const Twist& twist,
                                const BodyMotion& motion, const BodyWork& work) noexcept;

/// Elastic energy of a body [J].
double calc_strain_energy(const FlexibleBody& body, const double* q, const BodyWork& work) noexcept;

/// By how much a bent body is shorter along its axis than its coordinates say [m]: 1/2 int (v'^2 +
/// w'^2) dx, of a body with geometric stiffening, whose energies account for it; else 0.
double calc_foreshortening(const BodyModel& model, const double* q, const BodyWork& work) noexcept;
/// The same of the part inboard of a section, and its derivatives.
struct Foreshortening {
  double length = 0.0;        ///< [m]
  double rate = 0.0;          ///< [m/s]
  double acceleration = 0.0;  ///< [m/s^2]
};
Foreshortening calc_foreshortening(const BodyModel& model, const Section& section, const double* q,
                                   const double* v, const double* a, const BodyWork& work) noexcept;

}  // namespace spoke::space
