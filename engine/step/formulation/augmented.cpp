// Assembles the augmented system, (P 4) to (P 6), and solves it by LU.

#include "engine/step/formulation/augmented.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/tree_joints.h"

namespace spoke::augmented {
namespace {

/// Fills the rows and columns of one body: mass, force.
template <class World>
void add_body(const BodyData<World>& body, const subsystem::DenseBlocks& elastic, bool implicit,
              int first, Work& work) {
  const int n = dense_size(*body.model->body);
  calc_dense_mass(body, *elastic[implicit], implicit, work.matrix.block(first, first, n, n));
  calc_dense_force(body, work.right.segment(first, n));
}

/// Fills in the handle that carries a joint, in the joint's rows from `row` on: R^T T J_h of its
/// body or, at the hub, R^T T.
template <class World, class Joint>
void add_carrier(const SubsystemData<World>& subsystem, const TreeBody<World>& child,
                 const Joint& joint, int i, int row, Work& work) {
  constexpr int d = World::kTwist;
  if (child.parent < 0) {
    work.matrix.block<d, d>(row, work.hub[i]) = tree::carrying_matrix<World>(joint);
    return;
  }
  const BodyData<World>& parent = subsystem.bodies[child.parent];
  const int n = dense_size(*parent.model->body);
  auto block = work.matrix.block(row, work.first[i][child.parent], d, n);
  calc_handle_jacobian(parent, child.handle, block);
  for (int c = 0; c < n; ++c)
    block.col(c) = tree::carry_to_child<World>(joint, TwistOf<World>(block.col(c)));
  work.right.segment<d>(row) -= tree::carry_to_child<World>(
      joint, calc_handle_bias(parent, child.handle, subsystem.twists[child.parent]));
}

/// Fills in the coordinates of a joint, from column `first` on: R^T H in the joint's rows, and as
/// rows of their own (R^T H)^T F + share q'' = tau.
template <class World, class Joint>
void add_coordinates(const Joint& joint, int row, int first, Work& work) {
  if constexpr (tree::kHasJointCoordinates<World>) {
    for (int c = 0; c < joint.coordinates; ++c) {
      const auto k = static_cast<std::size_t>(c);
      work.matrix.block<World::kTwist, 1>(row, first + c) =
          joint.R.inverse() * TwistOf<World>(joint.columns.col(c));
      work.matrix(first + c, first + c) = joint.share[k];
      work.right[first + c] = joint.tau[k];
    }
  }
}

/// Fills the rows of the joint inboard of body j of subsystem i.
template <class World>
void add_joint(const Subsystem<World>& model, const SubsystemData<World>& subsystem, int i, int j,
               Work& work) {
  constexpr int d = World::kTwist;
  const auto joint = joint_of(model, subsystem, static_cast<std::size_t>(j));
  const BodyData<World>& child = subsystem.bodies[j];
  const int row = work.first_joint[i][j], first = work.first[i][j];
  const int n = dense_size(*child.model->body);
  auto block = work.matrix.block(row, first, d, n);
  calc_handle_jacobian(child, 0, block);
  block = -block;
  work.right.segment<d>(row) = calc_handle_bias(child, 0, subsystem.twists[j]) -
                               joint.R.inverse() * TwistOf<World>(joint.bias);
  add_carrier(subsystem, model.bodies[j], joint, i, row, work);
  add_coordinates<World>(joint, row, first + n, work);
}

/// Subtracts the place of a loop on a body from row `row`.
template <class World>
void subtract_place(const LoopPlaceModel& place, const TwistOf<World>& u,
                    const SubsystemData<World>& subsystem, int i, int row, Work& work) {
  const BodyData<World>& body = subsystem.bodies[place.body];
  const int n = dense_size(*body.model->body);
  auto J = work.jacobian.leftCols(n);
  calc_handle_jacobian(body, place.handle, J);
  work.matrix.block(row, work.first[i][place.body], 1, n) -= u.transpose().lazyProduct(J);
  work.right[row] += u.dot(calc_handle_bias(body, place.handle, subsystem.twists[place.body]));
}

/// Subtracts the coordinates of a coupling from row `row`.
template <class World>
void subtract_coordinates(const LoopModel& coupling, const SubsystemData<World>& subsystem, int i,
                          int row, Work& work) {
  for (const CoupledCoordinate& at : coupling.coupled) {
    if (at.is_driven) continue;
    const int n = dense_size(*subsystem.bodies[at.body].model->body);
    work.matrix(row, work.first[i][at.body] + n + at.component) -= at.ratio;
  }
}

/// Fills the rows of the loops of subsystem i.
template <class World>
void add_loops(const Subsystem<World>& model, const SubsystemData<World>& subsystem, int i,
               Work& work) {
  for (std::size_t k = 0; k < model.loops.size(); ++k)
    for (int r = subsystem.loops.paths[k].first_row, end = r + subsystem.loops.paths[k].rows;
         r < end; ++r) {
      const LoopRowState<World>& state = subsystem.loops.states[static_cast<std::size_t>(r)];
      const int row = work.first_loop[i] + r;
      work.right[row] = -state.target;
      work.matrix(row, row) = -state.compliance;
      if (model.loops[k].is_shared()) continue;
      if (model.loops[k].is_coupling()) {
        subtract_coordinates(model.loops[k], subsystem, i, row, work);
        continue;
      }
      work.matrix.template block<1, World::kTwist>(row, work.hub[i]) = -state.hub.transpose();
      subtract_place(model.loops[k].from, state.from, subsystem, i, row, work);
      if (model.loops[k].to.carrier == LoopPlace::Carrier::body)
        subtract_place(model.loops[k].to, state.to, subsystem, i, row, work);
    }
}

/// Fills the rows of a loop between subsystems, or of a coupling: those of the loop itself.
template <class World>
void add_shared_loop(const System<World>& system, const StepData<World>& data,
                     const SharedLoop& loop, Work& work) {
  const auto own = static_cast<std::size_t>(loop.own.subsystem);
  const int first =
      work.first_loop[own] +
      data.subsystems[own].loops.paths[static_cast<std::size_t>(loop.own.loop)].first_row;
  const auto add = [&](const LoopAt& at) {
    const auto i = static_cast<std::size_t>(at.subsystem), k = static_cast<std::size_t>(at.loop);
    const LoopModel& model = system.subsystems[i].loops[k];
    if (model.is_coupling()) {
      subtract_coordinates(model, data.subsystems[i], at.subsystem, first, work);
      return;
    }
    const LoopData<World>& loops = data.subsystems[i].loops;
    for (int r = 0; r < loops.paths[k].rows; ++r)
      subtract_place(model.from,
                     loops.states[static_cast<std::size_t>(loops.paths[k].first_row + r)].from,
                     data.subsystems[i], at.subsystem, first + r, work);
  };
  add(loop.own);
  for (const LoopAt& at : loop.ends) add(at);
}

/// Fills in the compliances that the rows of bearings share.
template <class World>
void add_shared_compliances(const SubsystemData<World>& subsystem, int i, Work& work) {
  for (const int r : subsystem.loops.bearings) {
    const int row = work.first_loop[i] + r;
    work.matrix(row + 1, row) = work.matrix(row, row + 1) =
        -subsystem.loops.states[static_cast<std::size_t>(r)].shared_compliance;
  }
}

/// Takes the place of rows whose forces are no unknowns: they are given, or zero.
template <class World>
void give_forces(const SubsystemData<World>& subsystem, int i, Work& work) {
  const LoopData<World>& loops = subsystem.loops;
  for (std::size_t r = 0; r < loops.use.size(); ++r) {
    const bool is_share = loops.level[r] == LoopRowLevel::share;
    if (!is_share && is_solved(loops.use[r], subsystem.progress->control.is_implicit)) continue;
    const Eigen::Index row = work.first_loop[i] + static_cast<Eigen::Index>(r);
    work.matrix.row(row).setZero();
    work.matrix(row, row) = 1.0;
    const bool is_given = !is_share && loops.use[r] != LoopRowUse::dropped;
    work.right[row] = is_given ? loops.states[r].force : 0.0;
  }
}

template <class World>
void add_hub(const System<World>& system, const StepData<World>& data, Work& work) {
  constexpr int d = World::kTwist;
  typename BodyTypes<World>::HubStiffening stiffening;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    if (system.subsystems[i].rotor < 0)  // else its rotor's hub has it
      for (const BodyData<World>& body : data.subsystems[i].bodies)
        stiffening += body.terms.stiffening;
  TwistMatrixOf<World> mass = calc_hub_mass(system.hub);
  rotary(mass) -= stiffening.inertia;
  TwistOf<World> force = calc_hub_force(system.hub, data.hub, data.hub_solution);
  angular(force) += calc_stiffening_moment(stiffening, angular(data.hub.twist));
  work.matrix.topLeftCorner<d, d>() = mass;
  work.right.head<d>() = force;
  const TwistOf<World> given = calc_prescribed_acceleration(
      system, data.progress[0].control.time, data.hub, data.hub_coordinates.a[World::kAxial]);
  int row = work.first_hub_multiplier;
  for (int c = 0; c < d; ++c)
    if (is_prescribed(system.hub, c)) {
      work.matrix(row, c) = 1.0;
      work.right[row++] = given[c];
    }
}

/// Lets the shares of a loop between subsystems have its forces.
template <class World>
void share_rows(const SharedLoop& loop, const StepData<World>& data, Work& work) {
  const auto rows_of = [&](const LoopAt& at) {
    const auto i = static_cast<std::size_t>(at.subsystem);
    const LoopPath& path = data.subsystems[i].loops.paths[static_cast<std::size_t>(at.loop)];
    return std::span(work.loop_rows[i])
        .subspan(static_cast<std::size_t>(path.first_row), static_cast<std::size_t>(path.rows));
  };
  const auto own = rows_of(loop.own);
  const auto share = [&](const LoopAt& at) {
    std::copy(own.begin(), own.end(), rows_of(at).begin());
  };
  for (const LoopAt& at : loop.ends) share(at);
  for (const LoopAt& at : loop.on_hubs) share(at);
}

void copy_lower_to_upper(Work& work) {
  // A hub alone has no joints.
  const Eigen::Index coordinates =
      work.first_joint.empty() ? work.first_hub_multiplier : work.first_joint[0][0];
  const Eigen::Index constraints = work.matrix.rows() - coordinates;
  work.matrix.topRightCorner(coordinates, constraints) =
      work.matrix.bottomLeftCorner(constraints, coordinates).transpose();
}

}  // namespace

template <class World>
void allocate(const System<World>& system, std::vector<std::vector<subsystem::DenseBlocks>> elastic,
              StepData<World>& data, Work& work) {
  assert(elastic.size() == data.subsystems.size());
  constexpr int d = World::kTwist;
  work.elastic = std::move(elastic);
  int next = d;
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    work.first.emplace_back();
    for (const BodyData<World>& body : subsystem.bodies) {
      work.first.back().push_back(next);
      next += dense_size(*body.model->body) + joint_coordinates(*body.model);
    }
  }
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    work.first_joint.emplace_back();
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j, next += d)
      work.first_joint.back().push_back(next);
  }
  int largest = 0;
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    work.first_loop.push_back(next);
    std::vector<int>& rows = work.loop_rows.emplace_back();
    while (std::cmp_less(rows.size(), subsystem.loops.rows)) rows.push_back(next++);
    for (const BodyData<World>& body : subsystem.bodies)
      largest = std::max(largest, dense_size(*body.model->body));
  }
  for (const SharedLoop& loop : system.shared_loops) share_rows(loop, data, work);
  work.jacobian.setZero(d, largest);
  for (const Subsystem<World>& subsystem : system.subsystems) {
    if (subsystem.rotor < 0) {
      work.hub.push_back(0);
      continue;
    }
    const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(subsystem.rotor)];
    work.hub.push_back(work.first[static_cast<std::size_t>(rotor.subsystem)]
                                 [static_cast<std::size_t>(rotor.body)]);
  }
  work.first_hub_multiplier = next;
  for (int c = 0; c < d; ++c) next += is_prescribed(system.hub, c);
  work.matrix.setZero(next, next);
  work.factor = LuFactors(next);
  work.right.setZero(next);
  work.solution.setZero(next);
  data.parts.augmented_solution =
      PartMaker(data.all_parts)
          .cover("augmented solution", Mark::none,
                 memory_of(work.solution.data(), static_cast<std::size_t>(next)));
}

