#pragma once

// A body's equation of motion as full matrices, in the coordinates [X; q] (twist components, then
// deformation; in the plane axial before bending): what the paper's two dense formulations work on.
// Handle 0 is the inboard one.

#include <Eigen/Core>
#include <cassert>

#include "engine/bodies/table/body_kind.h"

namespace spoke {

/// Returns the dense Mhat = mass_factor Mff + stiffness_factor K + damping_factor D (nf x nf), D
/// the body's own damping; empty for a rigid body.
Eigen::MatrixXd make_dense_elastic_block(const plane::FlexibleBody& body, double mass_factor,
                                         double stiffness_factor, double damping_factor = 0.0);
/// In space with the damping of sections and modes as well.
inline Eigen::MatrixXd make_dense_elastic_block(const space::Body& body,
                                                const space::BlockFactors& factors) {
  return kind_of(body).make_dense_block(body, factors);
}

/// Unknowns of a body: its frame's twist and its deformation.
inline int dense_size(const plane::FlexibleBody& body) { return kTwist + body.coordinates(); }
inline int dense_size(const space::Body& body) { return space::kTwist + body.coordinates(); }

inline int handle_count(const plane::FlexibleBody&) { return 2; }
inline int handle_count(const space::Body& body) { return body.handle_count(); }

/// Fills the mass matrix of (P 3), `elastic` being its deformation block, into an n x n block.
void calc_dense_mass(const BodyData<Plane>& data, const Eigen::MatrixXd& elastic, bool implicit,
                     Eigen::Ref<Eigen::MatrixXd> mass);
inline void calc_dense_mass(const BodyData<Space>& data, const Eigen::MatrixXd& elastic,
                            bool implicit, Eigen::Ref<Eigen::MatrixXd> mass) {
  assert(mass.rows() == dense_size(*data.model->body) && mass.cols() == mass.rows());
  data.kind->calc_dense_mass(data, elastic, implicit, mass);
}

/// Fills the right-hand side [Q; Q_f] (n).
void calc_dense_force(const BodyData<Plane>& data, Eigen::Ref<Eigen::VectorXd> force);
inline void calc_dense_force(const BodyData<Space>& data, Eigen::Ref<Eigen::VectorXd> force) {
  data.kind->calc_dense_force(data, force);
}

/// Jacobian J (d x n) of a handle's twist with respect to the body's, body frame.
void calc_handle_jacobian(const BodyData<Plane>& data, int handle, Eigen::Ref<Eigen::MatrixXd> J);
inline void calc_handle_jacobian(const BodyData<Space>& data, int handle,
                                 Eigen::Ref<Eigen::MatrixXd> J) {
  assert(handle >= 0 && handle < data.work.port.handles);
  data.kind->calc_handle_jacobian(data, handle, J);
}

/// Acceleration of a handle at zero accelerations, body frame: in the plane [-w^2 s + 2 w B s'; 0],
/// in space b of section 10. `twist`: of the body.
Twist calc_handle_bias(const BodyData<Plane>& data, int handle, const Twist& twist);
inline space::Twist calc_handle_bias(const BodyData<Space>& data, int handle,
                                     const space::Twist& twist) {
  assert(handle >= 0 && handle < data.work.port.handles);
  return data.work.handles[handle].bias(angular(twist));
}

/// Takes [X; q''] (n) apart into `data.X` and the flex vector `a`.
template <class World>
void store_dense_acceleration(const Eigen::Ref<const Eigen::VectorXd>& x, BodyData<World>& data,
                              double* a) {
  assert(x.size() == dense_size(*data.model->body) && a);
  data.X = x.head<World::kTwist>();
  Eigen::Index row = World::kTwist;
  data.layout.for_parts([&](int first, int size) {
    Eigen::Map<Eigen::VectorXd>(a + first, size) = x.segment(row, size);
    row += size;
  });
}

}  // namespace spoke
