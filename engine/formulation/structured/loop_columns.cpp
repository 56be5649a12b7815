// What unit forces of closures do in a tree that has been eliminated: they are more right-hand
// sides of the same elimination, docs/formulation.md, section 12. Of a body that carries a loop,
// with A_h the acceleration of handle h by a unit force (' of the child at handle o, on whose body
// the loop is, else zero):
//   A_h = P_hl u  of the places l on the body,       K = X R A_0' - A_o,      f = Pi K
//   A_h += P_ho f  of the handles h before o
// in place of elimination's r and f. By reciprocity, K^T f is what the joint yields in the row:
//   D = sum u^T P_ll' u' - sum K^T Pi K',    free = sum u . a_l - sum K . (Pi r + s)
// At a root, A_0 in place of K, -(free - R^T b) in place of r, and N = T^T R Pi A_0.

#include <cassert>

#include "engine/formulation/loops.h"
#include "engine/formulation/structured/tree_elimination.h"
#include "engine/formulation/tree_joints.h"
#include "engine/support/wide_kernels.h"

namespace spoke::structured {
namespace {

// Responses of a body's handles, by world.

/// Returns the acceleration of handle `h` by a wrench on handle `l`.
Twist respond(const SubsystemData<Plane>&, const SubsystemWork<Plane>& work, int body, int h, int l,
              const Twist& wrench) {
  const plane::TwoPort& port = work.bodies[static_cast<std::size_t>(body)].port;
  if (h == l) return (h == 0 ? port.P_ii : port.P_oo) * wrench;
  return h == 0 ? Twist(port.P_io.lazyProduct(wrench))
                : Twist(port.P_io.transpose().lazyProduct(wrench));
}
space::Twist respond(const SubsystemData<Space>& data, const SubsystemWork<Space>&, int body, int h,
                     int l, const space::Twist& wrench) {
  const tree::MultiPort<Space>& port = data.bodies[static_cast<std::size_t>(body)].work.port;
  if (h == l) return port.diagonal[h] * wrench;
  return h < l ? space::Twist(port.between(h, l).lazyProduct(wrench))
               : space::Twist(port.between(l, h).transpose().lazyProduct(wrench));
}

/// Returns the acceleration of a handle at which no child hangs, without wrenches.
const Twist& free_acceleration(const SubsystemData<Plane>&, const SubsystemWork<Plane>& work,
                               int body, int) {
  return work.bodies[static_cast<std::size_t>(body)].port.free_o;
}
const space::Twist& free_acceleration(const SubsystemData<Space>& data, const SubsystemWork<Space>&,
                                      int body, int handle) {
  return data.bodies[static_cast<std::size_t>(body)].work.port.free[handle];
}

/// Returns X R a: the acceleration of a child's inboard handle at that of its parent.
Twist carry_inward(const plane::JointTerms& joint, const Twist& a) { return joint.R * a; }
space::Twist carry_inward(const space::JointTerms& joint, const space::Twist& a) {
  return refer(joint.p, joint.R * a);
}

/// Returns what a joint transmits if no other handle has a wrench: Pi r + s.
Twist transmitted(const tree::JointElimination<Plane>& joint) { return joint.Pi * joint.rhs; }
space::Twist transmitted(const tree::JointElimination<Space>& joint) {
  return joint.Pi * joint.rhs + joint.response.wrench;
}

/// Returns the wrench on the root handle that the hub's acceleration zero makes, with the other
/// sign.
Twist transmitted(const plane::JointTerms& joint, const tree::RootElimination<Plane>& root) {
  return root.mass * Twist(root.free - joint.R.inverse() * joint.bias);
}
space::Twist transmitted(const space::JointTerms& joint, const tree::RootElimination<Space>& root) {
  return root.mass * space::Twist(root.free - joint.R.inverse() * joint.bias) +
         root.response.wrench;
}

template <class World>
std::size_t root_index(const SubsystemWork<World>& work, int body) {
  for (std::size_t k = 0; k < work.root_bodies.size(); ++k)
    if (work.root_bodies[k] == body) return k;
  assert(false && "the hub carries the body");
  return 0;
}

/// The columns of one loop, in the order of elimination.
template <class World>
class LoopEliminator {
 public:
  LoopEliminator(const Subsystem<World>& subsystem, std::size_t loop,
                 const SubsystemWork<World>& work, SubsystemData<World>& data)
      : subsystem_(subsystem),
        loop_(subsystem.loops[loop]),
        path_(data.loops.paths[loop]),
        work_(work),
        data_(data) {}

  void eliminate() {
    for (int row = 0; row < path_.rows; ++row) eliminate(path_.first_row + row);
  }

 private:
  using Vector = TwistOf<World>;

  /// Acceleration A_h of a handle of the body at hand.
  Vector& at(int h, int row) { return data_.loops.handle(h, row); }

