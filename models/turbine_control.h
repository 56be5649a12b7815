#pragma once

// The laws of a wind turbine's controller, below and above rated, as data: [control.turbine] of
// docs/scenario.md. Speeds, angles and torques count in the sense in which the rotor turns, on the
// hub's side of a gearbox; a generator's torque is positive here.

#include <optional>
#include <string_view>
#include <vector>

#include "models/curve.h"
#include "spoke/export.h"

namespace spoke {

/// Returns the value at a place of straight lines through points, constant before and after.
/// `at`: strictly increasing; `values`: as many, or one that holds everywhere.
SPOKE_EXPORT double interpolate(const std::vector<double>& at, const std::vector<double>& values,
                                double place);

/// The low-pass on the measured speed.
struct SpeedFilter {
  double frequency = 0.0;                        ///< [rad/s]
  std::optional<double> damping = std::nullopt;  ///< share of critical; none: of first order
};

/// What the generator's torque becomes at rated speed.
enum class AboveRated { torque, power };
SPOKE_EXPORT std::string_view name_of(AboveRated above);

/// The generator's torque. Below rated it is square w^2, or that of a table; from rated on it is
/// constant, or its power is. Between both it is a straight line over the speed from `transition`
/// to `speed`; or, with gains, that of a proportional-integral law of the error from `speed`,
/// between the former and the latter.
struct TorqueLaw {
  double square = 0.0;                                ///< [N m s^2]
  std::vector<double> table_speed{}, table_torque{};  ///< in place of it [rad/s, N m]
  double speed = 0.0;                                 ///< from which on it is rated [rad/s]
  double rated = 0.0;                                 ///< torque there [N m]
  AboveRated above = AboveRated::power;
  std::optional<double> transition = std::nullopt;  ///< none: 0.95 `speed` [rad/s]
  double proportional = 0.0;                        ///< of the error [N m s]
  double integral = 0.0;                            ///< of its integral [N m]
  /// Speed below which the same gains let go of the generator [rad/s]; none: no such speed.
  std::optional<double> minimum = std::nullopt;
  std::optional<double> maximum = std::nullopt;  ///< of the torque [N m]; none: no limit
  std::optional<double> rate = std::nullopt;     ///< largest rate of the torque [N m/s]
  /// Pitch beyond its least angle from which on the torque is that above rated at any speed [rad];
  /// none: only the speed counts.
  std::optional<double> switch_pitch = std::nullopt;

  /// Whether a proportional-integral law makes the transition.
  bool has_gains() const { return proportional != 0.0 || integral != 0.0; }
};

/// Collective pitch: a proportional-integral law of the speed beyond a set point. The pitch angle
/// grows towards feather.
struct PitchLaw {
  double speed = 0.0;                         ///< set point [rad/s]
  std::vector<double> angle{};                ///< pitch angles of the gains [rad]; none: one gain
  std::vector<double> proportional{};         ///< at these, of any sign [s]
  std::vector<double> integral{};             ///< likewise [rad/rad]
  double minimum = 0.0;                       ///< of the pitch angle [rad]
  double maximum = 0.0;                       ///< [rad]
  std::optional<double> rate = std::nullopt;  ///< largest rate of the pitch angle [rad/s]
};

/// The least pitch angle by the wind, in place of PitchLaw::minimum where that is less: for little
/// wind, and to shave the peak of the thrust.
struct PitchSchedule {
  std::vector<double> wind{}, angle{};          ///< [m/s, rad]
  std::optional<double> filter = std::nullopt;  ///< corner frequency of a low-pass on it [rad/s]
};

/// Set points that give way to one another, so that torque and pitch do not work against each other
/// at rated (Abbas, Zalkind, Pao & Wright 2022): the shift is the set point of pitch by
///   torque_gain (theta - minimum)/(30 degrees) - pitch_gain (1 - power/rated power),
/// filtered; where it is positive the torque's speeds are lower by it, else that of pitch higher.
struct SetPointSmoothing {
  double torque_gain = 0.0;
  double pitch_gain = 0.0;
  double filter = 0.0;  ///< corner frequency [rad/s]
};

/// Pitch of each blade by itself against what tilts and yaws the rotor: moments at the roots, in
/// axes that do not turn, by a proportional-integral law of each.
struct IndividualPitch {
  double proportional = 0.0;                       ///< [rad/(N m)]
  double integral = 0.0;                           ///< [rad/(N m s)]
  double maximum = 0.0;                            ///< of either amplitude [rad]
  double offset = 0.0;                             ///< of the azimuth at which it acts [rad]
  std::optional<double> wind_from = std::nullopt;  ///< wind speed from which it begins [m/s]
  std::optional<double> wind_to = std::nullopt;    ///< from which it acts in full [m/s]
};

/// What moves a blade to the pitch that is demanded: x'' + 2 z w x' + w^2 x = w^2 demanded.
struct PitchActuator {
  double frequency = 0.0;  ///< w [rad/s]
  double damping = 0.0;    ///< z
};

/// Yaw at a constant rate, from an error on, until it is none.
struct YawLaw {
  double rate = 0.0;                            ///< [rad/s]
  double error = 0.0;                           ///< at which it begins [rad]
  std::optional<double> filter = std::nullopt;  ///< corner frequency of a low-pass on it [rad/s]
};

/// A controller of a wind turbine.
struct TurbineLaws {
  std::optional<SpeedFilter> filter = std::nullopt;
  std::optional<TorqueLaw> torque = std::nullopt;  ///< none: that of the scenario's drive
  std::optional<PitchLaw> pitch = std::nullopt;    ///< none: pitch stays
  std::optional<PitchSchedule> schedule = std::nullopt;
  std::optional<SetPointSmoothing> smoothing = std::nullopt;
  std::optional<IndividualPitch> individual = std::nullopt;
  std::optional<PitchActuator> actuator = std::nullopt;
  std::optional<YawLaw> yaw = std::nullopt;
};

/// Returns the torque below rated at a speed [rad/s] [N m].
SPOKE_EXPORT double calc_optimal_torque(const TorqueLaw& law, double speed);
/// Returns the torque above rated there, at most `maximum` [N m].
SPOKE_EXPORT double calc_rated_torque(const TorqueLaw& law, double speed);
/// Returns the torque at a speed [rad/s] that the straight way of the transition gives [N m];
/// `shift`: by which the speeds of the transition are lower [rad/s].
SPOKE_EXPORT double calc_straight_torque(const TorqueLaw& law, double speed, double shift = 0.0);
/// Returns the torque of a drive in steady states over the speed of the hub [rad/s, N m], which
/// turns in the sense of `direction`, 1 or -1: negative where that is positive.
SPOKE_EXPORT Curve make_steady_torque(const TorqueLaw& law, double direction);
/// Returns the least pitch angle in a wind of a speed [m/s] [rad]; without a pitch law 0.
SPOKE_EXPORT double find_least_pitch(const TurbineLaws& laws, double wind);

}  // namespace spoke
