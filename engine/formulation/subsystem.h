#pragma once

// The paper's subsystem synthesis method, (P 7) to (P 11), with dense blocks: each body's mass
// matrix is assembled and factorised whole, Phi M^-1 Phi^T of each subsystem is formed and
// factorised whole. The rows of Phi belong to the joints, resolved in the child's frame:
//   [R^T J_out(parent), -J_in(child)] q'' = gamma,  with the hub's [R^T T] in front at the root.
// Sources: subsystem/invert_body, effective_inertia and recovery.

#include <Eigen/Core>
#include <array>
#include <memory>

#include "engine/table/step_data.h"

namespace spoke::subsystem {

/// Dense elastic blocks by body type: explicit, implicit.
using DenseBlocks = std::array<std::shared_ptr<const Eigen::MatrixXd>, 2>;

/// Per body: M^-1 applied to what the joints need, and the products of (P 8) and (P 10).
template <class World>
struct BodyWork {
  DenseBlocks elastic;
  Eigen::MatrixXd mass;             ///< n x n; then its Cholesky factor
  Eigen::MatrixXd jacobians;        ///< [J_in; J_out], 2d x n
  Eigen::MatrixXd inverse_columns;  ///< M^-1 [J_in^T, J_out^T, Q], n x (2d + 1)
  Eigen::MatrixXd products;         ///< [J_in; J_out] M^-1 [J_in^T, J_out^T, Q], 2d x (2d + 1)
  TwistOf<World> bias_out;          ///< acceleration of the outboard handle at zero accelerations
};

template <class World>
struct alignas(kInterferenceSize) SubsystemWork {
  ArenaVector<BodyWork<World>> bodies;
  Eigen::MatrixXd D;            ///< Phi M^-1 Phi^T, C1 x C1; then its Cholesky factor
  Eigen::MatrixXd solution;     ///< D^-1 [root rows, Phi M^-1 Q - gamma], C1 x (d + 1)
  Eigen::VectorXd multipliers;  ///< (P 8), C1
};

template <class World>
void allocate(const SubsystemData<World>& data, const std::vector<DenseBlocks>& elastic,
              SubsystemWork<World>& work);

/// Assembles and inverts one block of (P 11).
template <class World>
void invert_body(const BodyData<World>& data, const AngularOf<World>& speed, bool implicit,
                 BodyWork<World>& work) noexcept;

/// Effective mass and force, (P 10).
template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept;

/// Multipliers, (P 8), as wrenches on the handles.
template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept;

/// Accelerations of a body, (P 7).
template <class World>
void recover_body(const typename BodyTypes<World>::HandleWrenches& wrenches,
                  const BodyWork<World>& work, BodyData<World>& data, double* a) noexcept;

}  // namespace spoke::subsystem
