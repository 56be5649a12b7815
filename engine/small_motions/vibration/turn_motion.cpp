// Sums up harmonics of a motion and of its rates.

#include "engine/small_motions/vibration/turn_motion.h"

#include <numbers>

#include "engine/small_motions/steady/steady_model.h"
#include "engine/small_motions/vibration/turn_series.h"

namespace spoke::vibration {

double TurnMotion::azimuth(Eigen::Index l) const {
  return 2.0 * std::numbers::pi * static_cast<double>(l) / static_cast<double>(parts());
}

TurnMotion make_turn_motion(const Eigen::MatrixXcd& harmonics, double speed) {
  const Eigen::Index parts = 2 * harmonics.cols() - 1;
  const Eigen::MatrixXcd rates = speed * differ_by_azimuth(harmonics);
  return {sum_harmonics(harmonics, parts), sum_harmonics(rates, parts),
          sum_harmonics(speed * differ_by_azimuth(rates), parts)};
}

void place_hub(const TurnMotion& motion, Eigen::Index l, Eigen::Index hub,
               steady::SteadyModel& model) {
  model.move_hub(motion.azimuth(l) + motion.x.col(l).head(hub).sum(),
                 motion.v.col(l).head(hub).sum(), motion.a.col(l).head(hub).sum());
}

}  // namespace spoke::vibration
