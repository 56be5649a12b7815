#pragma once

// The state-space matrices of a model about its steady motion.

#include <Eigen/SparseCore>
#include <optional>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// A row or column of a matrix.
struct LinearSignal {
  std::string name;
  std::string unit;  ///< SI; "1": a factor
};

/// Small motions about an equilibrium:
///
///     x' = A x + B u,   y = C x + D u.
///
/// These are differences from the steady values. In the frame `turning` they are seen from the hub;
/// in the frame `fixed` from outside, with amplitudes in the place of the values of equal blades:
/// that of blade b at the azimuth psi_b is collective + cosine cos psi_b + sine sin psi_b + ..., of
/// states, inputs and outputs alike. Of several rotors on a support all is named as that of one,
/// what belongs to the hub or the axle of a further one with its name before it: "tail.hub / force
/// x".
struct LinearSystem {
  EquilibriumResult equilibrium;  ///< may be that of a free hub without supports
  ModeFrame frame = ModeFrame::turning;
  Eigen::SparseMatrix<double> A, B, C, D;
  /// Signals of x: coordinates of the hub that are free, or of its support, then those of each
  /// blade from root to tip, or of each pattern of blades, then the rates of all in the same order.
  std::vector<LinearSignal> states;
  /// Signals of u: by blade, or by family and pattern, the factors of its loads and the efforts at
  /// its free joints, then the factors of loads on hubs and the forces on their free coordinates,
  /// including the torques of drives.
  std::vector<LinearSignal> inputs;
  /// Signals of y: by blade, or by family and pattern, the displacement of the tip, the scenario's
  /// sensors whose frames turn with the hub, and coordinates of free joints; then the free
  /// coordinates of each hub with their rates. From outside vectors along the hub's axes are along
  /// axes that are turned with the blade about the hub's.
  std::vector<LinearSignal> outputs;
  /// Columns of the scenario's sensors that are not among the outputs, since their values are no
  /// constant function of the state.
  std::vector<std::string> left_out;
  /// Inputs whose effects are not constant: from outside, loads that turn with the hub without
  /// being alike on all blades.
  std::vector<std::string> left_out_inputs;
};

/// Linearises a scenario's model about its equilibrium (solve_equilibrium()) as solve_modes() does,
/// with inputs and outputs (docs/modes.md). `frame`: none: `fixed` for a rotor that turns on a
/// support, else `turning`. Throws like solve_modes(); InputError if too many coordinates couple
/// for a full matrix, or for the frame `floquet`, where matrices are not constant.
SPOKE_EXPORT LinearSystem solve_linear_system(const Scenario& scenario,
                                              const SteadyState& state = {},
                                              std::optional<ModeFrame> frame = std::nullopt);

}  // namespace spoke
