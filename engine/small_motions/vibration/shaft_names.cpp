// Sums the motion of nodes by mass.

#include "engine/small_motions/vibration/shaft_names.h"

namespace spoke::vibration {

ShaftMotion describe_shaft(const SubsystemShape& shape, double speed) {
  constexpr double kFlat = 0.02;  // twice the ratio of axes of an ellipse that counts as a line
  double across = 0.0, along = 0.0, about = 0.0, round = 0.0;
  for (Eigen::Index at = 0; at < shape.weighed.size(); at += 6) {
    const std::complex<double> x = shape.weighed[at], y = shape.weighed[at + 1];
    across += std::norm(x) + std::norm(y);
    round -= 2.0 * (std::conj(x) * y).imag();
    along += std::norm(shape.weighed[at + 2]);
    about += std::norm(shape.weighed[at + 5]);
  }
  if (about > across && about > along) return {"torsion", {}};
  if (along > across) return {"axial", {}};
  if (!(std::abs(round) > kFlat * across)) return {"whirl", {}};
  return {"whirl", (round > 0.0) == (speed >= 0.0) ? "forward" : "backward"};
}

}  // namespace spoke::vibration
