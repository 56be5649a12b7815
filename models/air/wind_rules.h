#pragma once

// Ranges of the numbers of a wind, and the rules that its description keeps: the reader of files,
// the check of what is filled in code and make_wind() go by them.

#include <string>

#include "models/air/wind_keys.h"
#include "models/wind.h"

namespace spoke::air {

/// A fault of a description: the path of its key, "turbulence.width", and what is wrong and
/// expected. Both empty: there is none.
struct WindFault {
  std::string key;
  std::string text;

  explicit operator bool() const { return !text.empty(); }
};

/// Velocities of a box, each of three components: what fits into the memory of any machine.
inline constexpr double kMostBoxValues = 2e7;
/// Operations for the coherence of a box, some tens of seconds.
inline constexpr double kMostBoxOperations = 1e11;

/// Whether a file of this name is TurbSim's binary.
bool is_bts(const std::string& file);

/// Returns the direction of the wind, a unit vector: that of its velocity, +x if that is zero.
Eigen::Vector3d direction_of(const Wind& wind);

/// Finds a fault of a description, whatever stands in its file.
WindFault find_wind_fault(const Wind& wind);

}  // namespace spoke::air