template <class World>
void solve(const System<World>& system, StepData<World>& data, Work& work) noexcept {
  assert(data.is_coupled && work.first.size() == system.subsystems.size());
  assert(work.right.size() == work.matrix.rows());
  constexpr int d = World::kTwist;
  work.matrix.setZero();
  work.right.setZero();
  set_applied(system, data);
  add_hub(system, data, work);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const SubsystemData<World>& subsystem = data.subsystems[i];
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      add_body(subsystem.bodies[j], work.elastic[i][j], data.progress[0].control.is_implicit,
               work.first[i][j], work);
      add_joint(system.subsystems[i], subsystem, static_cast<int>(i), static_cast<int>(j), work);
    }
    add_loops(system.subsystems[i], subsystem, static_cast<int>(i), work);
    add_shared_compliances(subsystem, static_cast<int>(i), work);
  }
  for (const SharedLoop& loop : system.shared_loops) add_shared_loop(system, data, loop, work);
  copy_lower_to_upper(work);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    give_forces(data.subsystems[i], static_cast<int>(i), work);
  work.factor.compute(work.matrix);
  work.factor.solve(work.right, work.solution);

  HubSolution<World>& solution = data.hub_solution;
  solution.acceleration = work.solution.head<d>();
  solution.reaction.setZero();
  int row = work.first_hub_multiplier;
  for (int c = 0; c < d; ++c)
    if (is_prescribed(system.hub, c)) solution.reaction[c] = -work.solution[row++];
}

