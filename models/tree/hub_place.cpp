// Follows a support from its base to the hub.

#include "models/tree/hub_place.h"

#include "models/space/rotation_vector.h"
#include "models/tree/tree.h"

namespace spoke::spatial {

Eigen::Vector3d find_hub_place(const Model& model, int rotor) {
  if (!model.support) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d from_base = find_hub_placement(model, build_trees(model), rotor).position;
  if (model.support->from == SupportBase::ground) return from_base;
  const Fuselage& fuselage = model.support->fuselage;
  return fuselage.position + space::exponential(fuselage.attitude).axes * from_base;
}

}  // namespace spoke::spatial
