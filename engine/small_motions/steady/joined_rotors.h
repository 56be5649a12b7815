#pragma once

// Linear models of several rotors on a support as one, whose hubs' coordinates follow one another:
// six of each, and nothing between them before they stand on their support.

#include <vector>

#include "engine/small_motions/steady/linear_model.h"

namespace spoke::steady {

/// Returns the rows of a rotor in a matrix whose rows are the components of all hubs.
inline auto rows_of(std::size_t rotor, Eigen::MatrixXd& m) {
  return m.middleRows(6 * static_cast<Eigen::Index>(rotor), 6);
}
inline auto rows_of(std::size_t rotor, const Eigen::MatrixXd& m) {
  return m.middleRows(6 * static_cast<Eigen::Index>(rotor), 6);
}

/// Joins linear models of rotors, each with all components of its hub. `subsystems`: by rotor the
/// numbers that its subsystems then have, from 0 on without a gap.
LinearModel join_rotors(const std::vector<LinearModel>& rotors,
                        const std::vector<std::vector<std::size_t>>& subsystems);

/// Returns one of the rotors that were joined. `subsystems`: the numbers of its subsystems.
LinearModel take_rotor(const LinearModel& all, std::size_t rotor,
                       const std::vector<std::size_t>& subsystems);

}  // namespace spoke::steady
