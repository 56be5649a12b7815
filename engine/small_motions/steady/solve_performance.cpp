// Seeks the speed or the pitch at which the air's torque balances the drive's.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "engine/bodies/air/find_zero.h"
#include "engine/bodies/air/rotor_coefficients.h"
#include "engine/performance.h"
#include "engine/small_motions/steady/rotor_in_wind.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "models/system/single_rotor.h"

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
  double stands = 0.0;                  ///< where the scenario holds the first of the joints [rad]
  double sign = 1.0;                    ///< of joint angles by angles towards feather
  std::optional<double> held;           ///< asked for [rad]
  std::optional<double> most;           ///< of a controller, towards feather [rad]
  std::function<double(double)> least;  ///< of a controller, by the wind [m/s], likewise
  double set_point = 0.0;               ///< of a controller [rad/s]
};

/// Returns the first joint of blades, or else of subsystems, of a rotor by a name; null: there is
/// none.
const spatial::Joint* find_joint(const spatial::Model& model, int rotor, const std::string& name) {
  for (const spatial::Blade& blade : model.blades)
    for (const spatial::BladeJoint& joint : blade.joints)
      if (blade.rotor == rotor && joint.joint.name == name) return &joint.joint;
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (const spatial::SubsystemJoint& joint : subsystem.joints)
      if (subsystem.rotor == rotor && joint.joint.name == name) return &joint.joint;
  return nullptr;
}

/// Whether a rotor has joints of these names.
bool has_joint(const spatial::Model& model, int rotor, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return find_joint(model, rotor, name) != nullptr;
  });
}

/// Returns the laws by which a rotor is controlled below and above rated; null: there are none.
const TurbineLaws* find_laws(const spatial::Model& model, int rotor) {
  if (rotor != 0 || !model.outer_control || !model.outer_control->laws) return nullptr;
  return &*model.outer_control->laws;
}

/// Returns the drive of a rotor: with laws of the torque that which they are in a steady state.
Drive find_drive(const spatial::Model& model, int rotor) {
  const Drive& drive = hub_of(model, rotor).drive;
  const TurbineLaws* const laws = find_laws(model, rotor);
  if (!laws || !laws->torque) return drive;
  return TorqueBySpeed{make_steady_torque(*laws->torque, model.outer_control->direction),
                       calc_initial_speed(drive)};
}

/// Returns the angle at which a joint is held, all courses over, in the mean over a turn [rad]; 0
/// if it is free.
double find_angle(const spatial::Joint* joint) {
  if (joint == nullptr || !joint->coordinates[0].motion) return 0.0;
  const spatial::Motion& motion = *joint->coordinates[0].motion;
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion))
    return table->value.value(kLate);
  if (const auto* program = std::get_if<spatial::ProgramMotion>(&motion)) return program->initial;
  return std::get<spatial::AzimuthMotion>(motion).mean;
}

Pitch find_pitch(const spatial::Model& model, int rotor, const PerformanceOptions& options) {
  Pitch pitch;
  const TurbineLaws* const laws = find_laws(model, rotor);
  if (model.pitch_control && has_joint(model, rotor, model.pitch_control->joints)) {
    const PitchControl& control = *model.pitch_control;
    pitch.joints = control.joints;
    pitch.sign = control.sign;
    pitch.least = [least = control.minimum](double) { return least; };
    pitch.most = control.maximum;
    pitch.set_point = control.speed;
  } else if (laws && laws->pitch && has_joint(model, rotor, model.outer_control->joints)) {
    const OuterControl& control = *model.outer_control;
    pitch.joints = control.joints;
    pitch.sign = control.sign;
    pitch.least = [laws](double wind) { return find_least_pitch(*laws, wind); };
    pitch.most = laws->pitch->maximum;
    pitch.set_point = control.direction * laws->pitch->speed;
  } else if (find_joint(model, rotor, options.joint) != nullptr) {
    pitch.joints = {options.joint};
  } else if (!options.pitch.empty()) {
    throw InputError("no blade has a joint \"" + options.joint +
                     "\", expected the name of the joint that pitches a blade");
  }
  if (!pitch.joints.empty())
    pitch.stands = find_angle(find_joint(model, rotor, pitch.joints.front()));
  return pitch;
}

