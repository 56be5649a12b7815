#pragma once

// A body's equation of motion as full matrices, in the coordinates [X; qf] (twist components, then
// deformation, axial before bending): what the paper's two dense formulations work on.

#include <Eigen/Core>

#include "engine/table/step_data.h"

namespace spoke {

/// Dense Mhat = mass_factor Mff + stiffness_factor K (nf x nf).
Eigen::MatrixXd make_dense_elastic_block(const FlexibleBody& body, double mass_factor,
                                         double stiffness_factor);

/// Unknowns of a body: its frame's twist and its deformation.
inline int dense_size(const FlexibleBody& body) { return kTwist + body.coordinates(); }

/// Fills the mass matrix of (P 3), `elastic` being its deformation block, into an n x n block.
void calc_dense_mass(const BodyData<Plane>& data, const Eigen::MatrixXd& elastic,
                     Eigen::Ref<Eigen::MatrixXd> mass);

/// Fills the right-hand side [Q; Q_f] (n).
void calc_dense_force(const BodyData<Plane>& data, Eigen::Ref<Eigen::VectorXd> force);

/// Jacobians J (d x n) of the handles' twists with respect to the body's, body frame.
void calc_inboard_jacobian(const BodyData<Plane>& data, Eigen::Ref<Eigen::MatrixXd> J);
void calc_outboard_jacobian(const BodyData<Plane>& data, Eigen::Ref<Eigen::MatrixXd> J);

/// Acceleration of the outboard handle at zero accelerations, [-w^2 s + 2 w B s'; 0], body frame.
/// The inboard handle, at the origin, has none.
Twist calc_outboard_bias(const BodyData<Plane>& data, double speed);

/// Takes [X; qf''] (n) apart into `data.X` and the flex vector `a`.
void store_dense_acceleration(const Eigen::Ref<const Eigen::VectorXd>& x, BodyData<Plane>& data,
                              double* a);

}  // namespace spoke
