#pragma once

// Frequencies over the speed of rotation: the Campbell diagram.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// Over which speeds.
struct CampbellOptions {
  std::vector<double> speeds{};  ///< ascending, two or more [rad/s]
  /// Modes to follow, as in ModeOptions; none: as many as there are, up to `most`.
  std::optional<int> count = std::nullopt;
  int most = 6;
  int harmonics = 6;  ///< excitation lines, from once per revolution on
  int threads = 0;    ///< on which speeds are shared out; 0: all that are available
  /// Told, on the calling thread, how many speeds are done; what it throws ends the search.
  std::function<void(std::size_t)> progress{};
};

/// A mode that was followed from speed to speed.
struct CampbellBranch {
  std::string name;  ///< that its modes have at most speeds
  std::string of;    ///< whose, likewise
  /// By speed, which of ModesResult::modes it is; none where it was not found again.
  std::vector<std::optional<std::size_t>> modes;
};

/// Where a mode has a multiple of the speed as frequency.
struct CampbellCrossing {
  std::size_t branch = 0;
  int harmonic = 1;        ///< per revolution
  double speed = 0.0;      ///< interpolated [rad/s]
  double frequency = 0.0;  ///< there [rad/s]
  /// Distance of that speed from the one that the scenario's drive leads to, by the latter; none if
  /// that is zero or not known.
  std::optional<double> margin;
};

/// A speed without a diagram.
struct CampbellGap {
  std::size_t speed = 0;  ///< which of CampbellOptions::speeds
  std::string reason;     ///< why no equilibrium was found
};

/// A Campbell diagram.
struct CampbellResult {
  std::vector<ModesResult> states;  ///< by speed; of a gap the speed, and no modes
  std::vector<CampbellGap> gaps;    ///< by speed
  std::vector<CampbellBranch> branches;
  std::vector<CampbellCrossing> crossings;  ///< by branch, then harmonic, then speed
};

/// Finds the modes at all speeds, each on its own, and follows them by their shapes, from each
/// speed to the next those of the largest modal assurance criterion first. A speed at which no
/// equilibrium is found is a gap, over which modes are followed. Throws like solve_modes(), but
/// DivergenceError only if it would at all speeds but one; InputError unless speeds ascend and are
/// two or more.
SPOKE_EXPORT CampbellResult solve_campbell(const Scenario& scenario,
                                           const CampbellOptions& options);

}  // namespace spoke
