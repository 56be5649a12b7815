// Full matrices of a body, for kinds whose stiffness is constant.

#include "engine/bodies/table/body_kind.h"

namespace spoke {

Eigen::MatrixXd BodyKind<Space>::calc_own_mass(const Data& body) const {
  const space::Body& shape = *body.model->body;
  const int size = space::kTwist + shape.coordinates();
  Eigen::MatrixXd mass(size, size);
  calc_dense_mass(body, make_dense_block(shape, {1.0, 0.0, 0.0}), false, mass);
  return mass;
}

Eigen::MatrixXd BodyKind<Space>::calc_stiffness(const Data& body) const {
  return make_dense_block(*body.model->body, {0.0, 1.0, 0.0});
}

Eigen::MatrixXd BodyKind<Space>::calc_damping(const Damping& damping, const Data& body) const {
  return make_dense_block(*body.model->body, {damping.mass_factor, damping.stiffness_factor, 1.0});
}

}  // namespace spoke