  void eliminate(int row) {
    LoopData<World>& loops = data_.loops;
    const auto r = static_cast<std::size_t>(row);
    // What is no part of the way, or takes no part, is zero.
    for (int body = 0; body < loops.bodies; ++body) loops.branch(body, row).setZero();
    for (int h = 0; h < loops.handles; ++h) at(h, row).setZero();
    loops.free[r] = 0.0;
    loops.hub[r] = loops.states[r].hub;
    const int of_loop = row - path_.first_row;
    if (loops.use[r] == LoopRowUse::dropped) return clear(of_loop);
    std::size_t joint = 0, root = path_.joints.size();
    for (const int body : path_.bodies) {
      begin_body(body, row);
      for (; joint < path_.joints.size() && path_.joints[joint].parent == body; ++joint)
        eliminate_joint(path_.joints[joint], row, path_.column(joint, of_loop));
      loops.branch(body, row) = at(0, row);
      if (subsystem_.bodies[static_cast<std::size_t>(body)].parent < 0)
        eliminate_root(body, row, path_.column(root++, of_loop));
    }
  }

  void clear(int row) {
    for (std::size_t k = 0; k < path_.joints.size() + path_.roots.size(); ++k)
      for (auto* columns : {&data_.loops.joints, &data_.loops.joint_forces})
        (*columns)[path_.column(k, row)].setZero();
  }

  void begin_body(int body, int row) {
    const auto r = static_cast<std::size_t>(row);
    const int children =
        static_cast<int>(subsystem_.bodies[static_cast<std::size_t>(body)].children.size());
    for (int h = 0; h <= children; ++h) at(h, row).setZero();
    for_places_on_bodies(
        loop_, data_.loops.states[r], [&](const LoopPlaceModel& place, const Vector& u) {
          if (place.body != body) return;
          for (int h = 0; h <= children; ++h)
            at(h, row) += respond(data_, work_, body, h, place.handle, u);
          data_.loops.free[r] += u.dot(free_acceleration(data_, work_, body, place.handle));
        });
  }

  void eliminate_joint(const LoadedJoint& joint, int row, std::size_t column) {
    Vector& K = data_.loops.joints[column];
    const auto c = static_cast<std::size_t>(joint.child);
    const tree::JointElimination<World>& elimination = work_.bodies[c].joint;
    K = -at(joint.handle, row);
    if (joint.carries)
      K += carry_inward(joint_of(subsystem_, data_, c), data_.loops.branch(joint.child, row));
    const Vector f = elimination.Pi * K;
    data_.loops.joint_forces[column] = f;
    for (int h = 0; h < joint.handle; ++h)
      at(h, row) += respond(data_, work_, joint.parent, h, joint.handle, f);
    data_.loops.free[static_cast<std::size_t>(row)] -= K.dot(transmitted(elimination));
  }

  void eliminate_root(int body, int row, std::size_t column) {
    const auto r = static_cast<std::size_t>(row);
    const tree::RootElimination<World>& root = work_.roots[root_index(work_, body)];
    const auto joint = joint_of(subsystem_, data_, static_cast<std::size_t>(body));
    const Vector& A = data_.loops.branch(body, row);
    const Vector f = root.mass * A;
    data_.loops.joints[column] = A;
    data_.loops.joint_forces[column] = f;
    data_.loops.hub[r] += translate(joint.p, Vector(joint.R * f));
    data_.loops.free[r] -= A.dot(transmitted(joint, root));
  }

  const Subsystem<World>& subsystem_;
  const LoopModel& loop_;
  const LoopPath& path_;
  const SubsystemWork<World>& work_;
  SubsystemData<World>& data_;
};

/// The part of D that two loops have in common, rows of the first and columns of the second one.
template <class World>
class LoopCoupling {
 public:
  LoopCoupling(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
               SubsystemData<World>& data)
      : subsystem_(subsystem), work_(work), data_(data) {}

  void couple(std::size_t a, std::size_t b) {
    const LoopPath &of_a = data_.loops.paths[a], &of_b = data_.loops.paths[b];
    for (int i = 0; i < of_a.rows; ++i)
      for (int j = 0; j < of_b.rows && (a != b || j <= i); ++j)
        data_.loops.entry(of_a.first_row + i, of_b.first_row + j) =
            !takes_part(of_a.first_row + i) || !takes_part(of_b.first_row + j) ? 0.0
                                                                               : couple(a, b, i, j);
  }

 private:
  using Vector = TwistOf<World>;

  bool takes_part(int row) const {
    return data_.loops.use[static_cast<std::size_t>(row)] != LoopRowUse::dropped;
  }

  double couple(std::size_t a, std::size_t b, int i, int j) const {
    const LoopPath &of_a = data_.loops.paths[a], &of_b = data_.loops.paths[b];
    const double joints = at_joints(of_a, of_b, i, j), roots = at_roots(of_a, of_b, i, j);
    // By masses rigid bodies yield nothing but what their joints' coordinates do.
    return work_.by_mass ? joints + roots : at_places(a, b, i, j) - joints - roots;
  }

