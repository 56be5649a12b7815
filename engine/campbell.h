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

/// Speeds and modes of a Campbell diagram.
struct CampbellOptions {
  /// Ascending, two or more [rad/s]. Of several rotors on a support those of the first; the others
  /// turn by the ratios of the speeds that their drives lead to.
  std::vector<double> speeds{};
  /// Number of modes to follow, as in ModeOptions; none: as many as there are, up to `most`.
  std::optional<int> count = std::nullopt;
  int most = 6;
  /// None: `fixed` for a rotor on a support, else `turning`.
  std::optional<ModeFrame> frame = std::nullopt;
  int harmonics = 6;  ///< number of excitation lines, from once per revolution on
  int threads = 0;    ///< among which speeds are distributed; 0: all that are available
  /// Called on the calling thread with the number of speeds that are done. An exception that it
  /// throws ends the search.
  std::function<void(std::size_t)> progress{};
};

/// A mode that was followed from speed to speed.
struct CampbellBranch {
  std::string name;  ///< name of its modes at most speeds
  std::string of;    ///< Mode::of of its modes at most speeds
  /// By speed, the index of its mode in ModesResult::modes; none where it was not found again.
  std::vector<std::optional<std::size_t>> modes;
};

/// A speed at which the frequency of a mode is a multiple of the speed.
struct CampbellCrossing {
  std::size_t branch = 0;
  int harmonic = 1;        ///< per revolution
  double speed = 0.0;      ///< interpolated [rad/s]
  double frequency = 0.0;  ///< of the mode at that speed [rad/s]
  /// Distance of that speed from the one that the drive of the scenario leads to, by the latter;
  /// none if the latter is zero or not known.
  std::optional<double> margin;
};

/// A speed without a diagram.
struct CampbellGap {
  std::size_t speed = 0;  ///< index in CampbellOptions::speeds
  std::string reason;     ///< why no equilibrium was found
};

/// A branch that ends: its mode is not found again, as it is none of the lowest modes there, or its
/// shape changes within less than a thousandth of the step.
struct CampbellLoss {
  std::size_t branch = 0;
  std::size_t last = 0;  ///< index of the last speed at which its mode was found
  std::size_t lost = 0;  ///< index of the speed at which it was not
};

/// A Campbell diagram.
struct CampbellResult {
  std::vector<ModesResult> states;  ///< by speed; a gap has a speed, but no modes
  std::vector<CampbellGap> gaps;    ///< in order of speeds
  std::vector<CampbellBranch> branches;
  std::vector<CampbellCrossing> crossings;  ///< in order of branch, harmonic and speed
  std::vector<CampbellLoss> losses;         ///< in order of branches
};

/// Finds the modes at each speed independently, and follows them by their shapes: from each speed
/// to the next, modes are paired so that the modal assurance criteria by mass have the largest sum;
/// where that is in doubt, speeds between the two are looked at. A branch that cannot be followed
/// ends. A speed at which no equilibrium is found is a gap, across which modes are followed. Throws
/// like solve_modes(), but DivergenceError only if it would at all speeds but one; InputError
/// unless speeds ascend and are two or more.
SPOKE_EXPORT CampbellResult solve_campbell(const Scenario& scenario,
                                           const CampbellOptions& options);

}  // namespace spoke
