// Assembles the augmented system, (P 4) to (P 6), and solves it by LU.

#include "engine/formulation/augmented.h"

#include "engine/formulation/dense_body.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/hub_solve.h"

namespace spoke::augmented {
namespace {

/// Rows and columns of one body: mass, force.
template <class World>
void add_body(const BodyData<World>& body, const Eigen::MatrixXd& elastic, int first, Work& work) {
  const int n = dense_size(*body.model->body);
  calc_dense_mass(body, elastic, work.matrix.block(first, first, n, n));
  calc_dense_force(body, work.right.segment(first, n));
}

/// Rows of the joint inboard of body j of subsystem i: child's part, and the parent body's.
template <class World>
void add_joint(const SubsystemData<World>& subsystem, int i, int j, Work& work) {
  constexpr int d = World::kTwist;
  const BodyData<World>& child = subsystem.bodies[j];
  const int row = work.first_joint[i][j];
  const int n = dense_size(*child.model->body);
  auto child_block = work.matrix.block(row, work.first[i][j], d, n);
  calc_inboard_jacobian(child, child_block);
  child_block = -child_block;
  if (j == 0) return;
  const BodyData<World>& parent = subsystem.bodies[j - 1];
  const auto back = subsystem.joints[j].R.inverse();
  const int m = dense_size(*parent.model->body);
  auto parent_block = work.matrix.block(row, work.first[i][j - 1], d, m);
  calc_outboard_jacobian(parent, parent_block);
  for (int c = 0; c < m; ++c) parent_block.col(c) = back * TwistOf<World>(parent_block.col(c));
  work.right.segment<d>(row) -= back * calc_outboard_bias(parent, angular(subsystem.twists[j - 1]));
}

/// The hub's part of the root joint's rows.
template <class World>
void add_root_joint(const Subsystem<World>& subsystem, const SubsystemData<World>& data, int row,
                    Work& work) {
  constexpr int d = World::kTwist;
  auto joint = make_root_joint(subsystem, data);
  const TwistOf<World> none = TwistOf<World>::Zero();
  work.right.segment<d>(row) -= calc_root_acceleration<World>(joint, none);
  joint.bias = none;
  for (int c = 0; c < d; ++c)
    work.matrix.block<d, 1>(row, c) =
        calc_root_acceleration<World>(joint, TwistOf<World>(TwistOf<World>::Unit(c)));
}

template <class World>
void add_hub(const System<World>& system, const StepData<World>& data, Work& work) {
  constexpr int d = World::kTwist;
  typename World::HubStiffening stiffening;
  for (const SubsystemData<World>& subsystem : data.subsystems)
    for (const BodyData<World>& body : subsystem.bodies) stiffening += body.terms.stiffening;
  TwistMatrixOf<World> mass = calc_hub_mass(system.hub);
  rotary(mass) -= stiffening.inertia;
  TwistOf<World> force = calc_hub_force(system.hub, data.hub, data.hub_solution);
  angular(force) += calc_stiffening_moment(stiffening, angular(data.hub.twist));
  work.matrix.topLeftCorner<d, d>() = mass;
  work.right.head<d>() = force;
  const TwistOf<World> given = calc_prescribed_acceleration(
      system, data.progress[0].control.time, data.hub.R, data.hub_coordinates.a[World::kAxial]);
  int row = work.first_hub_multiplier;
  for (int c = 0; c < d; ++c)
    if (is_prescribed(system.hub, c)) {
      work.matrix(row, c) = 1.0;
      work.right[row++] = given[c];
    }
}

void copy_lower_to_upper(Work& work) {
  const Eigen::Index constraints = work.matrix.rows() - work.first_joint[0][0];
  const Eigen::Index coordinates = work.first_joint[0][0];
  work.matrix.topRightCorner(coordinates, constraints) =
      work.matrix.bottomLeftCorner(constraints, coordinates).transpose();
}

}  // namespace

template <class World>
void allocate(const System<World>& system, const StepData<World>& data,
              std::vector<std::vector<subsystem::DenseBlocks>> elastic, Work& work) {
  constexpr int d = World::kTwist;
  work.elastic = std::move(elastic);
  int next = d;
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    work.first.emplace_back();
    for (const BodyData<World>& body : subsystem.bodies) {
      work.first.back().push_back(next);
      next += dense_size(*body.model->body);
    }
  }
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    work.first_joint.emplace_back();
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j, next += d)
      work.first_joint.back().push_back(next);
  }
  work.first_hub_multiplier = next;
  for (int c = 0; c < d; ++c) next += is_prescribed(system.hub, c);
  work.matrix.setZero(next, next);
  work.factor = Eigen::PartialPivLU<Eigen::MatrixXd>(next);
  work.right.setZero(next);
  work.solution.setZero(next);
}

template <class World>
void solve(const System<World>& system, StepData<World>& data, Work& work) noexcept {
  constexpr int d = World::kTwist;
  work.matrix.setZero();
  work.right.setZero();
  set_applied(system, data);
  add_hub(system, data, work);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const SubsystemData<World>& subsystem = data.subsystems[i];
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      add_body(subsystem.bodies[j], *work.elastic[i][j][data.progress[0].control.is_implicit],
               work.first[i][j], work);
      add_joint(subsystem, static_cast<int>(i), static_cast<int>(j), work);
    }
    add_root_joint(system.subsystems[i], subsystem, work.first_joint[i][0], work);
  }
  copy_lower_to_upper(work);
  work.factor.compute(work.matrix);
  work.solution.noalias() = work.factor.solve(work.right);

  HubSolution<World>& solution = data.hub_solution;
  solution.acceleration = work.solution.head<d>();
  solution.reaction.setZero();
  int row = work.first_hub_multiplier;
  for (int c = 0; c < d; ++c)
    if (is_prescribed(system.hub, c)) solution.reaction[c] = -work.solution[row++];
}

template <class World>
void recover_wrenches(int subsystem, const Work& work, SubsystemData<World>& data) noexcept {
  constexpr int d = World::kTwist;
  const std::vector<int>& rows = work.first_joint[subsystem];
  for (std::size_t j = 0; j < rows.size(); ++j) {
    data.wrenches[j].inboard = work.solution.segment<d>(rows[j]);
    data.wrenches[j].outboard.setZero();
    if (j + 1 < rows.size())
      data.wrenches[j].outboard =
          -(data.joints[j + 1].R * TwistOf<World>(work.solution.segment<d>(rows[j + 1])));
  }
}

template <class World>
void recover_body(int subsystem, int body, const Work& work, BodyData<World>& data,
                  double* a) noexcept {
  store_dense_acceleration(
      work.solution.segment(work.first[subsystem][body], dense_size(*data.model->body)), data, a);
}

template void allocate(const System<Plane>&, const StepData<Plane>&,
                       std::vector<std::vector<subsystem::DenseBlocks>>, Work&);
template void solve(const System<Plane>&, StepData<Plane>&, Work&) noexcept;
template void recover_wrenches(int, const Work&, SubsystemData<Plane>&) noexcept;
template void recover_body(int, int, const Work&, BodyData<Plane>&, double*) noexcept;

}  // namespace spoke::augmented
