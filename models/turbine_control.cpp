// Torques and angles that laws give, without any memory.

#include "models/turbine_control.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace spoke {
namespace {

constexpr double kTransition = 0.95;  // of rated speed

}  // namespace

double interpolate(const std::vector<double>& at, const std::vector<double>& values, double place) {
  assert(!values.empty() && (values.size() == 1 || values.size() == at.size()));
  if (values.size() == 1) return values.front();
  const auto after = std::upper_bound(at.begin(), at.end(), place);
  if (after == at.begin()) return values.front();
  if (after == at.end()) return values.back();
  const auto k = static_cast<std::size_t>(after - at.begin());
  const double share = (place - at[k - 1]) / (at[k] - at[k - 1]);
  return std::lerp(values[k - 1], values[k], share);
}

std::string_view name_of(AboveRated above) {
  return above == AboveRated::power ? "power" : "torque";
}

double calc_optimal_torque(const TorqueLaw& law, double speed) {
  if (!law.table_speed.empty()) return interpolate(law.table_speed, law.table_torque, speed);
  return speed > 0.0 ? law.square * speed * speed : 0.0;
}

double calc_rated_torque(const TorqueLaw& law, double speed) {
  const double most = law.maximum.value_or(std::numeric_limits<double>::infinity());
  const bool is_constant = law.above == AboveRated::torque || !(speed > 0.0);
  return std::min(is_constant ? law.rated : law.rated * law.speed / speed, most);
}

double calc_straight_torque(const TorqueLaw& law, double speed, double shift) {
  const double end = law.speed - shift;
  const double begin = law.transition.value_or(kTransition * law.speed) - shift;
  if (speed >= end) return calc_rated_torque(law, std::max(speed, law.speed));
  if (speed <= begin) return calc_optimal_torque(law, speed);
  const double first = calc_optimal_torque(law, begin);
  return std::lerp(first, calc_rated_torque(law, law.speed), (speed - begin) / (end - begin));
}

namespace {

/// Returns the torque in a steady state: where gains hold a speed, it changes there at once.
double calc_steady_torque(const TorqueLaw& law, double speed) {
  if (!law.has_gains()) return calc_straight_torque(law, speed);
  if (speed >= law.speed) return calc_rated_torque(law, speed);
  if (law.minimum && speed < *law.minimum) return 0.0;
  return std::min(calc_optimal_torque(law, speed), calc_rated_torque(law, speed));
}

/// Returns the speeds between which a law is smooth.
std::vector<double> find_corners(const TorqueLaw& law) {
  constexpr double kBeyond = 2.0;   // of rated speed
  constexpr double kAtOnce = 1e-6;  // of a speed
  std::vector<double> corners = {0.0, law.speed, kBeyond * law.speed};
  corners.insert(corners.end(), law.table_speed.begin(), law.table_speed.end());
  if (law.has_gains()) {
    corners.push_back((1.0 - kAtOnce) * law.speed);
    if (law.minimum) corners.insert(corners.end(), {*law.minimum, (1.0 - kAtOnce) * *law.minimum});
  } else {
    corners.push_back(law.transition.value_or(kTransition * law.speed));
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(
      std::remove_if(corners.begin(), corners.end(), [](double speed) { return speed < 0.0; }),
      corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

Curve make_steady_torque(const TorqueLaw& law, double direction) {
  constexpr int kPieces = 64;  // of a smooth part
  const std::vector<double> corners = find_corners(law);
  std::vector<double> speeds;
  for (std::size_t k = 1; k < corners.size(); ++k)
    for (int i = 0; i < kPieces; ++i)
      speeds.push_back(std::lerp(corners[k - 1], corners[k], static_cast<double>(i) / kPieces));
  speeds.push_back(corners.back());
  std::vector<double> torques;
  for (const double speed : speeds) torques.push_back(-calc_steady_torque(law, speed));
  if (direction < 0.0) {
    std::reverse(speeds.begin(), speeds.end());
    std::reverse(torques.begin(), torques.end());
    for (double& speed : speeds) speed = -speed;
    for (double& torque : torques) torque = -torque;
  }
  return {speeds, torques};
}

double find_least_pitch(const TurbineLaws& laws, double wind) {
  if (!laws.pitch) return 0.0;
  const double least = laws.pitch->minimum;
  if (!laws.schedule) return least;
  return std::clamp(interpolate(laws.schedule->wind, laws.schedule->angle, wind), least,
                    laws.pitch->maximum);
}

}  // namespace spoke
