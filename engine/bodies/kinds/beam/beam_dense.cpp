// A beam as full matrices, for the dense formulations.

#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/bodies/kinds/beam/beam_kind.h"

namespace spoke {

Eigen::MatrixXd BeamKind::make_dense_block(const space::Body& body,
                                           const space::BlockFactors& factors) const {
  return space::make_dense_elastic_block(*body.flexible(), factors);
}

void BeamKind::calc_dense_mass(const Data& body, const Eigen::MatrixXd& elastic, bool implicit,
                               Eigen::Ref<Eigen::MatrixXd> mass) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  space::calc_dense_mass(beam, body.terms, body.work, elastic, mass);
  auto deformation = mass.bottomRightCorner(elastic.rows(), elastic.cols());
  if (implicit && has_implicit_tension(body))
    space::add_dense(beam, body.tension->stiffness, deformation);
  if (!implicit || !body.strain) return;
  space::add_dense(beam, body.strain->added, deformation);
  space::shift_dense(beam, body.strain->shift, deformation);
}

void BeamKind::calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const {
  space::calc_dense_force(*body.model->body->flexible(), body.terms, body.work, force);
}

void BeamKind::calc_handle_jacobian(const Data& body, int handle,
                                    Eigen::Ref<Eigen::MatrixXd> J) const {
  space::calc_handle_jacobian(*body.model->body->flexible(), handle, body.work, J);
}

}  // namespace spoke
