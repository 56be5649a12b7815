// Seeks the speed at which the air's torque balances the drive's, or the pitch.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "engine/air/find_zero.h"
#include "engine/air/rotor_coefficients.h"
#include "engine/performance.h"
#include "engine/steady/rotor_in_wind.h"
#include "engine/steady/steady_speed.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

using steady::RotorAnswer;
using steady::RotorInWind;

/// A time at which all ramps are over.
constexpr double kLate = std::numeric_limits<double>::max();

/// How well a speed or an angle is found, by itself: a state takes an equilibrium of its own.
constexpr double kResolution = 1e-7;

/// Pitch as the scenario controls it, or as it is asked for.
struct Pitch {
  std::vector<std::string> joints;
  double sign = 1.0;                  ///< of joint angles by angles towards feather
  std::optional<double> held;         ///< asked for [rad]
  std::optional<double> least, most;  ///< of a controller, towards feather [rad]
  double set_point = 0.0;             ///< of a controller [rad/s]
};

bool has_joint(const spatial::Model& model, const std::string& name) {
  const auto is_named = [&](const auto& joint) { return joint.joint.name == name; };
  return std::any_of(model.blades.begin(), model.blades.end(), [&](const spatial::Blade& blade) {
    return std::any_of(blade.joints.begin(), blade.joints.end(), is_named);
  });
}

Pitch find_pitch(const spatial::Model& model, const PerformanceOptions& options) {
  Pitch pitch;
  if (model.pitch_control) {
    const PitchControl& control = *model.pitch_control;
    pitch.joints = control.joints;
    pitch.sign = control.sign;
    pitch.least = control.minimum;
    pitch.most = control.maximum;
    pitch.set_point = control.speed;
  } else if (!options.pitch.empty()) {
    if (!has_joint(model, options.joint))
      throw InputError("no blade has a joint \"" + options.joint +
                       "\", expected the name of the joint that pitches a blade");
    pitch.joints = {options.joint};
  }
  return pitch;
}

/// A rotor with its drive.
class Performance {
 public:
  Performance(const Scenario& scenario, const PerformanceOptions& options)
      : model_(*scenario.space),
        options_(options),
        pitch_(find_pitch(model_, options)),
        rotor_(scenario, pitch_.joints, options.is_rigid) {
    for (const spatial::Blade& blade : model_.blades)
      if (blade.aerodynamics)
        radius_ = model_.hub.radius + blade.beam.length * std::cos(blade.precone);
    if (!std::holds_alternative<TorqueBySpeed>(model_.hub.drive) && options.tip_speed_ratio.empty())
      given_speed_ = steady::find_steady_speed(scenario, std::nullopt);
  }

  double radius() const { return radius_; }

  /// Returns the state in wind of a speed, at the speed that the rotor finds.
  PerformancePoint find(double wind) {
    if (!options_.pitch.empty()) pitch_.held = options_.pitch.front();
    const std::optional<double> angle = pitch_.held ? pitch_.held : least_angle();
    if (given_speed_) return evaluate(wind, *given_speed_, angle);
    const std::optional<double> speed = find_speed(wind, angle);
    if (!speed) {
      PerformancePoint gap = describe(wind, 0.0, angle.value_or(0.0), {});
      gap.gap = "the air does not turn the rotor against its drive";
      return gap;
    }
    const bool is_above = std::abs(*speed) > std::abs(pitch_.set_point);
    if (pitch_.held || !pitch_.most || !is_above) return evaluate(wind, *speed, angle);
    return hold_set_point(wind);
  }

  PerformancePoint evaluate(double wind, double speed, std::optional<double> angle) {
    return describe(wind, speed, angle.value_or(0.0), rotor_.find(wind, speed, angle));
  }

 private:
  std::optional<double> least_angle() const {
    if (!pitch_.least) return std::nullopt;
    return pitch_.sign * *pitch_.least;
  }

  /// Returns the torque of air and drive together [N m].
  double balance(double wind, double speed, std::optional<double> angle) {
    return rotor_.find(wind, speed, angle).torque + calc_torque(model_.hub.drive, kLate, speed);
  }

  /// Returns the greatest speed at which the torques balance: from a tip-speed ratio beyond any
  /// rotor's on downwards; none: they do nowhere.
  std::optional<double> find_speed(double wind, std::optional<double> angle) {
    constexpr double kFrom = 16.0, kStep = 1.0, kTo = 0.5;
    const double turn = pitch_.set_point < 0.0 ? -1.0 : 1.0;
    const auto f = [&](double ratio) {
      return turn * balance(wind, turn * ratio * wind / radius_, angle);
    };
    double above = kFrom, f_above = f(above);
    for (double ratio = kFrom - kStep; ratio >= kTo; ratio -= kStep) {
      const double f_here = f(ratio);
      if (f_here >= 0.0 && f_above < 0.0)
        return turn * wind / radius_ *
               air::find_zero(f, ratio, f_here, above, f_above, kResolution);
      above = ratio;
      f_above = f_here;
    }
    return std::nullopt;
  }

