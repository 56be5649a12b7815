#pragma once

// Keys of [hub], of its drive, its mount and its suspension.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

/// The mass of a hub that is free is an unknown's.
template <class H>
constexpr Quantity hub_mass(const H& hub) {
  return hub.support == HubSupport::free ? Quantity::positive("kg") : Quantity::not_negative("kg");
}
template <class H>
constexpr Presence hub_mass_presence(const H& hub) {
  return hub.support == HubSupport::free ? Presence::required : Presence::optional;
}

inline constexpr std::array kHubRows{
    choice<&Hub::support, HubSupport::axle, HubSupport::free>(
        "support", "`\"axle\"`: rotates about a fixed point; `\"free\"`: moves in the plane"),
    number<&Hub::radius>("radius", Quantity::not_negative("m"),
                         "distance of the blade roots from the hub's axis"),
    number<&Hub::inertia>("inertia", Quantity::positive("kg m^2"),
                          "moment of inertia about the hub's axis, without blades"),
    number<&Hub::mass>("mass", Quantity::not_negative("kg"),
                       "mass of the hub, without blades; matters only if the hub is free")
        .from("0; required if free")
        .within("0 or more; greater than 0 if free")
        .ranging(keys::range_by<Hub, hub_mass<Hub>>)
        .present(keys::presence_by<Hub, hub_mass_presence<Hub>>),
    by_hand("drive", kTable, "what turns the hub, [next table](#hubdrive)").required()};

inline constexpr std::array kSpaceHubRows{
    choice<&spatial::Hub::support, HubSupport::axle, HubSupport::free>(
        "support",
        "`\"axle\"`: turns about its `axis`, its origin at rest, moved by the mount, or carried by "
        "a [support](#support-what-carries-the-axle); `\"free\"`: moves in space")
        .within("`\"axle\"` where there is a support"),
    vector<&spatial::Hub::axis>(
        "axis", spatial::kDirection,
        "`[x, y, z]`, of any length: of the drive, and the one that the blades stand around")
        .within("not 0"),
    number<&spatial::Hub::radius>("radius", Quantity::not_negative("m"),
                                  "from the hub's origin to the blades' roots, along the blades"),
    number<&spatial::Hub::mass>("mass", Quantity::not_negative("kg"), "mass of the hub")
        .from("0; required if free")
        .within("0 or more; greater than 0 if free, or if it is alone on a support")
        .ranging(keys::range_by<spatial::Hub, hub_mass<spatial::Hub>>)
        .present(keys::presence_by<spatial::Hub, hub_mass_presence<spatial::Hub>>),
    vector<&spatial::Hub::center>("center", kLength,
                                  "`[x, y, z]`, centre of mass in the hub's frame"),
    by_hand("inertia", kNumber | kNumbers, spatial::kInertia,
            "about the centre of mass: `[xx, yy, zz]`, or `[xx, yy, zz, xy, xz, yz]`, the entries "
            "of the tensor (xy = −∫ρ x y dV); or one number, about every axis")
        .from("1; required if free")
        .within("positive definite, no principal moment greater than the sum of the others"),
    by_hand("drive", kTable, "what turns the hub about its `axis`, [as in the plane](#hubdrive)")
        .from("required; of a free hub none"),
    by_hand("mount", kTable, "[motion](#hubmount-what-holds-the-axle-moves) of what holds the axle")
        .from("at rest"),
    by_hand("suspension", kTable, "[springs](#hubsuspension-springs-under-the-axle) under the axle")
        .from("none"),
    vector<&spatial::Hub::velocity>("velocity", spatial::kVelocity, "of a free hub at t = 0"),
    vector<&spatial::Hub::angular_velocity>("angular_velocity", kSpeed, "of a free hub at t = 0")};

inline constexpr std::array kDriveKindRows{
    by_hand("kind", kWord, "what moves the hub, see below")
        .required()
        .among("spin_up spin_up_hold_spin_down torque free table fixed constant torque_by_speed")};

inline constexpr std::array kSpinUpRows{
    number<&SpinUp::speed>("speed", kSpeed, "speed at the end of the ramp")
        .required()
        .within("any sign")
        .with("`spin_up`"),
    number<&SpinUp::ramp>("ramp", Quantity::positive("s"), "duration of the way up")
        .required()
        .with("`spin_up`")};

inline constexpr std::array kSpinUpHoldSpinDownRows{
    number<&SpinUpHoldSpinDown::speed>("speed", kSpeed, "speed at the end of the ramp")
        .required()
        .within("any sign")
        .with("`spin_up_hold_spin_down`"),
    number<&SpinUpHoldSpinDown::ramp>("ramp", Quantity::positive("s"), "duration of the way up")
        .required()
        .with("`spin_up_hold_spin_down`"),
    number<&SpinUpHoldSpinDown::hold>("hold", Quantity::not_negative("s"), "duration at full speed")
        .with("`spin_up_hold_spin_down`"),
    number<&SpinUpHoldSpinDown::ramp_down>("ramp_down", Quantity::positive("s"),
                                           "duration of the way down")
        .from("`ramp`")
        .with("`spin_up_hold_spin_down`")};

