#pragma once

// The paper's subsystem synthesis method, (P 7) to (P 11), with dense blocks: each body's mass
// matrix is assembled and factorised whole, Phi M^-1 Phi^T of each subsystem is formed and
// factorised whole. The rows of Phi belong to the joints, resolved in the child's frame:
//   [R^T T J_h(parent), -J_0(child)] q'' = gamma,  with the hub's [R^T T] in front at the root.
// Coordinates q_J of joints have the columns R^T H there, and no mass but the share k^ that springs
// and dampers have in implicit steps. They are eliminated behind the bodies:
//   D lambda = Phi_Y Y'' + Phi M^-1 Q - gamma + R^T H q_J'',    (R^T H)^T lambda + k^ q_J'' = tau
// Sources: subsystem/invert_body, effective_inertia and recovery.

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <memory>

#include "engine/bodies/table/step_data.h"

namespace spoke::subsystem {

/// Dense elastic blocks by body type: explicit, implicit.
using DenseBlocks = std::array<std::shared_ptr<const Eigen::MatrixXd>, 2>;

/// Memory per body: M^-1 applied to the joints' rows, and the products of (P 8) and (P 10). J holds
/// the rows of all its m handles, the inboard one first.
template <class World>
struct BodyWork {
  DenseBlocks elastic;
  Eigen::MatrixXd mass;             ///< n x n; then its Cholesky factor
  Eigen::MatrixXd jacobians;        ///< J, m d x n
  Eigen::MatrixXd inverse_columns;  ///< M^-1 [J^T, Q], n x (m d + 1)
  Eigen::MatrixXd products;         ///< J M^-1 [J^T, Q], m d x (m d + 1)
  Eigen::MatrixXd biases;           ///< by handle: its acceleration at zero accelerations, d x m

  /// Returns J_a M^-1 J_b^T of two handles.
  auto compliance(int a, int b) const {
    assert(a >= 0 && a < biases.cols() && b >= 0 && b < biases.cols());
    constexpr int d = World::kTwist;
    return products.template block<d, d>(d * a, d * b);
  }
  /// Returns the acceleration of a handle without wrenches.
  TwistOf<World> free_acceleration(int handle) const {
    assert(handle >= 0 && handle < biases.cols());
    constexpr int d = World::kTwist;
    return products.col(products.cols() - 1).template segment<d>(d * handle) + biases.col(handle);
  }
};

template <class World>
struct alignas(kInterferenceSize) SubsystemWork {
  ArenaVector<BodyWork<World>> bodies;
  std::vector<int> root_of;  ///< by body: the root of its tree, which the hub carries
  Eigen::MatrixXd D;         ///< Phi M^-1 Phi^T, C1 x C1; then its Cholesky factor
  /// D^-1 [root rows, Phi M^-1 Q - gamma], C1 x (d + 1); the joints' coordinates follow. D couples
  /// no trees, which meet at the hub alone: those of all roots share the d columns.
  Eigen::MatrixXd solution;
  Eigen::VectorXd multipliers;  ///< (P 8), C1
  // Coordinates of all joints, C in number; 0 in the plane.
  std::vector<int> first_coordinate;  ///< first one of each joint
  Eigen::MatrixXd columns;            ///< R^T H, C1 x C
  Eigen::MatrixXd inverse_columns;    ///< D^-1 R^T H, C1 x C
  Eigen::MatrixXd inertia;   ///< (R^T H)^T D^-1 R^T H + k^, C x C; then its Cholesky factor
  Eigen::MatrixXd response;  ///< q_J'' by [its root's rows of Y'', 1], C x (d + 1)
  /// Of one loop, by its rows: C = Phi M^-1 u of unit forces, D^-1 C with the coordinates of joints
  /// following, and these coordinates.
  struct LoopColumns {
    Eigen::MatrixXd right, solution, response;
  };
  std::vector<LoopColumns> loops;
};

/// Allocates the work of one subsystem; `elastic`: by body.
template <class World>
void allocate(const std::vector<DenseBlocks>& elastic, SubsystemData<World>& data,
              SubsystemWork<World>& work);

/// Assembles and inverts one block of (P 11).
template <class World>
void invert_body(const BodyData<World>& data, const TwistOf<World>& twist, bool implicit,
                 BodyWork<World>& work) noexcept;
/// Returns the parts that it depends on.
template <class World>
PartList parts_of_inverted(std::size_t j, const SubsystemData<World>& data);

/// Calculates effective mass and force, (P 10).
template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept;

/// Calculates what unit forces of one loop do, and its rows' accelerations without them: its parts
/// of LoopData::hub and free.
template <class World>
void calc_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                       SubsystemWork<World>& work, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                               const SubsystemData<World>& data);

/// Fills D of the loops, from the columns of all.
template <class World>
void fill_loop_matrix(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept;
/// Returns the parts that it depends on.
template <class World>
PartList parts_of_loop_matrix(const Subsystem<World>& subsystem, const SubsystemData<World>& data);

/// Adds what the loops' forces make of the multipliers of joints and of their coordinates.
template <class World>
void load_joints_by_loops(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                          SubsystemWork<World>& work) noexcept;
/// Returns the parts that this depends on besides the forces.
template <class World>
PartList parts_of_loaded_joints(const SubsystemData<World>& data) {
  PartList list = data.parts.loops.columns;
  graph::add_to(list, data.parts.effective);
  return list;
}

/// Calculates the multipliers, (P 8), as wrenches on the handles, and the accelerations of the
/// joints' coordinates.
template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_wrenches(const SubsystemData<World>& data) {
  return {data.parts.effective, data.parts.rotations, data.parts.hub_acceleration};
}

/// Calculates the accelerations of a body, (P 7).
template <class World>
void recover_body(const SubsystemData<World>& subsystem, std::size_t j, const BodyWork<World>& work,
                  BodyData<World>& data, double* a) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_recovered(std::size_t j, const SubsystemData<World>& data) {
  return {data.parts.wrenches, data.parts.bodies[j].inverse};
}

}  // namespace spoke::subsystem
