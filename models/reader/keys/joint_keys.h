#pragma once

// Keys of joints in space.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kJointRows{
    by_hand("name", kText, "of the joint")
        .from("none")
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("kind", kWord, "next table")
        .required()
        .among("fixed revolute universal spherical prismatic cylindrical bushing"),
    by_hand("axis", kNumbers, spatial::kDirection,
            "`[x, y, z]`, of any length, in the joint's frame")
        .from("required where the kind has one")
        .within("not 0")
        .of(std::size_t{3}),
    by_hand("axes", kNumberArrays, "two of these, of a universal joint")
        .from("required there")
        .within("not parallel"),
    vector<&spatial::Joint::offset>("offset", kLength, "of the joint's frame in the parent's"),
    vector<&spatial::Joint::orientation>("orientation", spatial::kAngle,
                                         "rotation vector of the joint's frame in the parent's"),
    by_hand("stiffness", kNumber | kNumbers, spatial::kJointStiffness, "of a spring")
        .from("0")
        .within("0 or more"),
    by_hand("damping", kNumber | kNumbers, spatial::kJointDamping, "of a damper")
        .from("0")
        .within("0 or more"),
    by_hand(
        "free", kTexts,
        "of a bushing: directions that move without a spring and a damper, of `\"x\"`, `\"y\"`, "
        "`\"z\"`, `\"about x\"`, `\"about y\"` and `\"about z\"`")
        .from("none"),
    by_hand("rest", kNumber | kNumbers, spatial::kJointPosition,
            "coordinate at which the spring is at rest")
        .from("0"),
    by_hand("relaxation", kTable | kTables, "a spring and a damper in series: a table, below")
        .from("none")
        .as("joint.relaxation"),
    by_hand("stop", kTable | kTables, "a table, below").from("none").as("joint.stop"),
    by_hand("friction", kTable | kTables, "a table, below").from("none").as("joint.friction"),
    by_hand("initial", kNumber | kNumbers, spatial::kJointPosition, "coordinate at t = 0")
        .from("0"),
    by_hand("initial_speed", kNumber | kNumbers, spatial::kJointSpeed, "its rate at t = 0")
        .from("0"),
    flag<&spatial::Joint::hold>(
        "hold", "whether both stay as they are given where loops are closed at the start")
        .within("a joint that moves"),
    by_hand("torque", kNumber | kNumbers | kTable, kTorque,
            "that acts on the child, and against the parent: a number, or a table with `time` and "
            "`value`")
        .from("0")
        .as("joint.effort"),
    by_hand("force", kNumber | kNumbers | kTable, kForce,
            "likewise, along a `prismatic` or `cylindrical` joint's axis")
        .from("0")
        .as("joint.effort"),
    by_hand("motion", kTable | kTables,
            "a table, below: the coordinate is prescribed, and none of the keys from `stiffness` "
            "to `friction` may be given for it")
        .from("free")
        .as("joint.motion")};

inline constexpr std::array kJointStationRows{
    by_hand("station", kNumber, kStation, "where it is")
        .required()
        .within("from 0 to less than `length`; each greater than the one before")};

inline constexpr std::array kStopRows{
    by_hand("lower", kNumber, spatial::kJointPosition, "bound below which it sets in")
        .from("required"),
    by_hand("upper", kNumber, spatial::kJointPosition, "bound above which it sets in")
        .from("required"),
    by_hand("stiffness", kNumber, Quantity::positive("N m/rad, N/m"),
            "beyond `width`; both bounds have it")
        .from("required"),
    by_hand("damping", kNumber, Quantity::not_negative("N m s/rad, N s/m"),
            "of a damper that sets in by the same law")
        .from("0"),
    by_hand("width", kNumber, Quantity::positive("rad, m"), "distance over which it sets in")
        .from("required")};

inline constexpr std::array kFrictionRows{
    by_hand("force", kNumber, Quantity::positive("N m, N"), "of sliding").from("required"),
    by_hand("speed", kNumber, Quantity::positive("rad/s, m/s"),
            "over which it sets in: force · tanh(v/`speed`) at the speed v")
        .from("required"),
    by_hand("static", kNumber, Quantity::positive("N m, N"), "at the start of sliding")
        .from("`force`")
        .within("`force` or more"),
    by_hand("stribeck", kNumber, Quantity::positive("rad/s, m/s"),
            "speed over which the force falls from `static` to `force`")
        .from("required with `static`")};

inline constexpr std::array kRelaxationRows{
    by_hand("stiffness", kNumber, Quantity::positive("N m/rad, N/m"), "of the spring")
        .from("required"),
    by_hand("time", kNumber, Quantity::positive("s"),
            "in which the force of a spring that is held falls to 1/e: the damper's constant by "
            "`stiffness`")
        .from("required")};

inline constexpr std::array kMotionRows{
    by_hand("constant", kNumber, spatial::kJointPosition, "this value"),
    by_hand("time", kNumbers, kTime, "array of times, each greater than the one before"),
    by_hand("value", kNumbers, spatial::kJointPosition, "array of values, one for each of `time`"),
    by_hand("mean", kNumber, spatial::kJointPosition, "of a pitch by the azimuth: mean").from("0"),
    by_hand("cosine", kNumber, spatial::kJointPosition,
            "likewise: factor of the cosine of the azimuth")
        .from("0"),
    by_hand("sine", kNumber, spatial::kJointPosition, "likewise: factor of its sine").from("0"),
    by_hand("by", kWord, "`\"program\"`: the embedding program says what it is").among("program"),
    by_hand("initial", kNumber, spatial::kJointPosition, "value until the program says one")
        .from("0")};

inline constexpr std::array kEffortRows{
    by_hand("time", kNumbers, kTime, "array of times, each greater than the one before").required(),
    by_hand(
        "value", kNumbers | kNumberArrays, Quantity::any("N m, N"),
        "array of values, one for each of `time`; of several coordinates arrays of one for each")
        .required()};

}  // namespace spoke::keys
