#pragma once

// Keys of [control].

#include "models/control.h"
#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kControlRows{
    by_hand("pitch", kTable, "a controller of collective pitch").from("none")};

inline constexpr std::array kPitchControlRows{
    by_hand("joint", kText,
            "name of the joint, of every blade or subsystem on the hub that has one of this name")
        .from("required, or `joints`")
        .within("kind `\"revolute\"`, with a `motion`, not by the program"),
    by_hand("joints", kTexts, "in place of `joint`: an array of names").within("each once"),
    number<&PitchControl::speed>(
        "speed", kSpeed,
        "set point of the hub's speed about its axle; negative where the rotor turns so")
        .required()
        .within("not 0"),
    number<&PitchControl::proportional>("proportional", Quantity::not_negative("s"),
                                        "pitch angle by the error of the speed")
        .required(),
    number<&PitchControl::integral>(
        "integral", Quantity::not_negative("rad/rad"),
        "rate of the pitch angle by the error, that is pitch angle by the integral of the error")
        .required()
        .within("0 or more, one of both greater"),
    option<&PitchControl::half_gain_angle>("half_gain_angle", Quantity::positive("rad"),
                                           "gains have the factor 1/(1 + θ/`half_gain_angle`)")
        .from("none: 1")
        .within("greater than 0 and than −`minimum`"),
    by_hand("schedule", kTable,
            "in place of it: a table with `angle` (rad, increasing) and `factor`, a smooth curve "
            "through them, constant beyond")
        .from("none")
        .within("factors greater than 0"),
    number<&PitchControl::minimum>("minimum", spatial::kAngle, "lower limit of the pitch angle θ")
        .required(),
    number<&PitchControl::maximum>("maximum", spatial::kAngle, "its upper limit").required(),
    option<&PitchControl::rate>("rate", Quantity::positive("rad/s"), "largest rate of θ")
        .from("none: any"),
    option<&PitchControl::filter>("filter", Quantity::positive("rad/s"),
                                  "corner frequency of the low-pass on the speed")
        .from("none: unfiltered"),
    by_hand("initial", kNumber, spatial::kAngle, "θ at t = 0, where the integral begins, too")
        .from("`minimum`")
        .within("`minimum` to `maximum`"),
    by_hand("sign", kWhole, "1 or −1: the joint's coordinate is its own `motion` + `sign` θ")
        .from("1")
        .within("−1 or 1")
        .of(Count{-1, 1}),
    option<&PitchControl::period>(
        "period", Quantity::positive("s"),
        "time between samples, in steps to the nearest whole number from 1 on")
        .from("a step")};

inline constexpr std::array kScheduleRows{
    by_hand("angle", kNumbers, spatial::kAngle, "pitch angles, each greater than the one before")
        .required(),
    by_hand("factor", kNumbers, Quantity::positive(""),
            "factors of the gains, one for each of `angle`")
        .required()};

}  // namespace spoke::keys
