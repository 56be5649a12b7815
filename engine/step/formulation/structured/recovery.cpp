// Recovery, docs/formulation.md, section 4.1: the wrenches of the joints, the multipliers of (P 8),
// from the roots to the tips, then the accelerations of every body on its own, (P 7).

#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/step/formulation/structured/tree_elimination.h"

namespace spoke::structured {
namespace {

/// Calculates f = Pi (rhs - P_io^T F) on the outboard handle of body j and F(child) = -R_PB^T f; at
/// the tip f = 0.
void recover_children(const Subsystem<Plane>& subsystem, std::size_t j,
                      const SubsystemWork<Plane>& work, SubsystemData<Plane>& data) {
  plane::Wrenches& wrenches = data.wrenches[j];
  wrenches.outboard.setZero();
  if (subsystem.bodies[j].children.empty()) return;
  const plane::TwoPort& port = work.bodies[j].port;
  const tree::JointElimination<Plane>& elimination = work.bodies[j + 1].joint;
  const plane::JointMotion& joint = data.joints[j + 1];
  wrenches.outboard = tree::recover_joint(
      joint, elimination,
      Twist(elimination.rhs - port.P_io.transpose().lazyProduct(wrenches.inboard)));
  data.wrenches[j + 1].inboard = tree::pass_to_child<Plane>(joint, wrenches.outboard);
}

}  // namespace

template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  assert(work.bodies.size() == subsystem.bodies.size() && data.hub_acceleration);
  if (work.by_mass) return recover_by_mass(subsystem, work, data);
  // (1) At the roots F = Lam^-1 (R_PB^T (T Y'' + b) - be).
  for (std::size_t k = 0; k < work.roots.size(); ++k) {
    const auto j = static_cast<std::size_t>(work.root_bodies[k]);
    const auto root = joint_of(subsystem, data, j);
    data.wrenches[j].inboard = tree::recover_root(
        root, work.roots[k], calc_root_acceleration<World>(root, *data.hub_acceleration),
        joint_accelerations(data.bodies[j]));
  }
  // (2) The wrenches follow from body to body.
  for (std::size_t j = 0; j < work.bodies.size(); ++j) recover_children(subsystem, j, work, data);
}

template <class World>
PartList parts_of_wrenches(const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  PartList list{own.effective, own.rotations, own.hub_state, own.hub_acceleration};
  graph::add_to(list, own.joints());
  if constexpr (tree::kHasJointCoordinates<World>) {
    graph::add_to(list, own.ports(), own.all(&BodyParts::terms));
  } else {
    PartList ports = own.all(&BodyParts::inverse);
    ports.pop_back();
    graph::add_to(list, ports);
  }
  return list;
}

template void recover_wrenches(const Subsystem<Plane>&, SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void recover_wrenches(const Subsystem<Space>&, SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;
template PartList parts_of_wrenches(const SubsystemData<Plane>&);
template PartList parts_of_wrenches(const SubsystemData<Space>&);

}  // namespace spoke::structured
