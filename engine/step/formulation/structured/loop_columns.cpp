// What unit forces of closures do in a tree that has been eliminated: they are more right-hand
// sides of the same elimination, docs/formulation.md, section 12. Of a body that carries a loop,
// with A_h the acceleration of handle h by a unit force (' of the child at handle o, on whose body
// the loop is, else zero):
//   A_h = P_hl u  of the places l on the body,       K = X R A_0' - A_o,      f = Pi K
//   A_h += P_ho f  of the handles h before o
// in place of elimination's r and f. By reciprocity, K^T f is what the joint yields in the row:
//   D = sum u^T P_ll' u' - sum K^T Pi K',    free = sum u . a_l - sum K . (Pi r + s)
// At a root, A_0 in place of K, -(free - R^T b) in place of r, and N = T^T R Pi A_0.
// A coupling of joints has efforts e on their coordinates, and no wrench. With x and t what these
// make of s and t in tree/joint_coordinates.h,
//   f = Pi K + x,    D += -K^T x' - x^T K' + e . q''(0, t'),    free += e . q''(r)

#include <array>
#include <cassert>
#include <utility>

#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/structured/tree_elimination.h"
#include "engine/step/formulation/tree_joints.h"
#include "models/support/wide_kernels.h"

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
    for (int h = 0; h < path_.handles; ++h) at(h).setZero();
    for (int row = 0; row < path_.rows; ++row) eliminate(row);
  }

 private:
  using Vector = TwistOf<World>;

  /// Acceleration A_h of a handle of the body at hand.
  Vector& at(int h) { return data_.loops.handle(path_, h); }
  Vector& branch(int body_at, int of_loop) { return data_.loops.branch(path_, body_at, of_loop); }

  void eliminate(int of_loop) {
    LoopData<World>& loops = data_.loops;
    const auto r = static_cast<std::size_t>(path_.first_row + of_loop);
    loops.free[r] = 0.0;
    loops.hub[r] = loops.states[r].hub;
    if (loops.use[r] == LoopRowUse::dropped) return clear(of_loop);
    std::size_t joint = 0, root = path_.joints.size();
    for (int k = 0; std::cmp_less(k, path_.bodies.size()); ++k) {
      const int body = path_.bodies[static_cast<std::size_t>(k)];
      begin_body(body, r);
      for (; joint < path_.joints.size() && path_.joints[joint].parent == body; ++joint)
        eliminate_joint(path_.joints[joint], of_loop, path_.column(joint, of_loop));
      branch(k, of_loop) = at(0);
      if (subsystem_.bodies[static_cast<std::size_t>(body)].parent < 0)
        eliminate_root(body, branch(k, of_loop), r, path_.column(root++, of_loop));
    }
  }

  /// What takes no part is zero.
  void clear(int of_loop) {
    for (int k = 0; std::cmp_less(k, path_.bodies.size()); ++k) branch(k, of_loop).setZero();
    for (std::size_t k = 0; k < path_.joints.size() + path_.roots.size(); ++k)
      for (auto* columns : {&data_.loops.joints, &data_.loops.joint_forces})
        (*columns)[path_.column(k, of_loop)].setZero();
  }

  void begin_body(int body, std::size_t r) {
    const int children =
        static_cast<int>(subsystem_.bodies[static_cast<std::size_t>(body)].children.size());
    for (int h = 0; h <= children; ++h) at(h).setZero();
    for_places_on_bodies(
        loop_, data_.loops.states[r], [&](const LoopPlaceModel& place, const Vector& u) {
          if (place.body != body) return;
          for (int h = 0; h <= children; ++h)
            at(h) += respond(data_, work_, body, h, place.handle, u);
          data_.loops.free[r] += u.dot(free_acceleration(data_, work_, body, place.handle));
        });
  }

  void eliminate_joint(const LoadedJoint& joint, int of_loop, std::size_t column) {
    Vector& K = data_.loops.joints[column];
    const auto c = static_cast<std::size_t>(joint.child);
    const tree::JointElimination<World>& elimination = work_.bodies[c].joint;
    K = -at(joint.handle);
    if (joint.carries())
      K += carry_inward(joint_of(subsystem_, data_, c), branch(joint.child_at, of_loop));
    Vector f = elimination.Pi * K;
    double& free = data_.loops.free[static_cast<std::size_t>(path_.first_row + of_loop)];
    free -= K.dot(transmitted(elimination));
    if constexpr (tree::kHasJointCoordinates<World>)
      add_efforts(joint.child, elimination.response, elimination.rhs, f, free);
    data_.loops.joint_forces[column] = f;
    for (int h = 0; h < joint.handle; ++h)
      at(h) += respond(data_, work_, joint.parent, h, joint.handle, f);
  }

  /// Adds what a coupling does to the coordinates of a joint. r: its relative acceleration without
  /// unit forces.
  template <class Response>
  void add_efforts(int body, const Response& response, const Vector& r, Vector& f, double& free) {
    JointEfforts efforts;
    if (!find_efforts(loop_, body, efforts)) return;
    const int n = subsystem_.bodies[static_cast<std::size_t>(body)].joint.joint.coordinates;
    f += tree::respond_to_efforts<World>(response, efforts, n).wrench;
    std::array<double, space::Joint::kMost> a{};
    tree::recover_coordinates<World>(response, r, n, a.data());
    for (std::size_t c = 0; c < a.size(); ++c) free += efforts[c] * a[c];
  }

  void eliminate_root(int body, const Vector& A, std::size_t r, std::size_t column) {
    LoopData<World>& loops = data_.loops;
    const auto j = static_cast<std::size_t>(body);
    const tree::RootElimination<World>& root =
        work_.roots[static_cast<std::size_t>(work_.root_at[j])];
    const auto joint = joint_of(subsystem_, data_, j);
    Vector f = root.mass * A;
    loops.free[r] -= A.dot(transmitted(joint, root));
    if constexpr (tree::kHasJointCoordinates<World>)
      add_efforts(body, root.response, Vector(root.free - joint.R.inverse() * joint.bias), f,
                  loops.free[r]);
    loops.joints[column] = A;
    loops.joint_forces[column] = f;
    loops.hub[r] += translate(joint.p, Vector(joint.R * f));
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
    for (auto& row : yielded_) row.fill(0.0);
    a_ = &subsystem_.loops[a];
    b_ = &subsystem_.loops[b];
    add_joints(of_a, of_b);
    add_roots(of_a, of_b);
    for (int i = 0; i < of_a.rows; ++i)
      for (int j = 0; j < of_b.rows && (a != b || j <= i); ++j) {
        const int r = of_a.first_row + i, c = of_b.first_row + j;
        if (!takes_part(r) || !takes_part(c)) continue;
        // By masses rigid bodies yield nothing but what their joints' coordinates do.
        data_.loops.entry(r, c) = work_.by_mass ? yielded(i, j)
                                                : at_places(a, b, static_cast<std::size_t>(r),
                                                            static_cast<std::size_t>(c)) -
                                                      yielded(i, j);
      }
  }

 private:
  using Vector = TwistOf<World>;
  static constexpr std::size_t kMostRows = 6;

  bool takes_part(int row) const {
    return data_.loops.use[static_cast<std::size_t>(row)] != LoopRowUse::dropped;
  }
  double& yielded(int i, int j) {
    return yielded_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }

  double at_places(std::size_t a, std::size_t b, std::size_t r, std::size_t c) const {
    const LoopData<World>& loops = data_.loops;
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

  /// Adds K^T f' of a joint or root of each loop, by row and column.
  void add_columns(const LoopPath& a, std::size_t x, const LoopPath& b, std::size_t y) {
    assert(std::cmp_less_equal(a.rows, kMostRows) && std::cmp_less_equal(b.rows, kMostRows));
    for (int i = 0; i < a.rows; ++i)
      for (int j = 0; j < b.rows; ++j)
        yielded(i, j) +=
            data_.loops.joints[a.column(x, i)].dot(data_.loops.joint_forces[b.column(y, j)]);
  }

  /// Adds the rest of what the joint of a body yields to the efforts of couplings. `y`: as above.
  template <class Response>
  void add_efforts(int body, const Response& response, const LoopPath& b, std::size_t y) {
    JointEfforts of_a, of_b;
    if (work_.by_mass || !find_efforts(*a_, body, of_a)) return;
    const int n = subsystem_.bodies[static_cast<std::size_t>(body)].joint.joint.coordinates;
    const Vector wrench = tree::respond_to_efforts<World>(response, of_a, n).wrench;
    for (int j = 0; j < b.rows; ++j)
      yielded(0, j) += wrench.dot(data_.loops.joints[b.column(y, j)]);
    if (!find_efforts(*b_, body, of_b)) return;
    const auto to_b = tree::respond_to_efforts<World>(response, of_b, n);
    for (std::size_t c = 0; c < of_a.size(); ++c) yielded(0, 0) -= of_a[c] * to_b.acceleration[c];
  }

  /// Goes through the joints that both load, whose lists have one order. By masses those load
  /// nothing that carry no loop.
  void add_joints(const LoopPath& a, const LoopPath& b) {
    for (std::size_t m = 0, n = 0; m < a.joints.size() && n < b.joints.size();) {
      const LoadedJoint &x = a.joints[m], &y = b.joints[n];
      if (x.child == y.child) {
        if (!work_.by_mass || (x.carries() && y.carries())) add_columns(a, m, b, n);
        if constexpr (tree::kHasJointCoordinates<World>)
          add_efforts(x.child, work_.bodies[static_cast<std::size_t>(x.child)].joint.response, b,
                      n);
        ++m;
        ++n;
      } else if (x.parent > y.parent || (x.parent == y.parent && x.handle > y.handle)) {
        ++m;
      } else {
        ++n;
      }
    }
  }

  void add_roots(const LoopPath& a, const LoopPath& b) {
    for (std::size_t m = 0; m < a.roots.size(); ++m)
      for (std::size_t n = 0; n < b.roots.size(); ++n) {
        if (a.roots[m] != b.roots[n]) continue;
        add_columns(a, a.joints.size() + m, b, b.joints.size() + n);
        if constexpr (tree::kHasJointCoordinates<World>)
          add_efforts(a.roots[m], root_of(a.roots[m]).response, b, b.joints.size() + n);
      }
  }

  const tree::RootElimination<World>& root_of(int body) const {
    return work_.roots[static_cast<std::size_t>(work_.root_at[static_cast<std::size_t>(body)])];
  }

  const Subsystem<World>& subsystem_;
  const SubsystemWork<World>& work_;
  SubsystemData<World>& data_;
  const LoopModel *a_ = nullptr, *b_ = nullptr;  ///< the two at hand
  std::array<std::array<double, kMostRows>, kMostRows> yielded_;
};

}  // namespace

