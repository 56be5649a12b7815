// Filters, proportional-integral laws within limits that move, and what they keep from sample to
// sample.

#include "engine/simulation/turbine_controller.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "models/error.h"

namespace spoke {
namespace {

/// A value that follows another one, and its rate.
struct Follower {
  double value = 0.0, rate = 0.0;
};

/// Lets a value follow another one of the end of a time h [s]: x'' + 2 z w x' + w^2 x = w^2 target,
/// by the trapezoidal rule, which is stable for any h.
void follow_second_order(double frequency, double damping, double target, double h,
                         Follower& follower) {
  const double wh = frequency * h, drag = damping * wh, spring = 0.25 * wh * wh;
  const double rate =
      ((1.0 - drag - spring) * follower.rate + wh * frequency * (target - follower.value)) /
      (1.0 + drag + spring);
  follower.value += 0.5 * h * (follower.rate + rate);
  follower.rate = rate;
}

/// Lets a value follow another one that is constant in a time h [s], by w (target - x).
void follow_first_order(const std::optional<double>& frequency, double target, double h,
                        double& value) {
  const double kept = frequency ? std::exp(-*frequency * h) : 0.0;
  value = kept * value + (1.0 - kept) * target;
}

/// Limits, the lower one of which gives way where they cross.
struct Limits {
  double lower = 0.0, upper = 0.0;
  double hold(double value) const { return std::min(std::max(value, lower), upper); }
};

/// A blade's share of what the controller keeps.
struct BladeMemory {
  Follower pitch;       ///< where its actuator is [rad, rad/s]
  double demand = 0.0;  ///< of the newest sample [rad]
};

/// What the controller keeps from sample to sample.
struct Memory {
  Follower speed;                 ///< filtered [rad/s]
  double torque = 0.0;            ///< demanded [N m]
  double upper_integral = 0.0;    ///< of the law at rated speed [N m]
  double lower_integral = 0.0;    ///< of that at the least speed [N m]
  double pitch = 0.0;             ///< collective, demanded [rad]
  double pitch_integral = 0.0;    ///< [rad]
  double shift = 0.0;             ///< of set points, filtered [rad/s]
  double schedule_wind = 0.0;     ///< filtered for the schedule [m/s]
  double tilt = 0.0, turn = 0.0;  ///< integrals of individual pitch [rad]
  double yaw_error = 0.0;         ///< filtered [rad]
  double yaws = 0.0;              ///< sense in which the nacelle turns: -1, 0, 1
  std::vector<BladeMemory> blades;
};

/// Calls visit(number) for each number of a memory.
template <class M, class Visit>
void visit_memory(M& memory, const Visit& visit) {
  for (auto* number :
       {&memory.speed.value, &memory.speed.rate, &memory.torque, &memory.upper_integral,
        &memory.lower_integral, &memory.pitch, &memory.pitch_integral, &memory.shift,
        &memory.schedule_wind, &memory.tilt, &memory.turn, &memory.yaw_error, &memory.yaws})
    visit(*number);
  for (auto& blade : memory.blades) {
    visit(blade.pitch.value);
    visit(blade.pitch.rate);
    visit(blade.demand);
  }
}

class TurbineController final : public Controller {
 public:
  TurbineController(TurbineLaws laws, double initial, std::vector<double> azimuths)
      : laws_(std::move(laws)), azimuths_(std::move(azimuths)) {
    memory_.pitch = memory_.pitch_integral = initial;
    memory_.blades.assign(azimuths_.size(), {{initial, 0.0}, initial});
  }

  void control(const ControlRecord& record, ControlCommands& commands) override {
    if (record.is_first) start(record);
    const double h = record.period;
    if (laws_.filter && laws_.filter->damping)
      follow_second_order(laws_.filter->frequency, *laws_.filter->damping, record.speed, h,
                          memory_.speed);
    else
      follow_first_order(laws_.filter ? std::optional(laws_.filter->frequency) : std::nullopt,
                         record.speed, h, memory_.speed.value);
    if (laws_.schedule)
      follow_first_order(laws_.schedule->filter, record.wind_speed, h, memory_.schedule_wind);
    const double least = find_least_pitch(laws_, memory_.schedule_wind);
    if (laws_.smoothing && laws_.pitch) smooth(least, h);
    if (laws_.torque) commands.torque = -find_torque(least, h);
    if (laws_.pitch) find_pitch(least, h);
    put_blades(record, least, commands);
    if (laws_.yaw) commands.yaw_rate = find_yaw_rate(record.yaw_error, h);
  }

