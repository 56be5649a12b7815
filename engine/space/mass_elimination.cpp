// Eliminates and recovers trees of rigid bodies by their masses (engine/tree/mass_elimination.h has
// the equations), and finds what unit forces of closures do in them (docs/formulation.md, section
// 12).

#include "engine/tree/mass_elimination.h"

#include <cassert>

#include "engine/formulation/loops.h"
#include "engine/formulation/structured/tree_elimination.h"
#include "engine/support/wide_kernels.h"

namespace spoke::structured {
namespace {

/// Returns the place of a handle in the frame of its body.
space::Position place_of(const BodyData<Space>& body, int h) {
  if (h == 0) return space::Position::Zero();
  return body.blocks[0]->rigid->handles[static_cast<std::size_t>(h)];
}

/// Returns the acceleration of a handle at that of the frame.
space::Twist acceleration_of(const BodyData<Space>& body, const space::Twist& X, int h) {
  if (h == 0) return X;
  return refer(-place_of(body, h), X) + body.work.port.free[h];
}

std::size_t root_index(const SubsystemWork<Space>& work, int body) {
  std::size_t k = 0;
  while (work.root_bodies[k] != body) ++k;
  return k;
}

/// The elimination of one joint, of a root or not.
struct MassJoint {
  const space::SymmetricTwistMatrix& mass;
  const tree::JointResponse<Space>& response;
};
MassJoint joint_at(const SubsystemWork<Space>& work, int body, bool is_root) {
  if (is_root) {
    const tree::RootElimination<Space>& root = work.roots[root_index(work, body)];
    return {root.mass, root.response};
  }
  const tree::JointElimination<Space>& joint = work.bodies[static_cast<std::size_t>(body)].joint;
  return {joint.Pi, joint.response};
}

/// The columns of one loop, from the tips to the hub. A unit force makes of each body that carries
/// it a wrench b on its origin; at a joint, in the parent's frame, with g = H^T b one coordinate
/// after another:
///   b -= g d y,   D += g d g',   free += g t
/// and of what is left free += b . a, a the acceleration that bias and rotation make.
class MassLoop {
 public:
  MassLoop(const Subsystem<Space>& subsystem, std::size_t loop, const SubsystemWork<Space>& work,
           SubsystemData<Space>& data)
      : subsystem_(subsystem),
        loop_(subsystem.loops[loop]),
        path_(data.loops.paths[loop]),
        work_(work),
        data_(data) {}

  void eliminate() {
    for (int row = 0; row < path_.rows; ++row) eliminate(row);
  }

 private:
  void eliminate(int of_loop) {
    LoopData<Space>& loops = data_.loops;
    const int row = path_.first_row + of_loop;
    const auto r = static_cast<std::size_t>(row);
    for (int body = 0; body < loops.bodies; ++body) loops.branch(body, row).setZero();
    loops.free[r] = 0.0;
    loops.hub[r] = loops.states[r].hub;
    for (std::size_t k = 0; k < path_.joints.size() + path_.roots.size(); ++k)
      for (auto* columns : {&loops.joints, &loops.joint_forces})
        (*columns)[path_.column(k, of_loop)].setZero();
    if (loops.use[r] == LoopRowUse::dropped) return;
    put_unit_force(row);
    std::size_t joint = 0, root = path_.joints.size();
    for (const int body : path_.bodies) {
      for (; joint < path_.joints.size() && path_.joints[joint].parent == body; ++joint)
        if (path_.joints[joint].carries) pass_joint(path_.joints[joint], row, of_loop, joint);
      if (subsystem_.bodies[static_cast<std::size_t>(body)].parent < 0)
        pass_root(body, row, path_.column(root++, of_loop));
    }
  }

  void put_unit_force(int row) {
    LoopData<Space>& loops = data_.loops;
    const auto r = static_cast<std::size_t>(row);
    for_places_on_bodies(
        loop_, loops.states[r], [&](const LoopPlaceModel& place, const space::Twist& u) {
          const BodyData<Space>& body = data_.bodies[static_cast<std::size_t>(place.body)];
          loops.branch(place.body, row) += translate(place_of(body, place.handle), u);
          loops.free[r] += u.dot(acceleration_of(body, space::Twist::Zero(), place.handle));
        });
  }

  /// Takes off b what the joint's coordinates yield; returns it, in the parent's frame. `a`: of
  /// the handle that carries the joint, at zero acceleration of its frame.
  const space::Twist& yield(const MassJoint& joint, const space::JointTerms& terms, int child,
                            int row, std::size_t column, const space::Twist& a) {
    LoopData<Space>& loops = data_.loops;
    space::Twist& b = loops.branch(child, row);
    double& free = loops.free[static_cast<std::size_t>(row)];
    b = terms.R * b;
    for (int c = 0; c < terms.coordinates; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const double g = b.dot(joint.response.H.col(c));
      b -= g * joint.response.gain.col(c);
      free += g * joint.response.given[k];
      loops.joints[column][c] = g;
      loops.joint_forces[column][c] = joint.response.yield[k] * g;
    }
    free -= b.dot(tree::calc_r<Space>(terms, a));
    return b;
  }