inline constexpr std::array kTorqueDriveRows{
    by_hand("torque", kNumber | kNumbers, kTorque,
            "torque on the hub: a number, or an array with one value for each of `time`")
        .required()
        .within("any sign")
        .with("`torque`"),
    by_hand("time", kNumbers, kTime, "array of times, each greater than the one before")
        .from("required for `table`; for `torque` if that is an array")
        .with("`torque`, `table`"),
    number<&TorqueDrive::initial_speed>("initial_speed", kSpeed, "speed at t = 0")
        .within("any sign")
        .with("`torque`")};

inline constexpr std::array kSpeedTableRows{
    by_hand("speed", kNumbers, kSpeed, "array of speeds, one for each of `time`")
        .required()
        .within("any sign")
        .with("`table`")};

inline constexpr std::array kConstantSpeedRows{
    number<&ConstantSpeed::speed>("speed", kSpeed, "speed")
        .required()
        .within("any sign")
        .with("`constant`")};

inline constexpr std::array kTorqueBySpeedRows{
    by_hand("speed", kNumbers, kSpeed, "array of speeds, each greater than the one before")
        .required()
        .within("any sign")
        .with("`torque_by_speed`"),
    by_hand("torque", kNumbers, kTorque, "array of torques, one for each of `speed`")
        .required()
        .within("any sign")
        .with("`torque_by_speed`"),
    number<&TorqueBySpeed::initial_speed>("initial_speed", kSpeed, "speed at t = 0")
        .within("any sign")
        .with("`torque_by_speed`"),
    number<&TorqueBySpeed::ramp>("ramp", kRamp, "[rise](#loads) of the torque")
        .with("`torque_by_speed`")};

inline constexpr std::array kFreeDriveRows{
    number<&FreeDrive::initial_speed>("initial_speed", kSpeed, "speed at t = 0")
        .within("any sign")
        .with("`free`")};

inline constexpr std::array kMountRows{
    by_hand("translation", kTable, "a table, see below")
        .from("at rest")
        .in("m, inertial frame")
        .as("course"),
    by_hand("rotation", kTable, "likewise, of the rotation vector")
        .from("at rest")
        .in("rad, inertial frame")
        .as("course")};

/// A course over time: constant + rate t + amplitude sin(frequency t + phase), or a table.
inline constexpr std::array kCourseRows{
    by_hand("time", kNumbers, kTime, "array of times, each greater than the one before"),
    by_hand("x", kNumbers, Quantity::any(""), "array of values along x, one for each of `time`")
        .from("0"),
    by_hand("y", kNumbers, Quantity::any(""), "array of values along y, one for each of `time`")
        .from("0"),
    by_hand("z", kNumbers, Quantity::any(""), "array of values along z, one for each of `time`")
        .from("0"),
    by_hand("value", kNumbers, Quantity::any(""),
            "in the plane: array of angles, one for each of `time`"),
    by_hand("constant", kNumber | kNumbers, Quantity::any(""),
            "a vector; of a rotation in the plane a number")
        .from("0"),
    by_hand("rate", kNumber | kNumbers, Quantity::any(""), "likewise, per second").from("0"),
    by_hand("amplitude", kNumber | kNumbers, Quantity::any(""), "likewise, of a harmonic motion")
        .from("0"),
    by_hand("frequency", kNumber, kSpeed, "of the harmonic motion")
        .from("required with `amplitude`"),
    by_hand("phase", kNumber, spatial::kAngle, "of the harmonic motion").from("0")};

inline constexpr std::array kSuspensionRows{
    by_hand("stiffness", kNumbers, Quantity::not_negative("N/m, N m/rad"),
            "array of six numbers: along x, y, z, about x, y, z")
        .required()
        .within("0 or more")
        .of(std::size_t{6}),
    by_hand("damping", kNumbers, Quantity::not_negative("N s/m, N m s/rad"), "likewise")
        .from("0")
        .within("0 or more")
        .of(std::size_t{6}),
    number<&spatial::Suspension::mass>(
        "mass", Quantity::positive("kg"),
        "of what stands on the springs beside the rotor: the bearing, the pylon")
        .required(),
    vector<&spatial::Suspension::center>("center", kLength,
                                         "its centre of mass, from the hub's origin"),
    by_hand("inertia", kNumber | kNumbers, spatial::kInertia, "about this centre, as of the hub")
        .required()
        .within("as of the hub")};

}  // namespace spoke::keys