/// A way along which the torque on a rotor falls from driving to braking: at 0 it turns at its
/// greatest speed at its least pitch; below, slower by that share; above, pitch is larger by so
/// many rad.
struct OperatingLine {
  double lowest = -1.0, highest = 0.0;
};

/// How a search along the line ended.
struct LineEnd {
  std::optional<double> place;  ///< where torque goes through zero, falling; none: nowhere
  bool drives = false;          ///< then: whether it drives up to the end, or brakes down to it
};

/// Searches a torque along the line for the zero next to a place.
template <class Torque>
LineEnd search(const OperatingLine& line, double from, const Torque& torque) {
  constexpr double kStep = 0.03;
  double here = from, value = torque(here);
  const bool drives = value >= 0.0;
  const double end = drives ? line.highest : line.lowest;
  while (here != end) {
    const double next = drives ? std::min(here + kStep, end) : std::max(here - kStep, end);
    const double next_value = torque(next);
    if ((next_value >= 0.0) != drives)
      return {air::find_zero(torque, here, value, next, next_value, kResolution)};
    here = next;
    value = next_value;
  }
  return {std::nullopt, drives};
}

/// A rotor with its drive.
class Performance {
 public:
  Performance(const Scenario& scenario, int rotor, const PerformanceOptions& options)
      : model_(*scenario.space),
        hub_(hub_of(model_, rotor)),
        drive_(find_drive(model_, rotor)),
        options_(options),
        pitch_(find_pitch(model_, rotor, options)),
        rotor_(scenario, rotor, pitch_.joints, options.is_rigid),
        rigid_(scenario, rotor, pitch_.joints, true) {
    for (const spatial::Blade& blade : model_.blades)
      if (blade.aerodynamics && blade.rotor == rotor)
        radius_ = hub_.radius + blade.beam.length * std::cos(blade.precone);
    if (radius_ == 0.0) throw InputError("no blade of the rotor has aerodynamics, expected some");
    if (!std::holds_alternative<TorqueBySpeed>(drive_) && options.tip_speed_ratio.empty())
      given_speed_ = steady::find_steady_speed(scenario, rotor, std::nullopt);
  }

  double radius() const { return radius_; }
  /// Returns the angle at which the scenario holds the pitch joints [rad].
  double standing_pitch() const { return pitch_.stands; }
  /// Returns the least angle of the pitch joints in wind of a speed [rad].
  double first_pitch(double wind) const {
    if (!options_.pitch.empty()) return options_.pitch.front();
    return least_angle(wind).value_or(pitch_.stands);
  }

  /// Returns the state in wind of a speed, at the speed that the rotor finds.
  PerformancePoint find(double wind) {
    if (!options_.pitch.empty()) pitch_.held = options_.pitch.front();
    if (given_speed_)
      return evaluate(wind, *given_speed_, pitch_.held ? pitch_.held : least_angle(wind));
    const OperatingLine line = find_line(wind);
    const LineEnd end = search_from_rigid(wind, line);
    if (end.place) return evaluate(wind, speed_at(*end.place, wind), angle_at(*end.place, wind));
    const double place = end.drives ? line.highest : line.lowest;
    PerformancePoint gap =
        describe(wind, end.drives ? speed_at(place, wind) : 0.0, angle_at(place, wind), {});
    gap.gap = !end.drives       ? "the air does not turn the rotor against its drive"
              : is_controlled() ? "pitch does not hold the set point within its limits"
                                : "the air drives the rotor beyond a tip-speed ratio of 16";
    return gap;
  }

  PerformancePoint evaluate(double wind, double speed, std::optional<double> angle) {
    return describe(wind, speed, angle, rotor_.find(wind, speed, angle));
  }

