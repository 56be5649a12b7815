#pragma once

// The paper's conventional method, (P 4) to (P 6): one dense symmetric system of the hub, all
// bodies and all multipliers, assembled and factorised whole:
//   [M0         PhiY^T  H^T] [Y''   ]   [Q0   ]
//   [     M     Phi^T      ] [q''   ] = [Q    ]     H: the hub's prescribed components
//   [PhiY Phi              ] [lambda]   [gamma]
//   [H                     ] [mu    ]   [given]

#include <Eigen/Core>
#include <Eigen/LU>

#include "engine/formulation/subsystem.h"
#include "engine/table/step_data.h"

namespace spoke::augmented {

struct Work {
  std::vector<std::vector<subsystem::DenseBlocks>> elastic;  ///< by subsystem and body
  std::vector<std::vector<int>> first;        ///< first row of each body's coordinates
  std::vector<std::vector<int>> first_joint;  ///< first row of each joint's multipliers
  int first_hub_multiplier = 0;
  Eigen::MatrixXd matrix;
  Eigen::PartialPivLU<Eigen::MatrixXd> factor;
  Eigen::VectorXd right;
  Eigen::VectorXd solution;
};

template <class World>
void allocate(const System<World>& system, const StepData<World>& data,
              std::vector<std::vector<subsystem::DenseBlocks>> elastic, Work& work);

/// Assembles and solves (P 4); writes the hub's solution and `work.solution`.
template <class World>
void solve(const System<World>& system, StepData<World>& data, Work& work) noexcept;

/// Wrenches on the handles of a subsystem, from the multipliers.
template <class World>
void recover_wrenches(int subsystem, const Work& work, SubsystemData<World>& data) noexcept;

/// Accelerations of a body, from the solution.
template <class World>
void recover_body(int subsystem, int body, const Work& work, BodyData<World>& data,
                  double* a) noexcept;

}  // namespace spoke::augmented
