#pragma once

// Keys of trees of bodies: subsystems and supports.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kSubsystemRows{
    by_hand("name", kText, "its name")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64; not `\"support\"`"),
    number<&spatial::Subsystem::azimuth>(
        "azimuth", spatial::kAngle,
        "angle about the hub's axis by which its joints on the hub are turned, and what its loops "
        "have on the hub, the mount and anchors; added to the hub's angle in `motion` by the "
        "azimuth"),
    by_hand("rotor", kText, "name of the [rotor](#rotor-several-rotors) whose hub carries it")
        .from("the first"),
    by_hand("count", kWhole,
            "number of copies around the hub, the first at `azimuth`, evenly spaced: `NAME1`, "
            "`NAME2`, ... A load or a sensor on the subsystem `NAME` is on all of them")
        .from("none: one, without a number")
        .within("1 to 100000")
        .of(Count{1, kMostOfAKind})};

/// The tables of a tree of bodies.
inline constexpr std::array kTreeRows{
    by_hand("body", kTables, "its bodies: beams, rigid bodies and solids").as("subsystem.body"),
    by_hand("joint", kTables, "its joints, one for each body").as("subsystem.joint"),
    by_hand("loop", kTables, "its closed loops").as("loop"),
    by_hand("coupling", kTables, "[couplings](#couplings-of-joints) of its joints").as("coupling")};

inline constexpr std::array kBodyRows{
    by_hand("name", kText, "unlike that of any other of the subsystem, and not `\"hub\"`")
        .required()
        .within("as of joints"),
    by_hand("kind", kWord, "`\"beam\"`, `\"rigid\"` or `\"solid\"`, [below](#solids)")
        .required()
        .among("beam rigid solid"),
    by_hand("drag", kTable, "[drag](#drag-of-bodies) in the wind, of a beam or a rigid body")
        .from("none")
        .as("subsystem.body.drag")};

inline constexpr std::array kRigidBodyRows{
    number<&spatial::RigidBody::mass>("mass", Quantity::positive("kg"), "of a rigid body")
        .required(),
    vector<&spatial::RigidBody::center>("center", kLength,
                                        "of a rigid body: centre of mass in the body's frame"),
    vector<&spatial::RigidBody::spin>(
        "spin", Quantity::any("kg m^2/s"),
        "of a rigid body: angular momentum of what spins inside it (a wheel, a propeller), "
        "relative to the body, which a motor keeps; `mass` and `inertia` are those of all"),
    by_hand("inertia", kNumber | kNumbers, spatial::kInertia,
            "of a rigid body: about its centre of mass, as of the hub")
        .required()
        .within("as of the hub")};

inline constexpr std::array kSubsystemJointRows{
    by_hand("parent", kText, "name of a body, or `\"hub\"`, which may have several children")
        .from("required; of a support its base"),
    by_hand("child", kText,
            "name of a body: a beam is joined at its root, a rigid body at the origin of its "
            "frame, a solid at its first interface")
        .required(),
    by_hand("station", kNumber, kStation, "on a parent that is a beam")
        .from("its tip")
        .within("0 to its length"),
    by_hand("node", kWhole,
            "in place of `station`: number of a node, from 0 at the root to `bodies` · `elements` "
            "at the tip, of equal elements"),
    by_hand("interface", kText,
            "in place of `station`, on a parent that is a solid: name of one of its interfaces")
        .from("the second, where there are two")};

inline constexpr std::array kCouplingRows{
    by_hand("name", kText, "unlike that of any other coupling of the blade or subsystem")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("joints", kTables, "the coordinates that it couples: two tables or more, below")
        .required()
        .as("coupling.joints"),
    number<&Coupling::stiffness>(
        "stiffness", Quantity::not_negative("N m/rad, N/m"),
        "of a spring in place of the rigid relation: force by the sum of ratio times coordinate")
        .from("0: rigid"),
    number<&Coupling::damping>("damping", Quantity::not_negative("N m s/rad, N s/m"),
                               "of a damper beside the spring")
        .within("0 or more; only with `stiffness`")};

inline constexpr std::array kCoupledJointRows{
    by_hand("joint", kText,
            "name of a joint of the blade or subsystem, free or prescribed; of a support also "
            "`\"axle\"`, and `\"tail.axle\"` of a further rotor by the name `\"tail\"`")
        .required(),
    by_hand("subsystem", kText,
            "name of the subsystem whose joint it is, `\"support\"` among them, if not of that of "
            "the coupling; of one coordinate at least it is"),
    by_hand("blade", kWhole,
            "in its place number of a blade, from 1, or `\"next\"`: the next one of the rotor"),
    by_hand("coordinate", kWhole, "number of its coordinate").from("1").within("from 1"),
    number<&CoupledJoint::ratio>(
        "ratio", Quantity::any("1, 1/rad, 1/m"),
        "its factor in the sum; in all tables of a coupling of the same unit times coordinate")
        .required()
        .within("not 0")};