template <class World>
PartList parts_of_solution(const StepData<World>& data) {
  PartList list{data.parts.hub_state, data.parts.hub_coordinates};
  for (const RotorParts& rotor : data.parts.rotors) list.push_back(rotor.carried);
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    const SubsystemParts& own = subsystem.parts;
    graph::add_to(list, own.all(&BodyParts::terms), own.tiles(), own.rotations, own.twists);
    for (const BodyParts& body : own.bodies) graph::add_to(list, graph::maybe(body.tension));
    // Jacobians depend on the deformation; inboard nodes stand fixed, but places of loops may be on
    // any body.
    PartList coordinates = own.all(&BodyParts::coordinates);
    if (own.loops.is_empty())
      coordinates.pop_back();
    else
      list.push_back(own.loops.motion);
    graph::add_to(list, coordinates);
  }
  return list;
}

template <class World>
void recover_wrenches(int i, const Subsystem<World>& subsystem, const Work& work,
                      SubsystemData<World>& data) noexcept {
  assert(i >= 0 && std::cmp_less(i, work.first_joint.size()));
  assert(data.bodies.size() == subsystem.bodies.size());
  const std::vector<int>& rows = work.first_joint[i];
  set_wrenches(
      subsystem, [&](int j) { return work.solution.segment<World::kTwist>(rows[j]); }, data);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const TreeBody<World>& body = subsystem.bodies[j];
    const int first = work.first[i][j] + dense_size(*body.body);
    std::copy_n(work.solution.data() + first, joint_coordinates(body),
                joint_accelerations(data.bodies[j]));
  }
}

