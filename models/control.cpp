// The gain schedule.

#include "models/control.h"

namespace spoke {

double calc_gain_factor(const PitchControl& control, double angle) {
  if (control.schedule) return control.schedule->value(angle);
  if (control.half_gain_angle) return 1.0 / (1.0 + angle / *control.half_gain_angle);
  return 1.0;
}

}  // namespace spoke
