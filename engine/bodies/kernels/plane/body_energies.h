#pragma once

// Energies and first moment of a body, for the sensors.

#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Energies and first moment of a body at the state in the table, for the sensors.
struct BodyEnergies {
  double kinetic = 0.0;           ///< stiffening term included [J]
  double strain = 0.0;            ///< elastic energy [J]
  Position S = Position::Zero();  ///< first moment S0 + S qf [kg m]
};

/// Calculates them. `twist`: of the body's frame, body frame; `hub_speed`: w0, for the centrifugal
/// stiffening [rad/s].
BodyEnergies calc_body_energies(const BodyData<Plane>& data, const Twist& twist,
                                double hub_speed) noexcept;

/// Returns the elastic energy of a body [J].
double calc_strain_energy(const BodyData<Plane>& data) noexcept;

}  // namespace spoke::plane
