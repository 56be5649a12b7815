// Condenses, eliminates and recovers trees in space (engine/tree/joint_elimination.h has the
// equations).

#include "engine/formulation/structured/tree_elimination.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/space/condense_body.h"
#include "engine/space/condense_solid.h"
#include "engine/space/table_terms.h"
#include "engine/support/prefetch.h"
#include "models/support/wide_kernels.h"

namespace spoke::structured {
namespace {

const space::Solid& solid_of(const BodyData<Space>& body) { return *body.model->body->solid(); }

/// Sets what the elimination by masses reads.
void place_mass(const BodyData<Space>& data, const space::Twist& twist) {
  const tree::MultiPort<Space>& port = data.work.port;
  if (!data.carried) return space::place_mass(*data.blocks[0]->rigid, twist, data.terms.Q, port);
  port.diagonal[0] = data.carried->mass;
  port.free[0] = data.terms.Q;
}

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

void condense_body(BodyData<Space>& data, const space::Twist& twist, bool implicit,
                   BodyWork<Space>& work) noexcept {
  if (work.by_mass)
    place_mass(data, twist);
  else if (data.model->body->flexible())
    space::condense_body(body_model_of(data), data.terms, angular(twist), implicit, data.work);
  else if (is_tiled(data))
    condense_between(solid_of(data), *data.blocks[implicit]->solid, data.terms, angular(twist),
                     data.work);
  else if (const space::Solid* solid = data.model->body->solid())
    condense_solid(*solid, *data.blocks[implicit]->solid, data.terms, angular(twist), data.work);
  else if (data.carried)
    space::condense(*data.carried, data.terms.Q, data.work.port);
  else
    space::condense(*data.blocks[0]->rigid, twist, data.terms.Q, data.work.port);
}

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

void recover_body(const SubsystemData<Space>&, std::size_t, const BodyWork<Space>& work,
                  bool implicit, BodyData<Space>& data, double* a) noexcept {
  const space::Twist* wrenches = data.work.wrenches;
  if (work.by_mass) {
    data.X = work.X;
  } else if (data.model->body->flexible()) {
    data.X = space::recover_body(body_model_of(data), wrenches, implicit, data.work, a);
  } else if (is_tiled(data)) {
    data.X = recover_between(solid_of(data), *data.blocks[implicit]->solid, wrenches, data.work);
  } else if (const space::Solid* solid = data.model->body->solid()) {
    data.X = recover_solid(*solid, *data.blocks[implicit]->solid, wrenches, data.work, a);
  } else if (data.carried) {
    data.X = data.carried->inverse * space::Twist(data.terms.Q + wrenches[0]);
  } else {
    const auto count = static_cast<std::size_t>(data.work.port.handles);
    data.X = space::recover_frame(*data.blocks[0]->rigid, data.terms.Q, {wrenches, count});
  }
}

void condense_slice(BodyData<Space>& body, int p, bool implicit) noexcept {
  space::condense_slice(solid_of(body), *body.blocks[implicit]->solid, p, body.work);
}

void recover_slice(BodyData<Space>& body, int p, bool implicit) noexcept {
  space::recover_slice(solid_of(body), *body.blocks[implicit]->solid, p, body.X, body.work.wrenches,
                       body.work);
}

void take_slices(const BodyData<Space>& body, double* a) noexcept {
  std::copy_n(body.work.solution, solid_of(body).coordinates(), a);
}

}  // namespace spoke::structured
