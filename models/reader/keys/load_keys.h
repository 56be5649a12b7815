#pragma once

// Keys of loads, in the plane and in space.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kLoadedBladeRows{
    by_hand("blade", kWhole | kWord, "number of the blade, from 1, or `\"all\"`")
        .from("`\"all\"`")
        .within("1 to the number of blades")
        .among("all")
        .of(Count{1, kMostOfAKind})};

inline constexpr std::array kLoadNameRows{
    by_hand("name", kText,
            "name by which [`spoke critical`](modes.md#8-critical-speeds-and-loads) varies the "
            "load; loads of one name go together")
        .from("none")
        .within("letters, digits, `_`, `-`, `.`; not `gravity`")};

/// What all loads have besides: their course over time.
template <class L>
inline constexpr std::array kLoadCourseRows{
    number<&L::ramp>("ramp", kRamp,
                     "the load rises from 0 at t = 0 to its full size at t = `ramp`; 0: all of it "
                     "from the start"),
    by_hand("time", kNumbers, kTime, "array of times, each greater than the one before")
        .from("constant load")
        .within("together with `factor`"),
    by_hand("factor", kNumbers, kFactor,
            "array of factors of the load, one for each of `time`, interpolated as above")
        .from("constant load")
        .within("together with `time`")};

inline constexpr std::array kPointLoadRows{
    by_hand("position", kNumber, kStation, "distance from the blade's root")
        .from("the tip of each blade loaded")
        .within("0 to the blade's length"),
    choice<&PointLoad::frame, LoadFrame::inertial, LoadFrame::hub, LoadFrame::section>(
        "frame",
        "in which the force is resolved: `\"inertial\"`, `\"hub\"`, or `\"section\"`, which turns "
        "with the loaded cross section"),
    by_hand("force", kNumbers, kForce, "`[x, y]`")
        .from("`[0, 0]`")
        .within("`force` or `moment` is required")
        .of(std::size_t{2}),
    number<&PointLoad::moment>("moment", Quantity::any("N m"), "about z, counterclockwise")};

inline constexpr std::array kDistributedLoadRows{
    by_hand("from", kNumber, kStation, "distance of the inner end from the blade's root")
        .from("0")
        .within("0 to less than the blade's length"),
    by_hand("to", kNumber, kStation, "distance of the outer end")
        .from("the tip of each blade loaded")
        .within("greater than `from`, to the blade's length"),
    choice<&DistributedLoad::frame, LoadFrame::inertial, LoadFrame::hub, LoadFrame::section>(
        "frame", "as of `[[load]]`"),
    by_hand("force_per_length", kNumbers, kForcePerLength, "`[x, y]`")
        .from("`[0, 0]`")
        .within("it or `moment_per_length` is required")
        .of(std::size_t{2}),
    number<&DistributedLoad::moment_per_length>("moment_per_length", Quantity::any("N"),
                                                "about z, counterclockwise")};

inline constexpr std::array kDragRows{
    choice<&Drag::relative_to, DragFrame::inertial, DragFrame::hub>(
        "relative_to",
        "of what u is the velocity: `\"inertial\"`, u is the velocity in space; `\"hub\"`, u is "
        "that less the velocity which the place would have if it were fixed to the hub, as in air "
        "that turns with the hub"),
    by_hand("position", kNumber, kStation,
            "distance of the point from the blade's root; only with `linear` or `quadratic`")
        .from("the tip of each blade loaded")
        .within("0 to the blade's length"),
    number<&Drag::linear>("linear", Quantity::not_negative("N s/m"), "c₁ at one point")
        .within("0 or more; one of the four is required"),
    number<&Drag::quadratic>("quadratic", Quantity::not_negative("N s^2/m^2"), "c₂ at one point"),
    by_hand("from", kNumber, kStation,
            "distance of its inner end from the root; only with a coefficient per length")
        .from("0")
        .within("0 to less than the blade's length"),
    by_hand("to", kNumber, kStation, "distance of its outer end; likewise")
        .from("the tip of each blade loaded")
        .within("greater than `from`, to the blade's length"),
    number<&Drag::linear_per_length>("linear_per_length", Quantity::not_negative("N s/m^2"),
                                     "c₁ per length"),
    number<&Drag::quadratic_per_length>(
        "quadratic_per_length", Quantity::not_negative("N s^2/m^3"),
        "c₂ per length: of a strip with drag coefficient C, chord c and air of density ρ, ½ρcC")};