inline constexpr std::array kSupportRows{
    choice<&spatial::Support::from, spatial::SupportBase::ground, spatial::SupportBase::free>(
        "from",
        "`\"ground\"`: the tree stands on the inertial frame, or on the "
        "[mount](#hubmount-what-holds-the-axle-moves) that moves in it; `\"free\"`: on a fuselage, "
        "a rigid body that is free in space")};

inline constexpr std::array kFuselageRows{
    number<&spatial::Fuselage::mass>(
        "mass", Quantity::positive("kg"),
        "of the fuselage; this and the keys below belong to `from = \"free\"`")
        .required(),
    vector<&spatial::Fuselage::center>("center", kLength, "its centre of mass, in its frame"),
    by_hand("inertia", kNumber | kNumbers, spatial::kInertia,
            "about its centre of mass, as of the hub")
        .required()
        .within("as of the hub"),
    vector<&spatial::Fuselage::position>("position", kLength,
                                         "of its origin at t = 0, inertial frame"),
    vector<&spatial::Fuselage::attitude>("attitude", spatial::kAngle,
                                         "rotation vector of its frame at t = 0"),
    vector<&spatial::Fuselage::velocity>("velocity", spatial::kVelocity,
                                         "of its origin at t = 0, inertial frame"),
    vector<&spatial::Fuselage::angular_velocity>("angular_velocity", kSpeed,
                                                 "at t = 0, in its frame")};

inline constexpr std::array kSupportAxleRows{
    by_hand("axle", kTable, "where the tree carries the hub: `[support.axle]`")};

inline constexpr std::array kRotorRows{
    by_hand("name", kText, "its name, unlike that of any other rotor")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("hub", kTable, "its hub and drive, as [`[hub]`](#hub-in-space)").required().as("hub"),
    by_hand("axle", kTable,
            "what carries it, as `[support.axle]`; with `subsystem`, a body of another rotor's")
        .from("as there")
        .as("support.axle"),
    by_hand("blade", kTable, "its blades, as `[blade]`").from("none").as("blade"),
    by_hand("blades", kTables, "its blades one by one, as `[[blades]]`").from("none").as("blades")};

inline constexpr std::array kAxleRows{
    by_hand("subsystem", kText,
            "of a rotor that is not the first: name of the subsystem whose body carries the axle, "
            "one on the hub of a rotor before this")
        .from("the support"),
    by_hand("blade", kWhole,
            "in place of `subsystem` and `body`: number, among those of all rotors, of the blade "
            "that carries the axle, one of a rotor before this")
        .from("none")
        .within("from 1"),
    by_hand("body", kText,
            "name of the body that carries the axle; a fuselage is named `\"fuselage\"`")
        .from("required; the fuselage, where there is no body"),
    by_hand("station", kNumber, kStation,
            "the place on a beam; it may be anywhere, and makes a node there")
        .from("of a beam its tip")
        .within("as of joints"),
    by_hand("node", kWhole, "in place of `station`: number of a node, as of a joint's parent")
        .within("as of joints"),
    by_hand("interface", kText, "the place on a solid: name of one of its interfaces")
        .from("the second, where there are two")
        .within("as of joints"),
    vector<&spatial::Axle::offset>("offset", kLength,
                                   "of the hub's frame in that of the carrier at this place"),
    vector<&spatial::Axle::orientation>(
        "orientation", spatial::kAngle,
        "rotation vector of the hub's frame, at a hub angle of 0, in the same frame")};

inline constexpr std::array kDriveTrainRows{
    number<&spatial::DriveTrain::stiffness>(
        "stiffness", Quantity::not_negative("N m/rad"),
        "of the shaft between hub and gearbox, on the hub's side; this and the keys below belong "
        "to a [drive train](#supportaxle-drive-trains)")
        .from("none: the drive turns the hub")
        .within("greater than 0"),
    number<&spatial::DriveTrain::damping>("damping", Quantity::not_negative("N m s/rad"),
                                          "of the shaft, likewise"),
    number<&spatial::DriveTrain::gear_ratio>(
        "gear_ratio", Quantity::any(""),
        "turns of the generator for one of the hub, less than 0 if it turns the other way")
        .within("not 0"),
    number<&spatial::DriveTrain::generator_inertia>(
        "generator_inertia", Quantity::not_negative("kg m^2"),
        "of what turns behind the gearbox, about its axis, at its own speed")
        .from("required with `stiffness`")
        .within("greater than 0")};

}  // namespace spoke::keys
