#pragma once

// Which mode of a state is which one of another state.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/modes.h"

namespace spoke::vibration {

/// Whether a mode whose frequency passes zero goes on. Its root is then the conjugate of the one
/// before, and so is its shape: a whirl, seen from the turning frame, turns the other way.
enum class ThroughZero { no, yes };

/// Smallest likeness of a mode and the one that it goes on as.
constexpr double kLeastLikeness = 0.5;

/// How the modes of one state go on in another.
struct ModeMatch {
  std::vector<std::optional<std::size_t>> next;  ///< by mode of the first state; none: nowhere
  /// By mode of the first state, from 0 to 1: how much of the one shape, by mass, is in the other
  /// one, or in the modes that have the same root as this one, of which any combination is a mode.
  std::vector<double> likeness;
  /// Modal assurance criterion of all pairs, by mass.
  Eigen::MatrixXd criterion;
};

/// Pairs the modes of two states so that the modal assurance criteria |a^H M b|^2 / (a^H M a b^H M
/// b) of all pairs have the largest sum. Only modes of one subsystem make pairs.
ModeMatch match_modes(const ModesResult& from, const ModesResult& to, ThroughZero through_zero);

/// Returns the first subsystem that moves in a mode.
std::size_t first_subsystem(const Mode& mode);

}  // namespace spoke::vibration
