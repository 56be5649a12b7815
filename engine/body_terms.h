#pragma once

#include "engine/step_data.h"

namespace spoke {

/// What a body's terms depend on besides its deformation.
struct BodyMotion {
  double speed = 0.0;      ///< angular velocity w of the body frame [rad/s]
  double hub_speed = 0.0;  ///< w0, for the centrifugal stiffening [rad/s]
};

/// Calculates the state-dependent mass terms and the right-hand side of a body, (P 3), with its
/// damping: terms, c_theta and Q_f of `data` (docs/formulation.md, section 2). Elastic and damping
/// forces are taken at q_elastic and v_elastic. Without loads.
void calc_body_terms(const BodyMotion& motion, const Damping& damping, BodyData& data) noexcept;

/// Adds the body's point loads at time `t` [s] to its right-hand side, and their power.
/// R_HB: body frame to hub frame; R_0: hub frame to inertial frame; `twist`: of the body frame.
void add_loads(double t, const Rotation& R_HB, const Twist& twist, const Rotation& R_0,
               BodyData& data) noexcept;

/// State-dependent entries of the mass matrix.
struct BodyInertia {
  Position S;                         ///< S0 + S qf [kg m]
  double rotary_inertia = 0.0;        ///< M_ww [kg m^2]
  double rotation_deformation = 0.0;  ///< M_wf qf' [kg m^2/s]
  double centrifugal_inertia = 0.0;   ///< qf^T KG qf [kg m^2]
};

/// The same entries as calc_body_terms finds, from the body's coordinates alone.
BodyInertia calc_inertia(const BodyData& data);

/// Kinetic energy of a body, stiffening term included [J]. `twist`: of its frame, body frame.
double calc_kinetic_energy(const BodyData& data, const BodyInertia& inertia, const Twist& twist,
                           double hub_speed);

/// Elastic energy 1/2 qf^T K qf [J].
double calc_strain_energy(const BodyData& data);

}  // namespace spoke
