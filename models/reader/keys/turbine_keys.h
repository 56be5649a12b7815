#pragma once

// Keys of the laws of [control.turbine].

#include <string_view>

#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"
#include "models/turbine_control.h"

namespace spoke::keys {

inline constexpr std::array kSpeedFilterRows{
    number<&SpeedFilter::frequency>("frequency", Quantity::positive("rad/s"),
                                    "corner frequency of the low-pass on the measured speed")
        .required(),
    option<&SpeedFilter::damping>("damping", Quantity::positive(""),
                                  "share of critical damping of one of second order")
        .from("none: of first order")};

inline constexpr std::array kTorqueLawRows{
    number<&TorqueLaw::square>("square", Quantity::not_negative("N m s^2"),
                               "torque below rated by the square of the speed"),
    stations<&TorqueLaw::table_speed>(
        "table_speed", kSpeed, "in place of `square`: speeds, each greater than the one before")
        .from("none"),
    stations<&TorqueLaw::table_torque>("table_torque", Quantity::not_negative("N m"),
                                       "torques at these, straight lines between")
        .from("none"),
    number<&TorqueLaw::speed>("speed", Quantity::positive("rad/s"),
                              "rated speed of the generator, on the hub's side of a gearbox")
        .required(),
    number<&TorqueLaw::rated>("rated", Quantity::positive("N m"),
                              "torque there, on the hub's side: rated power by `speed`")
        .required(),
    choice<&TorqueLaw::above, AboveRated::power, AboveRated::torque>(
        "above", "what is constant above rated: `\"power\"` or `\"torque\"`"),
    option<&TorqueLaw::transition>("transition", Quantity::positive("rad/s"),
                                   "speed at which a straight way to rated begins; not with gains")
        .from("0.95 `speed`")
        .within("less than `speed`"),
    number<&TorqueLaw::proportional>(
        "proportional", Quantity::not_negative("N m s"),
        "in place of it: torque by the speed beyond `speed`, between that below and that above "
        "rated"),
    number<&TorqueLaw::integral>("integral", Quantity::not_negative("N m"),
                                 "torque by the integral of that"),
    option<&TorqueLaw::minimum>("minimum", Quantity::positive("rad/s"),
                                "least speed, which the same gains hold")
        .from("none")
        .within("less than `speed`; only with gains"),
    option<&TorqueLaw::maximum>("maximum", Quantity::positive("N m"), "largest torque")
        .from("none: any"),
    option<&TorqueLaw::rate>("rate", Quantity::positive("N m/s"), "largest rate of the torque")
        .from("none: any"),
    option<&TorqueLaw::switch_pitch>(
        "switch_pitch", Quantity::positive("rad"),
        "pitch beyond its least angle from which on the torque is that above rated, whatever the "
        "speed")
        .from("none: the speed decides")};

inline constexpr std::array kPitchLawRows{
    number<&PitchLaw::speed>("speed", Quantity::positive("rad/s"), "set point of the hub's speed")
        .required(),
    stations<&PitchLaw::angle>("angle", spatial::kAngle,
                               "pitch angles of the gains, each greater than the one before")
        .from("none: one gain of each"),
    stations<&PitchLaw::proportional>(
        "proportional", Quantity::any("s"),
        "pitch angle by the speed beyond the set point, at these angles, straight lines between")
        .from("0"),
    stations<&PitchLaw::integral>("integral", Quantity::any("rad/rad"),
                                  "pitch angle by the integral of that, likewise")
        .from("0"),
    number<&PitchLaw::minimum>("minimum", spatial::kAngle, "lower limit of the pitch angle θ"),
    number<&PitchLaw::maximum>("maximum", spatial::kAngle, "its upper limit").required(),
    option<&PitchLaw::rate>("rate", Quantity::positive("rad/s"), "largest rate of θ")
        .from("none: any")};

inline constexpr std::array kPitchScheduleRows{
    stations<&PitchSchedule::wind>("wind", Quantity::not_negative("m/s"),
                                   "speeds of the measured wind, each greater than the one before")
        .required(),
    stations<&PitchSchedule::angle>("angle", spatial::kAngle,
                                    "least θ at these, straight lines between")
        .required(),
    option<&PitchSchedule::filter>("filter", Quantity::positive("rad/s"),
                                   "corner frequency of a low-pass on the wind")
        .from("none: unfiltered")};

inline constexpr std::array kSmoothingRows{
    number<&SetPointSmoothing::torque_gain>(
        "torque_gain", Quantity::not_negative(""),
        "share of the set point by which the torque's speeds fall where θ is 30 degrees above its "
        "minimum"),
    number<&SetPointSmoothing::pitch_gain>(
        "pitch_gain", Quantity::not_negative(""),
        "share by which the set point of the pitch rises where there is no power"),
    number<&SetPointSmoothing::filter>("filter", Quantity::positive("rad/s"),
                                       "corner frequency of the low-pass on that")
        .required()};

inline constexpr std::array kIndividualRows{
    number<&IndividualPitch::proportional>(
        "proportional", Quantity::any("rad/(N m)"),
        "amplitude of the pitch by the mean moment that tilts or yaws the rotor"),
    number<&IndividualPitch::integral>("integral", Quantity::any("rad/(N m s)"),
                                       "amplitude by the integral of that"),
    number<&IndividualPitch::maximum>("maximum", Quantity::positive("rad"),
                                      "largest of either amplitude")
        .required(),
    number<&IndividualPitch::offset>("offset", spatial::kAngle,
                                     "of the azimuth by which a blade is ahead of its moment"),
    option<&IndividualPitch::wind_from>("wind_from", Quantity::not_negative("m/s"),
                                        "wind speed from which on it acts by a growing share")
        .from("none: in any wind"),
    option<&IndividualPitch::wind_to>("wind_to", Quantity::positive("m/s"),
                                      "wind speed from which on it acts in full")
        .from("none")
        .within("greater than `wind_from`")};

inline constexpr std::array kActuatorRows{
    number<&PitchActuator::frequency>("frequency", Quantity::positive("rad/s"),
                                      "natural frequency of each blade's actuator")
        .required(),
    number<&PitchActuator::damping>("damping", Quantity::positive(""), "share of critical damping")
        .required()};

inline constexpr std::array kYawLawRows{
    number<&YawLaw::rate>("rate", Quantity::positive("rad/s"), "rate at which the nacelle turns")
        .required(),
    number<&YawLaw::error>(
        "error", Quantity::positive("rad"),
        "angle between axis and wind from which on it turns, until there is none")
        .required(),
    option<&YawLaw::filter>("filter", Quantity::positive("rad/s"),
                            "corner frequency of a low-pass on that angle")
        .from("none: unfiltered")};

inline constexpr std::array kLawRows{
    by_hand("filter", kTable, "low-pass on the measured speed").from("none"),
    by_hand("torque", kTable, "of the generator").from("none: that of the drive"),
    by_hand("pitch", kTable, "collective").from("none: it stays"),
    by_hand("schedule", kTable, "least pitch by the wind").from("none"),
    by_hand("smoothing", kTable, "of both set points at rated").from("none"),
    by_hand("individual", kTable, "pitch of each blade by its moment").from("none"),
    by_hand("actuator", kTable, "what moves a blade").from("none: it follows at once"),
    by_hand("yaw", kTable, "of the nacelle").from("none")};

/// Calls visit(key, rows, part) for each part of the laws, an optional structure.
template <class Laws, class Visit>
void visit_laws(Laws& laws, const Visit& visit) {
  const auto call = [&visit](std::string_view key, Rows rows, auto& part) {
    visit(key, rows, part);
  };
  call("filter", kSpeedFilterRows, laws.filter);
  call("torque", kTorqueLawRows, laws.torque);
  call("pitch", kPitchLawRows, laws.pitch);
  call("schedule", kPitchScheduleRows, laws.schedule);
  call("smoothing", kSmoothingRows, laws.smoothing);
  call("individual", kIndividualRows, laws.individual);
  call("actuator", kActuatorRows, laws.actuator);
  call("yaw", kYawLawRows, laws.yaw);
}

}  // namespace spoke::keys