template <class World>
void calc_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                       const SubsystemWork<World>& work, SubsystemData<World>& data) noexcept {
  assert(loop < subsystem.loops.size());
  if (work.by_mass) return calc_loop_columns_by_mass(subsystem, loop, work, data);
  run_kernel([&]() noexcept { LoopEliminator<World>(subsystem, loop, work, data).eliminate(); });
}

namespace {

/// Returns the part that has a body's response to wrenches on its handles.
template <class World>
graph::PartId response_of(const BodyParts& body) {
  return tree::kHasJointCoordinates<World> ? body.port : body.inverse;
}

}  // namespace

template <class World>
PartList parts_of_loop_columns(const Subsystem<World>&, std::size_t loop,
                               const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  const LoopPath& path = data.loops.paths[loop];
  PartList list{own.loops.motion, own.rotations, own.effective};
  // The bias of a planar root depends on the hub's speed.
  if constexpr (!tree::kHasJointCoordinates<World>) list.push_back(own.hub_state);
  for (const int body : path.bodies)
    list.push_back(response_of<World>(own.bodies[static_cast<std::size_t>(body)]));
  for (const LoadedJoint& joint : path.joints)
    list.push_back(own.bodies[static_cast<std::size_t>(joint.child)].joint);
  return list;
}

template <class World>
void fill_loop_matrix(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  run_kernel([&]() noexcept {
    data.loops.matrix.set_zero();
    LoopCoupling<World> coupling(subsystem, work, data);
    for (std::size_t a = 0; a < subsystem.loops.size(); ++a)
      for (const int b : data.loops.meets[a]) coupling.couple(a, static_cast<std::size_t>(b));
  });
}

