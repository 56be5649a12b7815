#pragma once

// The paper's conventional method, (P 4) to (P 6): one dense symmetric system of the hub, all
// bodies and all multipliers, assembled and factorised whole:
//   [M0         PhiY^T  H^T] [Y''   ]   [Q0   ]
//   [     M     Phi^T      ] [q''   ] = [Q    ]     H: the hub's prescribed components
//   [PhiY Phi              ] [lambda]   [gamma]
//   [H                     ] [mu    ]   [given]
// Rows of loops are - (relative acceleration) - compliance lambda = - target, so that lambda acts
// on `from`. Joints with coordinates have these among q'', with R^T H in Phi, the implicit shares
// of their springs and dampers in M and their forces in Q (docs/formulation.md, section 11).

#include <Eigen/Core>

#include "engine/bodies/table/step_data.h"
#include "engine/step/formulation/subsystem.h"
#include "engine/support/dense.h"

namespace spoke::augmented {

struct Work {
  std::vector<std::vector<subsystem::DenseBlocks>> elastic;  ///< by subsystem and body
  /// First row of each body's coordinates: [X; q], behind them those of its inboard joint.
  std::vector<std::vector<int>> first;
  std::vector<std::vector<int>> first_joint;  ///< first row of each joint's multipliers
  std::vector<int> hub;         ///< by subsystem: first row of the hub that carries it
  std::vector<int> first_loop;  ///< by subsystem: first row of its loops' multipliers
  /// By subsystem and row of its loops, the row that has the multiplier: of a share that of the
  /// loop.
  std::vector<std::vector<int>> loop_rows;
  Eigen::MatrixXd jacobian;  ///< of one handle, d x the largest body
  int first_hub_multiplier = 0;
  Eigen::MatrixXd matrix;
  LuFactors factor;
  Eigen::VectorXd right;
  Eigen::VectorXd solution;
};

template <class World>
void allocate(const System<World>& system, std::vector<std::vector<subsystem::DenseBlocks>> elastic,
              StepData<World>& data, Work& work);

/// Assembles and solves (P 4); writes the hub's solution and `work.solution`.
template <class World>
void solve(const System<World>& system, StepData<World>& data, Work& work) noexcept;
/// Returns the parts that the solution depends on.
template <class World>
PartList parts_of_solution(const StepData<World>& data);

/// Sets the wrenches on the handles of subsystem i, from the multipliers, and the accelerations of
/// its joints' coordinates.
template <class World>
void recover_wrenches(int i, const Subsystem<World>& subsystem, const Work& work,
                      SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_wrenches(std::size_t i, const StepData<World>& data) {
  return {data.parts.augmented_solution, data.subsystems[i].parts.rotations};
}

/// Sets the multipliers of the loops of subsystem i.
template <class World>
void take_loop_forces(int i, const Work& work, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on.
template <class World>
PartList parts_of_loop_forces(const StepData<World>& data) {
  return {data.parts.augmented_solution};
}

/// Sets the accelerations of a body, from the solution.
template <class World>
void recover_body(int subsystem, int body, const Work& work, BodyData<World>& data,
                  double* a) noexcept;

}  // namespace spoke::augmented