inline constexpr std::array kHubLoadRows{
    by_hand("position", kNumbers, kLength,
            "where the force acts: `[x, y]` in the hub's frame; only with `force`")
        .from("`[0, 0]`")
        .of(std::size_t{2}),
    choice<&HubLoad::frame, LoadFrame::hub, LoadFrame::inertial>(
        "frame", "in which the force is resolved: `\"hub\"`, a thruster, or `\"inertial\"`"),
    by_hand("force", kNumbers, kForce, "`[x, y]`")
        .from("`[0, 0]`")
        .within("`force` or `torque` is required")
        .of(std::size_t{2}),
    number<&HubLoad::torque>("torque", kTorque, "about z, besides that of the force")};

inline constexpr std::array kLoadPlaceRows{
    by_hand("blade", kWhole | kWord, "number of the blade, or `\"all\"`")
        .from("`\"all\"`")
        .among("all")
        .of(Count{1, kMostOfAKind}),
    by_hand("subsystem", kText,
            "name of the subsystem that it is on, in place of `blade`; of a "
            "[support](#support-what-carries-the-axle) `\"support\"`")
        .from("none"),
    by_hand("body", kText, "name of its body").from("none")};

inline constexpr std::array kSpacePointLoadRows{
    by_hand("position", kNumber, kStation, "on a beam: distance from the root")
        .from("the tip")
        .within("0 to its length"),
    by_hand("point", kNumbers, kLength, "on a rigid body: `[x, y, z]` in its frame")
        .from("`[0, 0, 0]`")
        .of(std::size_t{3}),
    by_hand("interface", kText, "on a solid: name of the interface at whose point it acts")
        .from("the second, where there are two"),
    by_hand("nodes", kText | kTable,
            "on a solid, in place of `interface`: nodes over which the load is spread, by area, "
            "chosen as those [of an interface](#solids); a moment is about their mean")
        .from("none")
        .within("not on one line")
        .as("nodes"),
    choice<&spatial::PointLoad::frame, spatial::LoadFrame::inertial, spatial::LoadFrame::hub,
           spatial::LoadFrame::body, spatial::LoadFrame::section>(
        "frame",
        "`\"inertial\"`, `\"hub\"`, `\"body\"` (turns with the body's frame) or, on beams and "
        "solids, `\"section\"` (turns with the loaded section, interface or nodes): the frame in "
        "which forces and moments are resolved"),
    vector<&spatial::PointLoad::force>("force", kForce, "`[x, y, z]`")
        .within("`force` or `moment` is required, unless there is a `traction`"),
    vector<&spatial::PointLoad::moment>("moment", spatial::kMoment, "`[x, y, z]`"),
    by_hand("traction", kNumbers, spatial::kTraction,
            "on a solid, in place of `force` and `moment`: force per area of `nodes`, or of an "
            "interface, as they are at rest")
        .from("none")
        .within("the nodes have faces")
        .of(std::size_t{3})};

inline constexpr std::array kSpaceDistributedLoadRows{
    by_hand("from", kNumber, kStation, "distance of the inner end from the beam's root")
        .from("0")
        .within("0 to less than the beam's length"),
    by_hand("to", kNumber, kStation, "distance of the outer end")
        .from("the beam's tip")
        .within("greater than `from`, to the beam's length"),
    choice<&spatial::DistributedLoad::frame, spatial::LoadFrame::inertial, spatial::LoadFrame::hub,
           spatial::LoadFrame::body, spatial::LoadFrame::section>("frame", "as of `[[load]]`"),
    vector<&spatial::DistributedLoad::force_per_length>("force_per_length", kForcePerLength,
                                                        "`[x, y, z]`")
        .within("it or `moment_per_length` is required"),
    vector<&spatial::DistributedLoad::moment_per_length>("moment_per_length",
                                                         spatial::kMomentPerLength, "`[x, y, z]`")};

inline constexpr std::array kSpaceHubLoadRows{
    by_hand("rotor", kText, "name of the [rotor](#rotor-several-rotors) on whose hub it acts")
        .from("the first"),
    vector<&spatial::HubLoad::position>(
        "position", kLength,
        "where the force acts: `[x, y, z]` in the hub's frame; only with `force`"),
    choice<&spatial::HubLoad::frame, spatial::LoadFrame::hub, spatial::LoadFrame::inertial>(
        "frame", "in which the force is resolved: `\"hub\"`, a thruster, or `\"inertial\"`"),
    vector<&spatial::HubLoad::force>("force", kForce, "`[x, y, z]`")
        .within("`force` or `torque` is required"),
    vector<&spatial::HubLoad::torque>("torque", spatial::kMoment,
                                      "`[x, y, z]`, besides that of the force")};

}  // namespace spoke::keys
