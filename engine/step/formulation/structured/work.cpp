// Allocates the memory of the formulation, per subsystem.

#include <utility>

#include "engine/bodies/kernels/body_parts.h"
#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/structured/tree_elimination.h"

namespace spoke::structured {
namespace {

/// Returns the memory of what the elimination of the joint of a body sets for each of its
/// coordinates.
template <class World, class Elimination>
Memory memory_of_response(const BodyData<World>& body, Elimination& elimination) {
  if constexpr (tree::kHasJointCoordinates<World>) {
    tree::JointResponse<World>& response = elimination.response;
    const auto n = static_cast<std::size_t>(body.model->joint.joint.coordinates);
    return {graph::bytes_of(response.wrench), memory_of(response.H.data(), n * World::kTwist),
            memory_of(response.gain.data(), n * World::kTwist), memory_of(response.given.data(), n),
            memory_of(response.yield.data(), n)};
  } else {
    return {};
  }
}

/// Declares the parts of the bodies, and of their joints.
template <class World>
void declare_bodies(SubsystemData<World>& data, SubsystemWork<World>& work) {
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    BodyWork<World>& body = work.bodies[j];
    declare_inverse(j, body, data);
    if (work.by_mass) data.part_maker.add(data.parts.wrenches, body.X);
    BodyParts& parts = data.parts.bodies[j];
    if (!parts.is_root)
      parts.joint = maker_of_body(j, data).cover("joint", Mark::none, body.joint.Pi, body.joint.rhs,
                                                 memory_of_response(data.bodies[j], body.joint));
  }
}

/// Declares the effective inertia, and its workspace.
template <class World>
void declare_effective_inertia(SubsystemData<World>& data, SubsystemWork<World>& work) {
  const PartMaker& maker = data.part_maker;
  SubsystemParts& parts = data.parts;
  parts.effective = maker.cover("effective inertia", Mark::none, data.effective);
  for (std::size_t k = 0; k < work.roots.size(); ++k) {
    tree::RootElimination<World>& root = work.roots[k];
    const auto j = static_cast<std::size_t>(work.root_bodies[k]);
    maker.add(parts.effective, root.mass, root.free, memory_of_response(data.bodies[j], root));
  }
  parts.workspace = maker.cover("workspace", Mark::none);
  for (BodyWork<World>& body : work.bodies) maker.add(parts.workspace, body.branch);
}

/// Declares what the unit forces of loops do, and the workspace in which it is found.
template <class World>
void declare_loop_columns(SubsystemData<World>& data, const SubsystemWork<World>& work) {
  LoopData<World>& loops = data.loops;
  for (std::size_t k = 0; k < loops.paths.size(); ++k) {
    const LoopPath& path = loops.paths[k];
    const PartMaker maker = maker_of_loop(k, data);
    const graph::PartId columns = declare_loop_rows(k, data);
    maker.add(columns, memory_of(&loops.branches[path.first_branch], path.branches()));
    for (auto* of_joints : {&loops.joints, &loops.joint_forces})
      maker.add(columns, memory_of(of_joints->data() + path.first_joint, path.columns()));
    if (!work.by_mass)
      data.parts.loops.scratch.push_back(
          maker.cover("scratch", Mark::none,
                      memory_of(loops.scratch.data() + path.first_handle,
                                static_cast<std::size_t>(path.handles))));
  }
  declare_loop_matrix(data);
}

}  // namespace

template <class World>
void allocate(SubsystemData<World>& data, SubsystemWork<World>& work) {
  Arena& arena = *data.arena;
  work.bodies = ArenaVector<BodyWork<World>>(data.bodies.size(), arena);
  work.root_at.assign(data.bodies.size(), -1);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    if (data.bodies[j].model->parent >= 0) continue;
    work.root_at[j] = static_cast<int>(work.root_bodies.size());
    work.root_bodies.push_back(static_cast<int>(j));
  }
  work.by_mass = has_rigid_bodies_alone(data);
  for (BodyWork<World>& body : work.bodies) body.by_mass = work.by_mass;
  work.roots = ArenaVector<tree::RootElimination<World>>(work.root_bodies.size(), arena);
  std::size_t total = BodyTypes<World>::Layout::kPad;
  for (const BodyData<World>& body : data.bodies) total += count_condensed(*body.model->body);
  work.storage = ArenaVector<double>(total, 0.0, arena);
  double* next = work.storage.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const typename World::Body& body = *data.bodies[j].model->body;
    place_condensed(body, std::exchange(next, next + count_condensed(body)), work.bodies[j]);
  }
  declare_bodies(data, work);
  declare_effective_inertia(data, work);
  declare_loop_columns(data, work);
}

template void allocate(SubsystemData<Plane>&, SubsystemWork<Plane>&);
template void allocate(SubsystemData<Space>&, SubsystemWork<Space>&);

}  // namespace spoke::structured
