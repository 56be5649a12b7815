#pragma once

// Keys of [control].

#include "models/control.h"
#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kControlRows{
    by_hand("pitch", kTable, "a controller of collective pitch").from("none"),
    by_hand("library", kTable, "in its place: a library of Bladed's kind").from("none"),
    by_hand("program", kTable, "in its place: a controller that the program gives").from("none"),
    by_hand("turbine", kTable,
            "in its place: laws of a wind turbine; without them, what events move")
        .from("none")};

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

/// The keys that [control.program], [control.library] and [control.turbine] share: what moves.
inline constexpr std::array kOuterControlRows{
    by_hand("joint", kText,
            "name of the pitch joint, of every blade or subsystem on the hub that has one of this "
            "name")
        .from("none")
        .within("kind `\"revolute\"`, with a `motion`, not by the program"),
    by_hand("joints", kTexts, "in place of `joint`: an array of names").within("each once"),
    number<&OuterControl::initial>("initial", spatial::kAngle, "pitch angle θ at t = 0"),
    by_hand("sign", kWhole, "1 or −1: the joint's coordinate is its own `motion` + `sign` θ")
        .from("1")
        .within("−1 or 1")
        .of(Count{-1, 1}),
    by_hand("yaw_joint", kText,
            "name of the joint of the support that follows the demanded rate of yaw")
        .from("none")
        .within("as of `joint`"),
    by_hand("direction", kWhole,
            "sense in which the rotor turns about its axis: speeds, azimuths and torques count "
            "along it")
        .from("1")
        .within("−1 or 1")
        .of(Count{-1, 1}),
    number<&OuterControl::brake_torque>("brake_torque", Quantity::not_negative("N m"),
                                        "of the shaft brake that is on, on the hub's side"),
    number<&OuterControl::brake_speed>("brake_speed", Quantity::positive("rad/s"),
                                       "of the hub, from which on the brake has that torque"),
    option<&OuterControl::period>(
        "period", Quantity::positive("s"),
        "time between samples, in steps to the nearest whole number from 1 on")
        .from("a step")};

inline constexpr std::array kLibraryRows{
    by_hand("file", kText, "the library, by a path from the scenario's folder").required(),
    by_hand("input", kText,
            "`accINFILE`, the file that the library reads, by a path from the scenario's folder")
        .from("none: an empty name"),
    by_hand("name", kText, "`avcOUTNAME`, with which the names of files begin that it writes")
        .from("the file of the library without its ending"),
    option<&OuterControl::gear_ratio>("gear_ratio", Quantity::positive(""),
                                      "turns of the generator for one of the hub")
        .from("that of the drive train, or 1")
        .within("greater than 0; not with a drive train"),
    flag<&OuterControl::individual_pitch>("individual_pitch",
                                          "whether it demands the pitch of each blade by itself")
        .within("at most 3 blades"),
    number<&OuterControl::efficiency>("efficiency", Quantity::not_negative(""),
                                      "electrical power by that of the generator's shaft"),
    by_hand("record", kTables, "numbers of its array that sensors give").from("none")};

inline constexpr Count kRecordNumbers{1, 10000};
inline constexpr std::array kLibraryRecordRows{
    by_hand("number", kWhole, "in `avrSWAP`, from 1").required().of(kRecordNumbers),
    by_hand("sensor", kText, "name of a column of `sensors.csv`").required(),
    number<&LibraryRecord::factor>("factor", Quantity::any(""), "number by value of the sensor")};

inline constexpr std::array kScheduleRows{
    by_hand("angle", kNumbers, spatial::kAngle, "pitch angles, each greater than the one before")
        .required(),
    by_hand("factor", kNumbers, Quantity::positive(""),
            "factors of the gains, one for each of `angle`")
        .required()};

}  // namespace spoke::keys
