// A monotone cubic curve is a straight line between two points if the secants beside it have its
// slope. The stretch before gives the integral.

#include "program/fmu/speed_course.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::fmu {

Curve speed_course(double t, double angle, double speed, double target, double step) {
  assert(t >= 0.0 && step > 0.0);
  const double slope = (target - speed) / step;
  if (t == 0.0) return Curve({-step, 0.0, step}, {speed - slope * step, speed, target});
  const double lead = std::min(step, t / 2.0);
  const double first = (t - lead) / 2.0;
  const auto through = [&](double early) {
    return Curve({first, t - lead, t, t + step}, {early, speed - slope * lead, speed, target});
  };
  const auto excess = [&](double early) { return through(early).integral(t) - angle; };
  // Secants; the integral grows with the early speed, nearly in proportion.
  double before = angle / t, now = before + 1.0;
  double error_before = excess(before), error = excess(now);
  double best = std::abs(error) < std::abs(error_before) ? now : before;
  double least = std::min(std::abs(error), std::abs(error_before));
  for (int k = 0; k < 60 && error != 0.0 && error != error_before; ++k) {
    const double next = now - error * (now - before) / (error - error_before);
    before = now;
    error_before = error;
    now = next;
    error = excess(now);
    if (std::abs(error) >= least) {
      if (k > 8) break;  // round-off is left
      continue;
    }
    best = now;
    least = std::abs(error);
  }
  return through(best);
}

}  // namespace spoke::fmu
