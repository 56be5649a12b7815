#pragma once

// Keys of closed loops and of the anchors that they close on.

#include "models/loop.h"
#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kLoopRows{
    by_hand("name", kText, "unlike that of any other loop of the blade")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("kind", kWord, "the motion of `from` against `to` that is left, see below")
        .required()
        .among("fixed revolute prismatic distance"),
    by_hand("from", kText | kTable, "a place on a body, see below").required().as("place"),
    by_hand("to", kText | kTable, "another place").required().as("place"),
    by_hand("axis", kNumbers, spatial::kDirection,
            "of a prismatic closure, in the frame of `to`: `[x, y]`, of any length")
        .from("required there")
        .within("not 0")
        .of(std::size_t{2}),
    by_hand("length", kNumber, Quantity::positive("m"), "of a distance").from("that at the start"),
    by_hand("stiffness", kNumber | kNumbers, Quantity::not_negative("N/m, N m/rad"),
            "of springs in place of a rigid closure: a number for all directions that are locked, "
            "or an array with one number for each; 0: rigid")
        .from("0")
        .within("0 or more"),
    by_hand("damping", kNumber | kNumbers, Quantity::not_negative("N s/m, N m s/rad"),
            "of dampers beside these springs, likewise; a number is for the directions that have "
            "springs")
        .from("0")
        .within("0 or more; only with `stiffness`")};

inline constexpr std::array kSpaceLoopRows{
    by_hand("name", kText, "unlike that of any other loop of the blade")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("kind", kWord, "the motion of `from` against `to` that is left, see below")
        .required()
        .among("fixed revolute prismatic universal spherical cylindrical bearing distance"),
    by_hand("from", kText | kTable, "a place on a body, see below").required().as("place"),
    by_hand("to", kText | kTable, "another place").required().as("place"),
    by_hand("axis", kNumbers, spatial::kDirection,
            "`[x, y, z]`, of any length, in the frame of `to`")
        .from("required where the kind has one")
        .within("not 0")
        .of(std::size_t{3}),
    by_hand("length", kNumber, Quantity::positive("m"), "of a distance").from("that at the start"),
    by_hand("stiffness", kNumber | kNumbers | kNumberArrays, Quantity::not_negative("N/m, N m/rad"),
            "of springs in place of a rigid closure: a number for all directions that are locked, "
            "or an array with one number for each; 0: rigid. Of a bearing also a matrix, "
            "`[[kxx, kxy], [kyx, kyy]]`, see below")
        .from("0")
        .within("0 or more; in a matrix any"),
    by_hand("damping", kNumber | kNumbers | kNumberArrays,
            Quantity::not_negative("N s/m, N m s/rad"),
            "of dampers beside these springs, likewise; a number is for the directions that have "
            "springs. Of a bearing also a matrix, with or without one of `stiffness`")
        .from("0")
        .within("0 or more, only with `stiffness`; in a matrix any"),
    by_hand("speed", kNumbers, Quantity::any("rad/s"),
            "of a bearing whose matrices depend on it, of `from` against `to` about `axis`: then "
            "`stiffness` and `damping` are arrays of matrices, one for each speed")
        .from("matrices are constant")
        .within("ascending, 2 or more"),
    by_hand("axes", kNumberArrays, "two of these, of a universal closure, as they are at the start")
        .from("required there")
        .within("not parallel")};

inline constexpr std::array kPlaceRows{
    by_hand("body", kText, "`\"hub\"` or `\"mount\"`; without it, the place is on the blade")
        .from("the blade"),
    by_hand("anchor", kText, "name of an anchor, in place of `body`").from("none"),
    by_hand("station", kNumber, kStation, "distance from the root, where a body ends")
        .from("the tip")
        .within("multiples of `length` / `bodies`"),
    by_hand("point", kNumbers, kLength,
            "`[x, y]` in the frame of the hub, the mount or the anchor; on a blade from its axis "
            "at the station, x along the blade, and turning with the section. Without `station` "
            "its x is the station")
        .from("`[0, 0]`")
        .of(std::size_t{2}),
    by_hand("orientation", kNumber, spatial::kAngle, "of the place's frame against what carries it")
        .from("of `to` 0; of `from` such that both frames are one at the start")
        .within("not of a `distance`")};

