// Interpolates the matrices of bearings.

#include "models/system/bearing_model.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace spoke {

BearingCoefficients BearingModel::at(double speed) const {
  assert(!table.empty());
  if (speeds.empty() || speed <= speeds.front()) return table.front();
  if (speed >= speeds.back()) return table.back();
  const auto above = std::upper_bound(speeds.begin(), speeds.end(), speed);
  const auto i = static_cast<std::size_t>(above - speeds.begin());
  const double share = (speed - speeds[i - 1]) / (speeds[i] - speeds[i - 1]);
  const BearingCoefficients &low = table[i - 1], &high = table[i];
  return {low.stiffness + share * (high.stiffness - low.stiffness),
          low.damping + share * (high.damping - low.damping)};
}

Eigen::Matrix2d BearingModel::storing() const {
  assert(!table.empty());
  if (!speeds.empty()) return Eigen::Matrix2d::Zero();
  const Eigen::Matrix2d& K = table.front().stiffness;
  return 0.5 * (K + K.transpose());
}

BearingModel make_bearing(const BearingMatrices& matrices, const space::Position& first,
                          const space::Position& second) {
  BearingModel made;
  made.axis = cross(first, second);
  made.speeds = matrices.speed;
  made.table.resize(std::max<std::size_t>(1, matrices.speed.size()));
  assert(matrices.stiffness.empty() || matrices.stiffness.size() == made.table.size());
  assert(matrices.damping.empty() || matrices.damping.size() == made.table.size());
  for (std::size_t i = 0; i < made.table.size(); ++i) {
    if (!matrices.stiffness.empty()) made.table[i].stiffness = matrices.stiffness[i];
    if (!matrices.damping.empty()) made.table[i].damping = matrices.damping[i];
  }
  return made;
}

}  // namespace spoke
