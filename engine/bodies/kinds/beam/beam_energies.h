#pragma once

// Energies and first moment of a beam in space, for the sensors.

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/body_energies.h"
#include "engine/bodies/space/section.h"

namespace spoke::space {

/// Calculates energies and first moment:
///   T = 1/2 m v0^2 + v0.(w x S + S') + 1/2 w.Theta w + sum (w.(rho x mu') + 1/2 rho'.mu')
///       - 1/2 w0^T Lambda w0
///   V = 1/2 q^T K q + g.gamma
/// `twist`: of the body's frame, in it. Uses the memory within kernels of `work`.
BodyEnergies calc_body_energies(const BodyModel& model, const BodyState& state, const Twist& twist,
                                const BodyMotion& motion, const BodyWork& work) noexcept;

/// Returns the elastic energy of a body [J].
double calc_strain_energy(const FlexibleBody& body, const double* q, const BodyWork& work) noexcept;

/// Returns by how much a bent body is shorter along its axis than its coordinates say [m]: 1/2 int
/// (v'^2 + w'^2) dx, for a body with geometric stiffening, whose energies account for it; else 0.
double calc_foreshortening(const BodyModel& model, const double* q, const BodyWork& work) noexcept;
/// Foreshortening of the part inboard of a section, and its derivatives.
struct Foreshortening {
  double length = 0.0;        ///< [m]
  double rate = 0.0;          ///< [m/s]
  double acceleration = 0.0;  ///< [m/s^2]
};
Foreshortening calc_foreshortening(const BodyModel& model, const Section& section, const double* q,
                                   const double* v, const double* a, const BodyWork& work) noexcept;

}  // namespace spoke::space
