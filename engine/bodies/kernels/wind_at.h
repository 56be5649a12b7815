#pragma once

// The wind as kernels and actors ask for it.

#include <Eigen/Core>
#include <limits>

#include "models/wind.h"

namespace spoke {

/// Returns the wind; what is not finite, and ends the step, if the program's own throws.
inline Eigen::Vector3d find_wind(const WindField& wind, const Eigen::Vector3d& place,
                                 double t) noexcept {
  try {
    return wind.velocity(place, t);
  } catch (...) {
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace spoke