template <class World>
PartList parts_of_loop_matrix(const Subsystem<World>& subsystem, const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  PartList list{own.loops.motion, own.effective};
  graph::add_to(list, own.loops.columns);
  for (const LoopModel& loop : subsystem.loops)
    for (const int body : bodies_of(loop))
      list.push_back(response_of<World>(own.bodies[static_cast<std::size_t>(body)]));
  for (const int body : data.loops.coupled)  // what roots give is of the part `effective`
    if (subsystem.bodies[static_cast<std::size_t>(body)].parent >= 0)
      list.push_back(own.bodies[static_cast<std::size_t>(body)].joint);
  return list;
}

namespace {

/// Adds the efforts of a coupling, times its force, to what the joint of a body gives.
template <class Joint, class Elimination>
void load_coordinates(const LoopModel& coupling, double lambda, int body, const Joint& model,
                      Elimination& joint) {
  JointEfforts efforts;
  if (!find_efforts(coupling, body, efforts)) return;
  const auto to = tree::respond_to_efforts<Space>(joint.response, efforts, model.coordinates);
  joint.response.wrench += lambda * to.wrench;
  for (std::size_t c = 0; c < efforts.size(); ++c) joint.response.given[c] += lambda * to.given[c];
}

/// Adds the forces of a loop's rows to what the joint of a body gives; `at`: of the joint, or
/// behind these of the root, among those that the loop loads; `child_at`: place of its child in the
/// path.
template <class World, class Elimination>
void load_joint(const Subsystem<World>& subsystem, const LoopModel& loop,
                const LoopData<World>& loops, const LoopPath& path, std::size_t at, int child_at,
                int child, bool by_mass, Elimination& joint, TwistOf<World>& rhs) {
  for (int row = 0; row < path.rows; ++row) {
    const double lambda = loops.multipliers[static_cast<std::size_t>(path.first_row + row)];
    if (lambda == 0.0) continue;  // of redundant rows
    const std::size_t column = path.column(at, row);
    if constexpr (tree::kHasJointCoordinates<World>)
      if (by_mass) {
        joint.response.wrench += lambda * loops.branch(path, child_at, row);
        for (int c = 0; c < World::kMostJointCoordinates; ++c)
          joint.response.given[static_cast<std::size_t>(c)] +=
              lambda * loops.joint_forces[column][c];
        continue;
      }
    rhs += lambda * loops.joints[column];
    if constexpr (tree::kHasJointCoordinates<World>)
      load_coordinates(loop, lambda, child,
                       subsystem.bodies[static_cast<std::size_t>(child)].joint.joint, joint);
  }
}

template <class World>
void load_joints(const Subsystem<World>& subsystem, std::size_t k, const LoopData<World>& loops,
                 SubsystemWork<World>& work) {
  const LoopModel& loop = subsystem.loops[k];
  const LoopPath& path = loops.paths[k];
  for (std::size_t m = 0; m < path.joints.size(); ++m) {
    const LoadedJoint& loaded = path.joints[m];
    if (work.by_mass && !loaded.carries()) continue;
    auto& joint = work.bodies[static_cast<std::size_t>(loaded.child)].joint;
    load_joint(subsystem, loop, loops, path, m, loaded.child_at, loaded.child, work.by_mass, joint,
               joint.rhs);
  }
  for (std::size_t m = 0; m < path.roots.size(); ++m) {
    const int at = work.root_at[static_cast<std::size_t>(path.roots[m])];
    auto& root = work.roots[static_cast<std::size_t>(at)];
    load_joint(subsystem, loop, loops, path, path.joints.size() + m, path.place_of(path.roots[m]),
               path.roots[m], work.by_mass, root, root.free);
  }
}

}  // namespace

