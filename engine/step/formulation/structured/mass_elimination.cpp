// Eliminates and recovers trees of rigid bodies by their masses
// (engine/bodies/tree/mass_elimination.h has the equations), and finds what unit forces of closures
// do in them (docs/formulation.md, section 12).

#include "engine/bodies/tree/mass_elimination.h"

#include <cassert>

#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/structured/tree_elimination.h"
#include "models/support/wide_kernels.h"

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

/// The elimination of one joint, of a root or not.
struct MassJoint {
  const space::SymmetricTwistMatrix& mass;
  const tree::JointResponse<Space>& response;
};
MassJoint joint_at(const SubsystemWork<Space>& work, int body, bool is_root) {
  if (is_root) {
    const tree::RootElimination<Space>& root =
        work.roots[static_cast<std::size_t>(work.root_at[static_cast<std::size_t>(body)])];
    return {root.mass, root.response};
  }
  const tree::JointElimination<Space>& joint = work.bodies[static_cast<std::size_t>(body)].joint;
  return {joint.Pi, joint.response};
}

/// The columns of one loop, from the tips to the hub. A unit force makes of each body that carries
/// it a wrench b on its origin; at a joint, in the parent's frame, with g = H^T b one coordinate
/// after another:
///   b -= g d y,   D += g d g',   free += g t
/// where the efforts of a coupling add to g, and of what is left free += b . a, a the acceleration
/// that bias and rotation make.
class MassLoop {
 public:
  MassLoop(const Subsystem<Space>& subsystem, std::size_t loop, const SubsystemWork<Space>& work,
           SubsystemData<Space>& data)
      : subsystem_(subsystem),
        loop_(subsystem.loops[loop]),
        path_(data.loops.paths[loop]),
        work_(work),
        data_(data),
        from_at_(path_.place_of(loop_.from.body)),
        to_at_(path_.place_of(loop_.to.body)) {}

  void eliminate() {
    for (int row = 0; row < path_.rows; ++row) eliminate(row);
  }

 private:
  space::Twist& branch(int at, int of_loop) { return data_.loops.branch(path_, at, of_loop); }

  void eliminate(int of_loop) {
    LoopData<Space>& loops = data_.loops;
    const auto r = static_cast<std::size_t>(path_.first_row + of_loop);
    const int bodies = static_cast<int>(path_.bodies.size());
    for (int k = 0; k < bodies; ++k) branch(k, of_loop).setZero();
    loops.free[r] = 0.0;
    loops.hub[r] = loops.states[r].hub;
    for (std::size_t k = 0; k < path_.joints.size() + path_.roots.size(); ++k)
      for (auto* columns : {&loops.joints, &loops.joint_forces})
        (*columns)[path_.column(k, of_loop)].setZero();
    if (loops.use[r] == LoopRowUse::dropped) return;
    put_unit_force(of_loop);
    std::size_t joint = 0, root = path_.joints.size();
    for (int k = 0; k < bodies; ++k) {
      const int body = path_.bodies[static_cast<std::size_t>(k)];
      for (; joint < path_.joints.size() && path_.joints[joint].parent == body; ++joint)
        if (path_.joints[joint].carries())
          pass_joint(path_.joints[joint], of_loop, path_.column(joint, of_loop),
                     branch(k, of_loop));
      if (subsystem_.bodies[static_cast<std::size_t>(body)].parent < 0)
        pass_root(body, of_loop, path_.column(root++, of_loop), branch(k, of_loop));
    }
  }

  void put_unit_force(int of_loop) {
    const auto r = static_cast<std::size_t>(path_.first_row + of_loop);
    const LoopRowState<Space>& row = data_.loops.states[r];
    put_unit_force(loop_.from, row.from, r, branch(from_at_, of_loop));
    if (to_at_ >= 0) put_unit_force(loop_.to, row.to, r, branch(to_at_, of_loop));
  }

  /// Adds the wrench u on the handle of a place to b, and what it does with the free acceleration.
  void put_unit_force(const LoopPlaceModel& place, const space::Twist& u, std::size_t r,
                      space::Twist& b) {
    if (place.handle == 0) {
      b += u;  // on the frame, whose acceleration is zero
      return;
    }
    const BodyData<Space>& body = data_.bodies[static_cast<std::size_t>(place.body)];
    b += translate(place_of(body, place.handle), u);
    data_.loops.free[r] += u.dot(body.work.port.free[place.handle]);
  }

  /// Takes off b what the joint's coordinates yield, and turns it to the parent's frame. `a`: of
  /// the handle that carries the joint, at zero acceleration of its frame.
  void yield(const MassJoint& joint, const space::JointTerms& terms, int child, int of_loop,
             std::size_t column, const space::Twist& a, space::Twist& b) {
    LoopData<Space>& loops = data_.loops;
    double& free = loops.free[static_cast<std::size_t>(path_.first_row + of_loop)];
    b = terms.R * b;
    JointEfforts efforts;
    find_efforts(loop_, child, efforts);
    for (int c = 0; c < terms.coordinates; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const double g = b.dot(joint.response.H.col(c)) + efforts[k];
      b -= g * joint.response.gain.col(c);
      free += g * joint.response.given[k];
      loops.joints[column][c] = g;
      loops.joint_forces[column][c] = joint.response.yield[k] * g;
    }
    free -= b.dot(tree::calc_r<Space>(terms, a));
  }

  /// `on_parent`: wrench on the parent, to which is added.
  void pass_joint(const LoadedJoint& joint, int of_loop, std::size_t column,
                  space::Twist& on_parent) {
    const auto c = static_cast<std::size_t>(joint.child);
    const BodyData<Space>& parent = data_.bodies[static_cast<std::size_t>(joint.parent)];
    const space::JointTerms terms = joint_of(subsystem_, data_, c);
    space::Twist& b = branch(joint.child_at, of_loop);
    yield(joint_at(work_, joint.child, false), terms, joint.child, of_loop, column,
          acceleration_of(parent, space::Twist::Zero(), joint.handle), b);
    on_parent += translate(place_of(parent, joint.handle), translate(terms.p, b));
  }

  void pass_root(int body, int of_loop, std::size_t column, space::Twist& b) {
    const space::JointTerms terms = joint_of(subsystem_, data_, static_cast<std::size_t>(body));
    yield(joint_at(work_, body, true), terms, body, of_loop, column, space::Twist::Zero(), b);
    data_.loops.hub[static_cast<std::size_t>(path_.first_row + of_loop)] += translate(terms.p, b);
  }

  const Subsystem<Space>& subsystem_;
  const LoopModel& loop_;
  const LoopPath& path_;
  const SubsystemWork<Space>& work_;
  SubsystemData<Space>& data_;
  int from_at_, to_at_;  ///< places of the closure's bodies in the path; -1: no body carries `to`
};

}  // namespace

bool has_rigid_bodies_alone(const SubsystemData<Space>& data) {
  return std::all_of(data.bodies.begin(), data.bodies.end(),
                     [](const BodyData<Space>& body) { return body.kind->has_mass_alone(); });
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