  std::optional<std::string> save() const override {
    std::string text;
    visit_memory(memory_, [&text](double number) {
      constexpr std::size_t most = 40;
      char digits[most];
      std::snprintf(digits, most, "%a ", number);  // to the bit
      text += digits;
    });
    return text;
  }

  void restore(const std::string& saved) override {
    Memory memory = memory_;
    const char* at = saved.c_str();
    visit_memory(memory, [&at](double& number) {
      char* end = nullptr;
      number = std::strtod(at, &end);
      if (end == at || !std::isfinite(number))
        throw InputError("the saved state is not one of [control.turbine]");
      at = end;
    });
    memory_ = std::move(memory);
  }

  std::shared_ptr<Controller> clone() const override {
    return std::make_shared<TurbineController>(*this);
  }

 private:
  /// Begins with what is measured first, as if it had been so for long.
  void start(const ControlRecord& record) {
    memory_.speed = {record.speed, 0.0};
    memory_.schedule_wind = record.wind_speed;
    memory_.yaw_error = record.yaw_error;
    if (!laws_.torque) return;
    memory_.torque = calc_straight_torque(*laws_.torque, record.speed);
    memory_.upper_integral = memory_.lower_integral = memory_.torque;
  }

  /// Shifts set points, so that pitch rests below rated, and torque is full above.
  void smooth(double least, double h) {
    constexpr double kFull = std::numbers::pi / 6.0;
    const SetPointSmoothing& law = *laws_.smoothing;
    double missing = 0.0;  // share of the power
    if (laws_.torque)
      missing =
          1.0 - memory_.torque * memory_.speed.value / (laws_.torque->rated * laws_.torque->speed);
    const double shift = laws_.pitch->speed * (law.torque_gain * (memory_.pitch - least) / kFull -
                                               law.pitch_gain * missing);
    follow_first_order(law.filter, shift, h, memory_.shift);
  }

  /// Returns the torque that a proportional-integral law of the error of the speed demands within
  /// limits. Its integral does not go beyond these.
  double find_torque_by_gains(double error, const Limits& limits, double h,
                              double& integral) const {
    const TorqueLaw& law = *laws_.torque;
    integral = limits.hold(integral + law.integral * h * error);
    return limits.hold(integral + law.proportional * error);
  }

  double find_torque(double least, double h) {
    const TorqueLaw& law = *laws_.torque;
    const double speed = memory_.speed.value, shift = std::max(memory_.shift, 0.0);
    const double rated = calc_rated_torque(law, speed);
    const double optimal = std::min(calc_optimal_torque(law, speed), rated);
    const bool is_pitched = law.switch_pitch && memory_.pitch >= least + *law.switch_pitch;
    double torque = rated;
    if (law.has_gains()) {
      torque = find_torque_by_gains(speed - law.speed + shift, {optimal, rated}, h,
                                    memory_.upper_integral);
      const double held = law.minimum ? find_torque_by_gains(speed - *law.minimum, {0.0, optimal},
                                                             h, memory_.lower_integral)
                                      : optimal;
      // The law at rated speed rests at the optimal torque, and leaves the rest to the other one.
      if (torque <= optimal) torque = held;
      if (is_pitched) torque = rated;
    } else if (!is_pitched) {
      torque = calc_straight_torque(law, speed, shift);
    }
    const double most = law.rate.value_or(std::abs(torque - memory_.torque) / h) * h;
    memory_.torque += std::clamp(torque - memory_.torque, -most, most);
    return memory_.torque;
  }