template <class World>
void load_joints_by_loops(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                          SubsystemWork<World>& work) noexcept {
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k)
    load_joints(subsystem, k, data.loops, work);
}

template void calc_loop_columns(const Subsystem<Plane>&, std::size_t, const SubsystemWork<Plane>&,
                                SubsystemData<Plane>&) noexcept;
template void fill_loop_matrix(const Subsystem<Plane>&, const SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void load_joints_by_loops(const Subsystem<Plane>&, const SubsystemData<Plane>&,
                                   SubsystemWork<Plane>&) noexcept;
template PartList parts_of_loop_columns(const Subsystem<Plane>&, std::size_t,
                                        const SubsystemData<Plane>&);
template PartList parts_of_loop_matrix(const Subsystem<Plane>&, const SubsystemData<Plane>&);
template void calc_loop_columns(const Subsystem<Space>&, std::size_t, const SubsystemWork<Space>&,
                                SubsystemData<Space>&) noexcept;
template void fill_loop_matrix(const Subsystem<Space>&, const SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;
template void load_joints_by_loops(const Subsystem<Space>&, const SubsystemData<Space>&,
                                   SubsystemWork<Space>&) noexcept;
template PartList parts_of_loop_columns(const Subsystem<Space>&, std::size_t,
                                        const SubsystemData<Space>&);
template PartList parts_of_loop_matrix(const Subsystem<Space>&, const SubsystemData<Space>&);

}  // namespace spoke::structured