 private:
  /// Whether speed ends at a set point, which pitch holds.
  bool is_controlled() const { return pitch_.most && !pitch_.held; }

  std::optional<double> least_angle(double wind) const {
    if (!pitch_.least) return std::nullopt;
    return pitch_.stands + pitch_.sign * pitch_.least(wind);
  }

  /// The speed at 0 of the line: the set point, or one beyond any rotor's [rad/s].
  double greatest_speed(double wind) const {
    constexpr double kRatio = 16.0;
    const double turn = pitch_.set_point < 0.0 ? -1.0 : 1.0;
    return is_controlled() ? pitch_.set_point : turn * kRatio * wind / radius_;
  }

  OperatingLine find_line(double wind) const {
    constexpr double kLowest = 0.5;  // tip-speed ratio
    const double lowest = kLowest * wind / (radius_ * std::abs(greatest_speed(wind)));
    return {std::min(lowest - 1.0, 0.0), is_controlled() ? *pitch_.most - pitch_.least(wind) : 0.0};
  }

  double speed_at(double place, double wind) const {
    return greatest_speed(wind) * (1.0 + std::min(place, 0.0));
  }

  std::optional<double> angle_at(double place, double wind) const {
    if (pitch_.held) return pitch_.held;
    if (!pitch_.least) return std::nullopt;
    return *least_angle(wind) + pitch_.sign * std::max(place, 0.0);
  }

  /// Searches next to where the rigid rotor balances, which needs no equilibria of blades, and by
  /// what the elastic one was off that in the wind before: so it is never asked for states far from
  /// those sought, where blades may have none.
  LineEnd search_from_rigid(double wind, const OperatingLine& line) {
    const double turn = greatest_speed(wind) < 0.0 ? -1.0 : 1.0;
    const auto torque_of = [&](RotorInWind& rotor) {
      return [&, turn, wind](double place) {
        const double speed = speed_at(place, wind);
        return turn * (rotor.find(wind, speed, angle_at(place, wind)).torque +
                       calc_torque(drive_, kLate, speed));
      };
    };
    const LineEnd rigid = search(line, 0.0, torque_of(rigid_));
    if (options_.is_rigid) return rigid;
    const double guess = rigid.place ? *rigid.place : rigid.drives ? line.highest : line.lowest;
    const LineEnd end =
        search(line, std::clamp(guess + off_rigid_, line.lowest, line.highest), torque_of(rotor_));
    off_rigid_ = rigid.place && end.place ? *end.place - *rigid.place : 0.0;
    return end;
  }

  PerformancePoint describe(double wind, double speed, std::optional<double> angle,
                            const RotorAnswer& answer) const {
    PerformancePoint point;
    point.wind = wind;
    point.speed = speed;
    point.pitch = angle.value_or(pitch_.stands);
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
  const spatial::Hub& hub_;
  Drive drive_;
  const PerformanceOptions& options_;
  Pitch pitch_;
  RotorInWind rotor_, rigid_;
  double off_rigid_ = 0.0;  ///< where the elastic rotor balances less where the rigid one does
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

/// Returns the number of the rotor that is asked for. Throws InputError if it is not named, or not
/// there.
int choose_rotor(const spatial::Model& model, const std::string& name) {
  if (!name.empty()) return find_rotor(model, name, "the rotor");
  require(model.rotors.empty(),
          "there are several rotors, expected the name of one of them (--rotor): each has a "
          "performance of its own");
  return 0;
}

}  // namespace

PerformanceResult solve_performance(const Scenario& scenario, const PerformanceOptions& options) {
  check_scenario(scenario);
  check(scenario, options);
  Performance performance(scenario, choose_rotor(*scenario.space, options.rotor), options);
  PerformanceResult result;
  result.rotor = options.rotor;
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
      add([&] { return performance.find(wind); },
          {.wind = wind, .pitch = performance.first_pitch(wind)});
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
          {.wind = wind, .speed = speed, .pitch = angle.value_or(performance.standing_pitch())});
    }
  return result;
}

}  // namespace spoke
