#pragma once

// The state-space matrices of a model about its steady motion.

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// A row or column of a matrix.
struct LinearSignal {
  std::string name;
  std::string unit;  ///< SI; "1": a factor
};

/// Small motions about an equilibrium, in the frame that turns with the hub:
///
///     x' = A x + B u,   y = C x + D u.
///
/// These are differences from the steady values.
struct LinearSystem {
  EquilibriumResult equilibrium;  ///< may be that of a free hub without supports
  Eigen::SparseMatrix<double> A, B, C, D;
  /// Signals of x: coordinates of the hub that are free, then those of each blade from root to tip,
  /// then the rates of all in the same order.
  std::vector<LinearSignal> states;
  /// Signals of u: by blade the factors of its loads and the efforts at its free joints, then the
  /// factors of loads on the hub and the forces on its free coordinates, including the torque of
  /// the drive.
  std::vector<LinearSignal> inputs;
  /// Signals of y: by blade the displacement of the tip, the scenario's sensors whose frames turn
  /// with the hub, and coordinates of free joints; then the free coordinates of the hub with their
  /// rates.
  std::vector<LinearSignal> outputs;
  /// Columns of the scenario's sensors that are not among the outputs, since their values are no
  /// constant function of the state.
  std::vector<std::string> left_out;
};

/// Linearises a scenario's model about its equilibrium (solve_equilibrium()) as solve_modes() does,
/// with inputs and outputs (docs/modes.md). Throws like solve_modes(); InputError if blades couple
/// through the hub and have too many coordinates for a full matrix.
SPOKE_EXPORT LinearSystem solve_linear_system(const Scenario& scenario,
                                              const SteadyState& state = {});

}  // namespace spoke
