// Assembles the dense matrices of planar bodies from the table's banded and symmetric parts.

#include "engine/bodies/kernels/dense_body.h"

#include <cassert>

#include "engine/bodies/kernels/plane/handle_motion.h"

namespace spoke {
namespace {

using ConstVector = Eigen::Map<const Eigen::VectorXd>;

ConstVector axial(const double* flex, const BodyData<Plane>& data) {
  return {flex + data.layout.u(), data.layout.axial};
}
ConstVector bending(const double* flex, const BodyData<Plane>& data) {
  return {flex + data.layout.v(), data.layout.bending};
}

}  // namespace

Eigen::MatrixXd make_dense_elastic_block(const plane::FlexibleBody& body, double mass_factor,
                                         double stiffness_factor, double damping_factor) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(body.coordinates(), body.coordinates());
  dense.topLeftCorner(body.axial(), body.axial()) =
      mass_factor * body.M_axial.to_dense() +
      (stiffness_factor + damping_factor * body.damping.axial) * body.K_axial.to_dense();
  dense.bottomRightCorner(body.bending(), body.bending()) =
      mass_factor * body.M_bending.to_dense() +
      (stiffness_factor + damping_factor * body.damping.bending) * body.K_bending.to_dense();
  return dense;
}

void calc_dense_mass(const BodyData<Plane>& data, const Eigen::MatrixXd& elastic, bool implicit,
                     Eigen::Ref<Eigen::MatrixXd> mass) {
  assert(mass.rows() == dense_size(*data.model->body) && mass.cols() == mass.rows());
  assert(elastic.rows() == data.model->body->coordinates());
  const plane::FlexibleBody& body = *data.model->body;
  const int nf = body.coordinates();
  mass.topLeftCorner<kTwist, kTwist>() << body.mass, 0.0, -data.terms.S.y(),  //
      0.0, body.mass, data.terms.S.x(),                                       //
      -data.terms.S.y(), data.terms.S.x(), data.terms.rotary_inertia;
  auto C = mass.topRightCorner(kTwist, nf);
  C.row(0) << body.S_axial.head(body.axial()).transpose(), Eigen::RowVectorXd::Zero(body.bending());
  C.row(1) << Eigen::RowVectorXd::Zero(body.axial()), body.S_bending.transpose();
  C.row(2) << axial(data.c_theta, data).transpose(), bending(data.c_theta, data).transpose();
  mass.bottomLeftCorner(nf, kTwist) = C.transpose();
  mass.bottomRightCorner(nf, nf) = elastic;
  if (implicit && data.strain) data.strain->added.add_to(mass.bottomRightCorner(nf, nf));
}

void calc_dense_force(const BodyData<Plane>& data, Eigen::Ref<Eigen::VectorXd> force) {
  assert(force.size() == dense_size(*data.model->body));
  force << data.terms.Q, axial(data.Q_f, data), bending(data.Q_f, data);
}

namespace {

void calc_jacobian(const plane::Handle& handle, const Position& s, Eigen::Ref<Eigen::MatrixXd> J) {
  J.setZero();
  J.leftCols<kTwist>().setIdentity();
  J.col(kRotation).head<kPosition>() = quarter_turn(s);
  for (int c = 0; c < kTwist; ++c)
    if (handle.coordinate[c] >= 0) J(c, kTwist + handle.coordinate[c]) = 1.0;
}

}  // namespace

void calc_handle_jacobian(const BodyData<Plane>& data, int handle, Eigen::Ref<Eigen::MatrixXd> J) {
  assert(handle == 0 || handle == 1);
  assert(J.rows() == kTwist && J.cols() == dense_size(*data.model->body));
  const plane::FlexibleBody& body = *data.model->body;
  if (handle == 0)
    calc_jacobian(body.inboard, Position::Zero(), J);
  else
    calc_jacobian(body.outboard, calc_outboard_position(data), J);
}

Twist calc_handle_bias(const BodyData<Plane>& data, int handle, const Twist& twist) {
  assert(handle == 0 || handle == 1);
  Twist bias = Twist::Zero();
  if (handle == 0) return bias;  // at the origin
  const double speed = angular(twist);
  bias.head<kPosition>() = -speed * speed * calc_outboard_position(data) +
                           2.0 * speed * quarter_turn(calc_outboard_velocity(data));
  return bias;
}

}  // namespace spoke