  double at_places(std::size_t a, std::size_t b, int i, int j) const {
    const LoopData<World>& loops = data_.loops;
    const auto r = static_cast<std::size_t>(loops.paths[a].first_row + i);
    const auto c = static_cast<std::size_t>(loops.paths[b].first_row + j);
    double sum = 0.0;
    for_places_on_bodies(
        subsystem_.loops[a], loops.states[r], [&](const LoopPlaceModel& place, const Vector& u) {
          for_places_on_bodies(
              subsystem_.loops[b], loops.states[c],
              [&](const LoopPlaceModel& other, const Vector& v) {
                if (other.body == place.body)
                  sum += u.dot(respond(data_, work_, place.body, place.handle, other.handle, v));
              });
        });
    return sum;
  }

  /// Returns K^T f of a joint or root of each loop.
  double at_column(const LoopPath& a, std::size_t x, int i, const LoopPath& b, std::size_t y,
                   int j) const {
    return data_.loops.joints[a.column(x, i)].dot(data_.loops.joint_forces[b.column(y, j)]);
  }

  /// Sums K^T f' over the joints that both load, whose lists have one order.
  double at_joints(const LoopPath& a, const LoopPath& b, int i, int j) const {
    double sum = 0.0;
    for (std::size_t m = 0, n = 0; m < a.joints.size() && n < b.joints.size();) {
      const LoadedJoint &x = a.joints[m], &y = b.joints[n];
      if (x.child == y.child)
        sum += at_column(a, m++, i, b, n++, j);
      else if (x.parent > y.parent || (x.parent == y.parent && x.handle > y.handle))
        ++m;
      else
        ++n;
    }
    return sum;
  }

  double at_roots(const LoopPath& a, const LoopPath& b, int i, int j) const {
    double sum = 0.0;
    for (std::size_t m = 0; m < a.roots.size(); ++m)
      for (std::size_t n = 0; n < b.roots.size(); ++n)
        if (a.roots[m] == b.roots[n])
          sum += at_column(a, a.joints.size() + m, i, b, b.joints.size() + n, j);
    return sum;
  }

  const Subsystem<World>& subsystem_;
  const SubsystemWork<World>& work_;
  SubsystemData<World>& data_;
};

}  // namespace

template <class World>
void calc_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                       const SubsystemWork<World>& work, SubsystemData<World>& data) noexcept {
  assert(loop < subsystem.loops.size());
  if (work.by_mass) return calc_loop_columns_by_mass(subsystem, loop, work, data);
  run_kernel([&]() noexcept { LoopEliminator<World>(subsystem, loop, work, data).eliminate(); });
}

template <class World>
void fill_loop_matrix(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  run_kernel([&]() noexcept {
    LoopCoupling<World> coupling(subsystem, work, data);
    for (std::size_t a = 0; a < subsystem.loops.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b) coupling.couple(a, b);
  });
}

namespace {

/// Adds the force `lambda` of a row to what a joint gives; `column`: of the row at this joint.
template <class World, class Elimination>
void load_joint(const LoopData<World>& loops, bool by_mass, int child, int row, std::size_t column,
                Elimination& joint, TwistOf<World>& rhs) {
  const double lambda = loops.multipliers[static_cast<std::size_t>(row)];
  if constexpr (tree::kHasJointCoordinates<World>)
    if (by_mass) {
      joint.response.wrench += lambda * loops.branch(child, row);
      for (int c = 0; c < World::kMostJointCoordinates; ++c)
        joint.response.given[static_cast<std::size_t>(c)] += lambda * loops.joint_forces[column][c];
      return;
    }
  rhs += lambda * loops.joints[column];
}

}  // namespace

template <class World>
void load_joints_by_loops(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                          SubsystemWork<World>& work) noexcept {
  const LoopData<World>& loops = data.loops;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopPath& path = loops.paths[k];
    for (int of_loop = 0; of_loop < path.rows; ++of_loop) {
      const int row = path.first_row + of_loop;
      if (loops.multipliers[static_cast<std::size_t>(row)] == 0.0) continue;  // of redundant rows
      for (std::size_t m = 0; m < path.joints.size(); ++m) {
        const int child = path.joints[m].child;
        auto& joint = work.bodies[static_cast<std::size_t>(child)].joint;
        load_joint(loops, work.by_mass, child, row, path.column(m, of_loop), joint, joint.rhs);
      }
      for (std::size_t m = 0; m < path.roots.size(); ++m) {
        auto& root = work.roots[root_index(work, path.roots[m])];
        load_joint(loops, work.by_mass, path.roots[m], row,
                   path.column(path.joints.size() + m, of_loop), root, root.free);
      }
    }
  }
}

template void calc_loop_columns(const Subsystem<Plane>&, std::size_t, const SubsystemWork<Plane>&,
                                SubsystemData<Plane>&) noexcept;
template void fill_loop_matrix(const Subsystem<Plane>&, const SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void load_joints_by_loops(const Subsystem<Plane>&, const SubsystemData<Plane>&,
                                   SubsystemWork<Plane>&) noexcept;
template void calc_loop_columns(const Subsystem<Space>&, std::size_t, const SubsystemWork<Space>&,
                                SubsystemData<Space>&) noexcept;
template void fill_loop_matrix(const Subsystem<Space>&, const SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;
template void load_joints_by_loops(const Subsystem<Space>&, const SubsystemData<Space>&,
                                   SubsystemWork<Space>&) noexcept;

}  // namespace spoke::structured