  /// Returns the state at the set point, at the least pitch that balances the torques there.
  PerformancePoint hold_set_point(double wind) {
    constexpr double kStep = 0.03;  // [rad]
    const double turn = pitch_.set_point < 0.0 ? -1.0 : 1.0;
    const auto f = [&](double theta) {
      return turn * balance(wind, pitch_.set_point, pitch_.sign * theta);
    };
    double below = *pitch_.least, f_below = f(below);
    while (below < *pitch_.most) {
      const double theta = std::min(below + kStep, *pitch_.most), f_here = f(theta);
      if (f_below >= 0.0 && f_here < 0.0) {
        const double found = air::find_zero(f, below, f_below, theta, f_here, kResolution);
        return evaluate(wind, pitch_.set_point, pitch_.sign * found);
      }
      below = theta;
      f_below = f_here;
    }
    PerformancePoint gap = describe(wind, pitch_.set_point, pitch_.sign * *pitch_.most, {});
    gap.gap = "pitch does not hold the set point within its limits";
    return gap;
  }

  PerformancePoint describe(double wind, double speed, double angle,
                            const RotorAnswer& answer) const {
    PerformancePoint point;
    point.wind = wind;
    point.speed = speed;
    point.pitch = angle;
    point.thrust = answer.thrust;
    point.torque = answer.torque;
    point.power = answer.torque * speed;
    point.tip_displacement = answer.tip_displacement;
    if (wind != 0.0) point.tip_speed_ratio = std::abs(speed) * radius_ / std::abs(wind);
    const air::RotorCoefficients coefficients = air::calc_wind_coefficients(
        {answer.thrust, answer.torque, speed, radius_, model_.air->density}, wind);
    point.thrust_coefficient = coefficients.thrust;
    point.power_coefficient = coefficients.power;
    return point;
  }

  const spatial::Model& model_;
  const PerformanceOptions& options_;
  Pitch pitch_;
  RotorInWind rotor_;
  double radius_ = 0.0;
  std::optional<double> given_speed_;
};

void require(bool holds, const char* what) {
  if (!holds) throw InputError(what);
}

void check(const Scenario& scenario, const PerformanceOptions& options) {
  require(scenario.space && scenario.space->air,
          "air: is missing, expected [air] with the aerodynamics of blades");
  require(scenario.space->hub.support == HubSupport::axle,
          "hub.support: the hub is free, expected an axle: nothing holds the rotor");
  const bool is_map = !options.tip_speed_ratio.empty();
  require(is_map || !options.wind.empty(),
          "no wind speeds and no tip-speed ratios are given, expected either");
  require(!is_map || options.wind.size() <= 1,
          "several wind speeds are given along with tip-speed ratios, expected one or none");
  require(is_map || options.pitch.size() <= 1,
          "several pitch angles are given without tip-speed ratios, expected one or none");
  for (const double wind : options.wind)
    require(wind > 0.0 && std::isfinite(wind), "a wind speed is not above 0 (m/s)");
  for (const double ratio : options.tip_speed_ratio)
    require(ratio > 0.0 && std::isfinite(ratio), "a tip-speed ratio is not above 0");
  for (const double angle : options.pitch)
    require(std::isfinite(angle), "a pitch angle is not finite");
}

}  // namespace

PerformanceResult solve_performance(const Scenario& scenario, const PerformanceOptions& options) {
  check_scenario(scenario);
  check(scenario, options);
  Performance performance(scenario, options);
  PerformanceResult result;
  result.is_map = !options.tip_speed_ratio.empty();
  result.is_rigid = options.is_rigid;
  result.radius = performance.radius();
  result.density = scenario.space->air->density;
  const auto add = [&](const std::function<PerformancePoint()>& find, PerformancePoint gap) {
    try {
      result.points.push_back(find());
    } catch (const DivergenceError& error) {
      gap.gap = error.what();
      result.points.push_back(gap);
    }
    if (options.progress) options.progress(result.points.size());
  };
  if (!result.is_map) {
    for (const double wind : options.wind)
      add([&] { return performance.find(wind); }, {.wind = wind});
    return result;
  }
  const double wind =
      options.wind.empty() ? scenario.space->air->wind.velocity.norm() : options.wind.front();
  require(wind > 0.0, "wind.velocity: is 0, expected a wind speed for the map");
  std::vector<std::optional<double>> angles(options.pitch.begin(), options.pitch.end());
  if (angles.empty()) angles.push_back(std::nullopt);
  for (const double ratio : options.tip_speed_ratio)
    for (const std::optional<double>& angle : angles) {
      const double speed = ratio * wind / result.radius;
      add([&] { return performance.evaluate(wind, speed, angle); },
          {.wind = wind, .speed = speed, .pitch = angle.value_or(0.0)});
    }
  return result;
}

}  // namespace spoke