template <class World>
void take_loop_forces(int i, const Work& work, SubsystemData<World>& data) noexcept {
  assert(i >= 0 && std::cmp_less(i, work.first_loop.size()));
  for (int r = 0; r < data.loops.rows; ++r)
    data.loops.multipliers[static_cast<std::size_t>(r)] =
        work.solution[work.loop_rows[i][static_cast<std::size_t>(r)]];
}

template <class World>
void recover_body(int subsystem, int body, const Work& work, BodyData<World>& data,
                  double* a) noexcept {
  assert(subsystem >= 0 && std::cmp_less(subsystem, work.first.size()));
  assert(body >= 0 && std::cmp_less(body, work.first[subsystem].size()));
  store_dense_acceleration(
      work.solution.segment(work.first[subsystem][body], dense_size(*data.model->body)), data, a);
}

template void allocate(const System<Plane>&, std::vector<std::vector<subsystem::DenseBlocks>>,
                       StepData<Plane>&, Work&);
template void solve(const System<Plane>&, StepData<Plane>&, Work&) noexcept;
template PartList parts_of_solution(const StepData<Plane>&);
template void recover_wrenches(int, const Subsystem<Plane>&, const Work&,
                               SubsystemData<Plane>&) noexcept;
template void take_loop_forces(int, const Work&, SubsystemData<Plane>&) noexcept;
template void take_loop_forces(int, const Work&, SubsystemData<Space>&) noexcept;
template void recover_body(int, int, const Work&, BodyData<Plane>&, double*) noexcept;
template void allocate(const System<Space>&, std::vector<std::vector<subsystem::DenseBlocks>>,
                       StepData<Space>&, Work&);
template void solve(const System<Space>&, StepData<Space>&, Work&) noexcept;
template PartList parts_of_solution(const StepData<Space>&);
template void recover_wrenches(int, const Subsystem<Space>&, const Work&,
                               SubsystemData<Space>&) noexcept;
template void recover_body(int, int, const Work&, BodyData<Space>&, double*) noexcept;

}  // namespace spoke::augmented
