#pragma once

// Zero of a function of one variable between two places where its signs differ.

#include <algorithm>
#include <cmath>

namespace spoke::air {

/// Returns a zero of a continuous function between x and y, where its values are of opposite sign,
/// by Chandrupatla (Advances in Engineering Software 28 (1997) 145-149): inverse quadratic
/// interpolation where it is safe, else halving. Exact to this share of the zero.
template <class Function>
double find_zero(const Function& function, double x, double value_x, double y, double value_y,
                 double relative = 1e-14) {
  constexpr double absolute = 1e-300;
  constexpr int most = 200;
  double share = value_x / (value_x - value_y);  // first the secant
  for (int k = 0; k < most; ++k) {
    const double next = x + share * (y - x);
    const double value = function(next);
    double z = x, value_z = value_x;
    if ((value > 0.0) != (value_x > 0.0)) {
      z = y;
      value_z = value_y;
      y = x;
      value_y = value_x;
    }
    x = next;
    value_x = value;
    const bool x_is_best = std::abs(value_x) < std::abs(value_y);
    const double best = x_is_best ? x : y;
    const double least = (relative * std::abs(best) + absolute) / std::abs(y - x);
    if (value_x == 0.0 || !(least < 0.5)) return x_is_best ? x : y;
    const double xi = (x - y) / (z - y), phi = (value_x - value_y) / (value_z - value_y);
    share = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
      share = value_x / (value_y - value_x) * (value_z / (value_y - value_z)) +
              (z - x) / (y - x) * (value_x / (value_z - value_x)) * (value_y / (value_z - value_y));
    share = std::clamp(share, least, 1.0 - least);
  }
  return x;
}

}  // namespace spoke::air
