// Tips, joints, loads and nodes of the trees.

#include "engine/steady/describe_equilibrium.h"

#include "engine/support/plain_zero.h"
#include "models/space/rotation_vector.h"

namespace spoke::steady {
namespace {

void evaluate(std::size_t tree, const Eigen::VectorXd& q, SteadyModel& model) {
  TreeResponse response;
  model.evaluate(tree, make_state(q), model.no_offset(), response);
}

BladeEquilibrium describe_tree(std::size_t tree, const Eigen::VectorXd& q, SteadyModel& model) {
  BladeEquilibrium blade;
  blade.name = model.name_of(tree);
  const std::vector<TreeCoordinate>& coordinates = model.coordinates(tree);
  Eigen::VectorXd rigid = q;  // joints as they are, bodies undeformed
  const Eigen::VectorXd shown = model.absolute(tree, q);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const TreeCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0)
      rigid[k] = 0.0;
    else
      blade.joints.push_back({coordinate.name, shown[k], coordinate.turns});
  }
  evaluate(tree, rigid, model);
  for (const NodePlace& place : model.places(tree)) {
    blade.bodies.push_back(place.body);
    blade.undeformed.push_back(place.p);
    blade.undeformed_axes.push_back(place.axes);
  }
  evaluate(tree, q, model);
  for (const NodePlace& place : model.places(tree)) {
    const Eigen::Matrix3d& before = blade.undeformed_axes[blade.nodes.size()];
    blade.nodes.push_back(place.p);
    blade.rotations.emplace_back(
        space::logarithm(space::Rotation{place.axes * before.transpose()}));
  }
  model.accelerations(tree);
  const TipMotion tip = model.tip(tree);
  blade.tip_displacement = tip.displacement;
  blade.tip_rotation = tip.rotation;
  blade.bending = model.bending(tree);
  for (const RootLoad& load : model.root_loads(tree))
    blade.loads.push_back({load.body, load.station, load.force, load.moment});
  return blade;
}

}  // namespace

EquilibriumResult describe(const Equilibrium& found, SteadyModel& model) {
  EquilibriumResult result;
  result.speed = plain_zero(model.speed());
  result.iterations = found.iterations;
  result.load_steps = found.load_steps;
  result.last_change = found.last_change;
  if (model.is_spatial()) {
    result.hub_force = found.wrench.head<3>();
    result.hub_moment = found.wrench.tail<3>();
  } else {
    result.hub_force.head<2>() = found.wrench.head<2>();
    result.hub_moment.z() = found.wrench[2];
  }
  for (std::size_t i = 0; i < model.trees(); ++i)
    result.blades.push_back(describe_tree(i, found.q[i], model));
  return result;
}

}  // namespace spoke::steady