  void find_pitch(double least, double h) {
    const PitchLaw& law = *laws_.pitch;
    const double error = memory_.speed.value - (law.speed - std::min(memory_.shift, 0.0));
    const auto gain = [&](const std::vector<double>& gains) {
      return gains.empty() ? 0.0 : interpolate(law.angle, gains, memory_.pitch);
    };
    const Limits limits{least, law.maximum};
    const double integral = limits.hold(memory_.pitch_integral + gain(law.integral) * h * error);
    double change = limits.hold(integral + gain(law.proportional) * error) - memory_.pitch;
    const double most = law.rate.value_or(std::abs(change) / h) * h;
    // Where the rate is at its limit, the integral does not go on in its direction.
    const bool winds_up =
        std::abs(change) > most && (integral - memory_.pitch_integral) * change > 0.0;
    if (!winds_up) memory_.pitch_integral = integral;
    change = std::clamp(change, -most, most);
    memory_.pitch += change;
  }

  /// Returns the share in which individual pitch acts.
  double find_share(double wind) const {
    const IndividualPitch& law = *laws_.individual;
    if (!law.wind_from) return 1.0;
    return std::clamp((wind - *law.wind_from) / (*law.wind_to - *law.wind_from), 0.0, 1.0);
  }

  /// Integrates what tilts and what yaws the rotor; returns the amplitudes of the pitch against it.
  std::pair<double, double> find_individual(const ControlRecord& record) {
    const IndividualPitch& law = *laws_.individual;
    double tilt = 0.0, turn = 0.0;
    const double share = 2.0 / static_cast<double>(record.blades.size());
    for (std::size_t k = 0; k < record.blades.size(); ++k) {
      const double azimuth = record.azimuth + azimuths_[k];
      tilt += share * record.blades[k].out_of_plane_moment * std::cos(azimuth);
      turn += share * record.blades[k].out_of_plane_moment * std::sin(azimuth);
    }
    const double acts = find_share(record.wind_speed);
    const Limits limits{-law.maximum, law.maximum};
    const auto answer = [&](double moment, double& integral) {
      integral = limits.hold(integral + acts * law.integral * record.period * moment);
      return acts * limits.hold(integral + law.proportional * moment);
    };
    return {answer(tilt, memory_.tilt), answer(turn, memory_.turn)};
  }

  /// Adds individual pitch to the collective one, and lets the actuators follow.
  void put_blades(const ControlRecord& record, double least, ControlCommands& commands) {
    if (!laws_.pitch && !laws_.individual) return;
    assert(memory_.blades.size() == record.blades.size());
    std::pair<double, double> amplitude{0.0, 0.0};
    if (laws_.individual) amplitude = find_individual(record);
    const double h = record.period;
    for (std::size_t k = 0; k < memory_.blades.size(); ++k) {
      BladeMemory& blade = memory_.blades[k];
      double demand = memory_.pitch;
      if (laws_.individual) {
        const double azimuth = record.azimuth + azimuths_[k] + laws_.individual->offset;
        demand += amplitude.first * std::cos(azimuth) + amplitude.second * std::sin(azimuth);
      }
      if (laws_.pitch) {
        const double most =
            laws_.pitch->rate ? *laws_.pitch->rate * h : std::abs(demand - blade.demand);
        demand = blade.demand + std::clamp(demand - blade.demand, -most, most);
        demand = Limits{std::min(least, memory_.pitch), laws_.pitch->maximum}.hold(demand);
      }
      blade.demand = demand;
      if (laws_.actuator)
        follow_second_order(laws_.actuator->frequency, laws_.actuator->damping, demand, h,
                            blade.pitch);
      commands.pitch[k] = laws_.actuator ? blade.pitch.value : demand;
    }
  }

  double find_yaw_rate(double error, double h) {
    const YawLaw& law = *laws_.yaw;
    follow_first_order(law.filter, error, h, memory_.yaw_error);
    const double filtered = memory_.yaw_error;
    if (memory_.yaws * filtered <= 0.0) memory_.yaws = 0.0;
    if (std::abs(filtered) > law.error) memory_.yaws = std::copysign(1.0, filtered);
    return memory_.yaws * law.rate;
  }

  TurbineLaws laws_;
  std::vector<double> azimuths_;
  Memory memory_;
};

}  // namespace

std::shared_ptr<Controller> make_turbine_controller(TurbineLaws laws, double initial,
                                                    std::vector<double> azimuths) {
  return std::make_shared<TurbineController>(std::move(laws), initial, std::move(azimuths));
}

}  // namespace spoke