inline constexpr std::array kSpacePlaceRows{
    by_hand("body", kText, "name of a body of the subsystem; `\"hub\"` or `\"mount\"`")
        .from("required, unless there is an `anchor`; on a blade, the blade")
        .within("of `from`, a body"),
    by_hand("anchor", kText, "name of an anchor, in place of `body`").from("none"),
    by_hand("blade", kWhole | kWord,
            "of `to`: the place is on another blade, by its number from 1; `\"next\"`: on the one "
            "that follows on this rotor, behind the last the first")
        .from("none")
        .among("next"),
    by_hand("subsystem", kText,
            "of `to`: the place is on a `body` of another subsystem, by its name, or of the "
            "`\"support\"`; `\"next\"`: of the next one of a `count`")
        .from("none"),
    by_hand("station", kNumber, kStation,
            "on a beam, anywhere: it makes a node there. Where a joint of a blade is, the place is "
            "on the part outboard")
        .from("the tip")
        .within("0 to its length"),
    by_hand("point", kNumbers, kLength,
            "in the frame of a rigid body, the hub, the mount or the anchor. On a beam from its "
            "axis at the station, in the beam's axes, which turn with the section; without "
            "`station` its x is the station. On a solid from the point of the interface, in the "
            "axes of the mesh, which turn with it")
        .from("`[0, 0, 0]`")
        .of(std::size_t{3}),
    by_hand("orientation", kNumbers, spatial::kAngle, "rotation vector, in these axes")
        .from("as in the plane")
        .within("of a `spherical` one and a `bearing` only of `to`")
        .of(std::size_t{3}),
    by_hand("interface", kText, "of a solid, in place of `station`: name of one of its interfaces")
        .from("the second, where there are two")};

inline constexpr std::array kAnchorRows{
    by_hand("name", kText, "unlike that of any other anchor")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand(
        "frame", kText,
        "in which it moves: `\"mount\"`, in which the hub turns, or `\"hub\"`; on a "
        "[support](#support-what-carries-the-axle) `\"axle\"`, the hub's frame at angle 0, which "
        "moves with the body that carries the axle; in space also the name of a body: the frame "
        "of a rigid one, of a beam's section, or of a solid's interface")
        .from("`\"mount\"`")
        .within(
            "`\"hub\"` where the hub is free; `\"axle\"` with a drive that prescribes the angle"),
    by_hand("subsystem", kText, "of a body: name of the subsystem whose it is, or `\"support\"`")
        .from("`\"support\"`"),
    by_hand("station", kNumber, kStation, "of a beam: where its section is; it makes a node there")
        .from("the tip")
        .within("0 to its length"),
    by_hand("interface", kText, "of a solid: name of one of its interfaces")
        .from("the second, where there are two"),
    flag<&Anchor::turns_with_hub>(
        "turns_with_hub",
        "whether it turns with the hub besides, by the hub's angle about its own axis, which its "
        "motion tilts and moves: the rotating part of a swashplate")
        .within("with `frame = \"mount\"` or `\"axle\"`"),
    by_hand("rotor", kText,
            "in space, name of the [rotor](#rotor-several-rotors) whose hub or axle the frame is "
            "of")
        .from("the first")
        .within("with `frame = \"hub\"` or `\"axle\"`"),
    by_hand("motion", kTable, "a table, see below").from("at rest at the frame's origin")};

inline constexpr std::array kAnchorMotionRows{
    by_hand("by", kWord,
            "`\"program\"`: the embedding program moves it; `translation` and `rotation` are then "
            "`[x, y]` and a number, where it is until the program says so")
        .among("program"),
    by_hand("translation", kTable | kNumbers, kLength,
            "a table: constant + rate · t + amplitude · sin(frequency · t + phase), with "
            "`constant`, `rate` (per second) and `amplitude` as `[x, y]`, `frequency` (rad/s) and "
            "`phase` (rad); or `time` and arrays `x`, `y`")
        .from("at rest")
        .as("course"),
    by_hand("rotation", kTable | kNumbers | kNumber, spatial::kAngle,
            "likewise, with numbers in place of `[x, y]`, or `time` and the array `value`")
        .from("at rest")
        .as("course")};

}  // namespace spoke::keys
