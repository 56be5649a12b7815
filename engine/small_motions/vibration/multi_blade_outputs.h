#pragma once

// What a rotor shows that is seen from outside.

#include <string>
#include <vector>

#include "engine/linearize.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// What each blade of a family shows, by its own motion and the hub's. Vectors along the hub's axes
/// are along axes that are turned with the blade about the hub's.
struct BladeOutputs {
  std::vector<LinearSignal> signals;  ///< without the name of the blade
  /// By the independent coordinates of the blade, and where loops tie it to others by those of each
  /// blade further on in their ring.
  std::vector<Eigen::MatrixXd> by_y, by_rate;
  /// By all components of the hub's motion along standing axes, seen from the blade: see
  /// stand_columns(). Of a shaft all is along standing axes.
  SecondOrder by_hub;
  /// Rows that are outputs of the model, SteadyModel::outputs(); joints' coordinates follow.
  std::vector<Eigen::Index> shown;
};

/// Finds what all blades of a family show. Adds the columns of sensors that are on some only, and
/// those of a shaft that turn with it, to `left_out`. `axes`: of all components of a twist.
BladeOutputs find_outputs(const BladeFamily& family, const Linearised& all,
                          const StandingAxes& axes, std::vector<std::string>& left_out);

}  // namespace spoke::vibration
