#pragma once

// A spatial body's equation of motion as full matrices, in the coordinates [X; q] (twist
// components, then the flex vector): what the paper's two dense formulations work on.

#include <Eigen/Core>

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Returns the dense Mhat (nf x nf).
Eigen::MatrixXd make_dense_elastic_block(const FlexibleBody& body, const BlockFactors& factors);

Eigen::MatrixXd make_dense_elastic_block(const Solid& body, const BlockFactors& factors);

/// Takes a symmetric matrix of shifted coordinates to one of the body's own: S^-T dense S^-1.
void shift_dense(const FlexibleBody& body, const ImplicitShift& shift,
                 Eigen::Ref<Eigen::MatrixXd> dense);

/// Adds a matrix over the nodes to a dense one of the deformation (nf x nf).
void add_dense(const FlexibleBody& body, const BlockTridiagonal& matrix,
               Eigen::Ref<Eigen::MatrixXd> dense);

/// Unknowns of a body: its frame's twist and its deformation.
inline int dense_size(const FlexibleBody& body) { return kTwist + body.coordinates(); }
inline int dense_size(const Solid& body) { return kTwist + body.coordinates(); }

/// Fills the mass matrix [M_RR, C; C^T, Mff], `elastic` being its deformation block, into an n x n
/// block.
void calc_dense_mass(const FlexibleBody& body, const BodyTerms& terms, const BodyWork& work,
                     const Eigen::MatrixXd& elastic, Eigen::Ref<Eigen::MatrixXd> mass);

void calc_dense_mass(const Solid& body, const BodyTerms& terms, const BodyWork& work,
                     const Eigen::MatrixXd& elastic, Eigen::Ref<Eigen::MatrixXd> mass);

/// Fills the right-hand side [Q; Q_f] (n).
void calc_dense_force(const FlexibleBody& body, const BodyTerms& terms, const BodyWork& work,
                      Eigen::Ref<Eigen::VectorXd> force);
void calc_dense_force(const Solid& body, const BodyTerms& terms, const BodyWork& work,
                      Eigen::Ref<Eigen::VectorXd> force);

/// Jacobian J (6 x n) of a handle's twist with respect to the body's.
void calc_handle_jacobian(const FlexibleBody& body, int handle, const BodyWork& work,
                          Eigen::Ref<Eigen::MatrixXd> J);
void calc_handle_jacobian(const Solid& body, int handle, const BodyWork& work,
                          Eigen::Ref<Eigen::MatrixXd> J);

}  // namespace spoke::space
