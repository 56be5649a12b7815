// Dense matrices of bodies in space, flexible or rigid.

#include "engine/formulation/dense_body.h"
#include "engine/kernels/spatial_terms.h"
#include "engine/space/dense_body.h"

namespace spoke {

Eigen::MatrixXd make_dense_elastic_block(const space::Body& body, double mass_factor,
                                         double stiffness_factor) {
  if (const space::FlexibleBody* flexible = body.flexible())
    return space::make_dense_elastic_block(*flexible, {mass_factor, stiffness_factor, 0.0});
  return {};
}

void calc_dense_mass(const BodyData<Space>& data, const Eigen::MatrixXd& elastic, bool implicit,
                     Eigen::Ref<Eigen::MatrixXd> mass) {
  const space::FlexibleBody* flexible = data.model->body->flexible();
  if (!flexible) {
    mass = rigid_mass_of(data).matrix();
    return;
  }
  space::calc_dense_mass(*flexible, data.terms, data.work, elastic, mass);
  if (implicit && has_implicit_tension(data))
    space::add_dense(*flexible, data.tension->stiffness,
                     mass.bottomRightCorner(elastic.rows(), elastic.cols()));
}

void calc_dense_force(const BodyData<Space>& data, Eigen::Ref<Eigen::VectorXd> force) {
  if (const space::FlexibleBody* flexible = data.model->body->flexible())
    space::calc_dense_force(*flexible, data.terms, data.work, force);
  else
    force = data.terms.Q;
}

void calc_handle_jacobian(const BodyData<Space>& data, int handle, Eigen::Ref<Eigen::MatrixXd> J) {
  if (const space::FlexibleBody* flexible = data.model->body->flexible())
    return space::calc_handle_jacobian(*flexible, handle, data.work, J);
  J.setIdentity();
  J.topRightCorner<3, 3>() = -space::skew(data.work.handles[handle].s);
}

space::Twist calc_handle_bias(const BodyData<Space>& data, int handle, const space::Twist& twist) {
  return data.work.handles[handle].bias(angular(twist));
}

}  // namespace spoke
