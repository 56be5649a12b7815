// Eliminates and recovers the joints of trees in space (engine/bodies/tree/joint_elimination.h has
// the equations).

#include "engine/step/formulation/structured/tree_elimination.h"

#include <cassert>
#include <utility>

#include "engine/support/prefetch.h"
#include "models/support/wide_kernels.h"

namespace spoke::structured {
namespace {

/// Fetches what the elimination of a chain reads next: the multi-port of a body, which stands
/// behind its handles, and the joint behind it.
void fetch_port(const SubsystemData<Space>& data, std::size_t j, const BodyWork<Space>& next) {
  const tree::MultiPort<Space>& port = data.bodies[j].work.port;
  const auto handles = static_cast<std::size_t>(port.handles);
  prefetch(port.diagonal, handles * sizeof *port.diagonal);
  prefetch(port.pairs, handles * sizeof *port.pairs);
  prefetch(&next, sizeof next);
  prefetch(&data.joints[j], sizeof data.joints[j]);
}

}  // namespace

void join_children(const Subsystem<Space>& subsystem, std::size_t j,
                   const SubsystemData<Space>& data, SubsystemWork<Space>& work) {
  if (data.outgrows_cache && j > 0) fetch_port(data, j - 1, work.bodies[j]);
  assert(j < work.bodies.size());
  assert(std::cmp_less(subsystem.bodies[j].children.size(), data.bodies[j].work.port.handles));
  const tree::MultiPort<Space>& port = data.bodies[j].work.port;
  const std::vector<int>& children = subsystem.bodies[j].children;
  run_large_kernel([&]() noexcept {
    for (std::size_t o = children.size(); o > 0; --o) {
      const auto c = static_cast<std::size_t>(children[o - 1]);
      tree::eliminate_child(static_cast<int>(o), joint_of(subsystem, data, c),
                            work.bodies[c].branch, port, work.bodies[c].joint);
    }
    tree::Branch<Space>& branch = work.bodies[j].branch;
    space::copy(port.diagonal[0].matrix(), branch.Lambda.all);
    branch.free = port.free[0];
  });
}

void recover_children(const Subsystem<Space>& subsystem, std::size_t j,
                      const SubsystemWork<Space>& work, SubsystemData<Space>& data) {
  assert(j < work.bodies.size() && data.bodies[j].work.wrenches);
  if (data.outgrows_cache && j + 2 < work.bodies.size())
    fetch_port(data, j + 1, work.bodies[j + 2]);
  BodyData<Space>& body = data.bodies[j];
  space::Twist* wrenches = body.work.wrenches;
  wrenches[0] = data.wrenches[j].inboard;
  const std::vector<int>& children = subsystem.bodies[j].children;
  run_large_kernel([&]() noexcept {
    for (std::size_t o = 1; o <= children.size(); ++o) {
      const auto c = static_cast<std::size_t>(children[o - 1]);
      const space::JointTerms joint = joint_of(subsystem, data, c);
      wrenches[o] =
          tree::recover_child(static_cast<int>(o), joint, body.work.port, work.bodies[c].joint,
                              wrenches, data.bodies[c].joint.a_found);
      data.wrenches[c].inboard = tree::pass_to_child<Space>(joint, wrenches[o]);
    }
  });
}

}  // namespace spoke::structured