  void pass_joint(const LoadedJoint& joint, int row, int of_loop, std::size_t at) {
    const auto c = static_cast<std::size_t>(joint.child);
    const BodyData<Space>& parent = data_.bodies[static_cast<std::size_t>(joint.parent)];
    const space::JointTerms terms = joint_of(subsystem_, data_, c);
    const space::Twist& b = yield(joint_at(work_, joint.child, false), terms, joint.child, row,
                                  path_.column(at, of_loop),
                                  acceleration_of(parent, space::Twist::Zero(), joint.handle));
    data_.loops.branch(joint.parent, row) +=
        translate(place_of(parent, joint.handle), translate(terms.p, b));
  }

  void pass_root(int body, int row, std::size_t column) {
    const space::JointTerms terms = joint_of(subsystem_, data_, static_cast<std::size_t>(body));
    const space::Twist& b =
        yield(joint_at(work_, body, true), terms, body, row, column, space::Twist::Zero());
    data_.loops.hub[static_cast<std::size_t>(row)] += translate(terms.p, b);
  }

  const Subsystem<Space>& subsystem_;
  const LoopModel& loop_;
  const LoopPath& path_;
  const SubsystemWork<Space>& work_;
  SubsystemData<Space>& data_;
};

}  // namespace

bool has_rigid_bodies_alone(const SubsystemData<Space>& data) {
  for (const BodyData<Space>& body : data.bodies)
    if (body.model->body->flexible() || body.model->body->solid()) return false;
  return true;
}

void join_children_by_mass(const Subsystem<Space>& subsystem, std::size_t j,
                           const SubsystemData<Space>& data, SubsystemWork<Space>& work) {
  assert(j < work.bodies.size());
  const BodyData<Space>& body = data.bodies[j];
  tree::Branch<Space>& branch = work.bodies[j].branch;
  branch = {body.work.port.diagonal[0], body.work.port.free[0]};
  const std::vector<int>& children = subsystem.bodies[j].children;
  for (std::size_t o = children.size(); o > 0; --o) {
    const auto c = static_cast<std::size_t>(children[o - 1]);
    const int h = static_cast<int>(o);
    const space::JointTerms joint = joint_of(subsystem, data, c);
    tree::JointElimination<Space>& own = work.bodies[c].joint;
    tree::eliminate_joint_by_mass(joint, work.bodies[c].branch, own.Pi, own.response);
    own.rhs.setZero();  // of compliances alone
    const tree::Branch<Space> felt = tree::pass_inward(
        joint, own.Pi, own.response, acceleration_of(body, space::Twist::Zero(), h));
    const space::Position place = place_of(body, h);
    branch.Lambda = branch.Lambda + translate(place, felt.Lambda);
    branch.free += translate(place, felt.free);
  }
}

tree::HubShare<Space> eliminate_root_by_mass(const space::JointTerms& joint,
                                             const tree::Branch<Space>& branch,
                                             tree::RootElimination<Space>& root) noexcept {
  tree::eliminate_joint_by_mass(joint, branch, root.mass, root.response);
  root.free.setZero();  // of compliances alone
  const tree::Branch<Space> felt =
      tree::pass_inward(joint, root.mass, root.response, space::Twist(space::Twist::Zero()));
  return {felt.Lambda, felt.free};
}

void recover_by_mass(const Subsystem<Space>& subsystem, SubsystemWork<Space>& work,
                     SubsystemData<Space>& data) noexcept {
  assert(data.hub_acceleration);
  run_kernel([&]() noexcept {
    for (std::size_t j = 0; j < work.bodies.size(); ++j) {
      const TreeBody<Space>& model = subsystem.bodies[j];
      const bool is_root = model.parent < 0;
      const auto p = static_cast<std::size_t>(model.parent);
      const space::Twist a = is_root
                                 ? *data.hub_acceleration
                                 : acceleration_of(data.bodies[p], work.bodies[p].X, model.handle);
      const MassJoint joint = joint_at(work, static_cast<int>(j), is_root);
      const auto found =
          tree::recover_joint_by_mass(joint_of(subsystem, data, j), joint.mass, joint.response, a,
                                      joint_accelerations(data.bodies[j]));
      work.bodies[j].X = found.frame;
      set_inboard_wrench(found.on_child, j, data);
      if (!is_root) wrench_on(data, p, model.handle) = found.on_parent;
    }
  });
}

void calc_loop_columns_by_mass(const Subsystem<Space>& subsystem, std::size_t loop,
                               const SubsystemWork<Space>& work,
                               SubsystemData<Space>& data) noexcept {
  run_kernel([&]() noexcept { MassLoop(subsystem, loop, work, data).eliminate(); });
}

}  // namespace spoke::structured
