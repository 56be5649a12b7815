// Interpolates in a box of wind.

#include "models/air/wind_box.h"

#include <cmath>
#include <limits>

namespace spoke::air {
namespace {

/// A point between two of a row: weights of a linear interpolation.
struct RowPlace {
  std::size_t lower, upper;
  double share;  ///< of the upper one
};

/// Finds a place on a row of `count` points that are one apart. What lies outside, or is no number,
/// is at an end.
RowPlace find_in_row(double place, std::size_t count) {
  const auto last = static_cast<double>(count - 1);
  if (!(place > 0.0)) return {0, 0, 0.0};
  if (place >= last) return {count - 1, count - 1, 0.0};
  const auto lower = static_cast<std::size_t>(place);
  return {lower, lower + 1, place - static_cast<double>(lower)};
}

/// Finds a time, in steps, on a row of times that begins again behind its end.
RowPlace find_in_cycle(double time, std::size_t count) {
  const auto period = static_cast<double>(count);
  const double within = time - period * std::floor(time / period);
  if (!(within > 0.0) || within >= period) return {0, 0, 0.0};
  const auto lower = static_cast<std::size_t>(within);
  return {lower, lower + 1 == count ? 0 : lower + 1, within - static_cast<double>(lower)};
}

}  // namespace

double WindBox::end() const {
  if (is_periodic) return std::numeric_limits<double>::infinity();
  return static_cast<double>(n_t - 1) * dt - start - half_width() / speed;
}

WindBox WindBox::average() const {
  WindBox mean{n_y, n_z, 1, dy, dz, dt, speed, bottom, true, 0.0, {}};
  const std::size_t by_time = 3 * n_y * n_z;
  for (std::size_t i = 0; i < by_time; ++i) {
    double sum = 0.0;
    for (std::size_t t = 0; t < n_t; ++t) sum += values[t * by_time + i];
    mean.values.push_back(static_cast<float>(sum / static_cast<double>(n_t)));
  }
  return mean;
}

Eigen::Vector3d WindBox::velocity(double along, double across, double height, double t) const {
  const double time = (t + start - along / speed) / dt;
  const RowPlace at_t = is_periodic ? find_in_cycle(time, n_t) : find_in_row(time, n_t);
  const RowPlace at_y = find_in_row((across + half_width()) / dy, n_y);
  const RowPlace at_z = find_in_row((height - bottom) / dz, n_z);
  const double y = at_y.share;
  const double z = at_z.share;
  const auto at_time = [&](std::size_t step) -> Eigen::Vector3d {
    const auto value = [&](std::size_t k, std::size_t j) {
      return Eigen::Map<const Eigen::Vector3f>(&values[index(step, k, j)]).cast<double>();
    };
    return (1.0 - z) *
               ((1.0 - y) * value(at_z.lower, at_y.lower) + y * value(at_z.lower, at_y.upper)) +
           z * ((1.0 - y) * value(at_z.upper, at_y.lower) + y * value(at_z.upper, at_y.upper));
  };
  return (1.0 - at_t.share) * at_time(at_t.lower) + at_t.share * at_time(at_t.upper);
}

}  // namespace spoke::air
