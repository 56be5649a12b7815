#pragma once

// Keys of air, of the aerodynamics of blades and of aerofoils.

#include "models/air.h"
#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kAirRows{
    number<&spatial::Air::density>("density", Quantity::positive("kg/m^3"), "of the air"),
    number<&spatial::Air::viscosity>(
        "viscosity", Quantity::positive("m^2/s"),
        "kinematic, for the Reynolds numbers by which polars are chosen"),
    number<&spatial::Air::sound_speed>("sound_speed", Quantity::positive("m/s"),
                                       "for the Mach numbers by which polars are chosen")};

inline constexpr std::array kAerodynamicsRows{
    choice<&spatial::Air::induction, spatial::Induction::momentum, spatial::Induction::none>(
        "induction",
        "velocity that the rotor itself induces: `\"momentum\"`, blade-element momentum theory by "
        "annuli, with losses at tip and root, high thrust, hover and descent, and skewed wakes; "
        "`\"none\"`"),
    choice<&spatial::Air::high_thrust, spatial::HighThrust::buhl, spatial::HighThrust::glauert,
           spatial::HighThrust::hawc2>(
        "high_thrust",
        "thrust of a rotor that induces more than momentum theory holds for: `\"buhl\"`; "
        "`\"glauert\"`, his empirical curve; `\"hawc2\"`, the polynomial of that program "
        "([aerodynamics.md](aerodynamics.md#high-thrust-and-descent))"),
    choice<&spatial::Air::mass_flow, spatial::MassFlow::glauert, spatial::MassFlow::normal>(
        "mass_flow",
        "what carries air through a disc in yaw, tilt or forward flight: `\"glauert\"`, all of its "
        "velocity; `\"normal\"`, the part normal to the disc "
        "([aerodynamics.md](aerodynamics.md#4-skewed-wake))"),
    choice<&spatial::Air::inflow, spatial::Inflow::dynamic, spatial::Inflow::quasi_steady>(
        "inflow",
        "how induced velocity follows the load: `\"dynamic\"`, with two time constants after Oye; "
        "`\"quasi_steady\"`, at once"),
    number<&spatial::Air::inflow_factor>(
        "inflow_factor", Quantity::between(1.0, 2.0),
        "induced velocity by that of momentum theory. Hovering rotors induce more, since their "
        "wake contracts and its tip vortices pass near the blades: 1.1 to 1.2 are usual "
        "([aerodynamics.md](aerodynamics.md#inflow-factor)). Of turbines it is 1"),
    choice<&spatial::Air::attached_flow, spatial::AttachedFlow::steady,
           spatial::AttachedFlow::unsteady>(
        "attached_flow",
        "how lift follows the angle of attack where flow is attached: `\"steady\"`, at once; "
        "`\"unsteady\"`, with the delay by the wake that the section sheds, by states (Wagner, "
        "Theodorsen), in runs"),
    choice<&spatial::Air::stall, spatial::Stall::dynamic, spatial::Stall::steady>(
        "stall",
        "how separation follows the angle of attack: `\"dynamic\"`, with a lag after Oye; "
        "`\"static\"`, at once, lift is that of the polar")};

inline constexpr std::array kBladeAerodynamicsRows{
    by_hand("station", kNumbers, kStation,
            "distances from the root, ascending; 10 to 20 serve well. Beyond the first and the "
            "last there is no load, and the last is the tip of tip loss")
        .required()
        .within("2 or more, 0 to `length`"),
    stations<&spatial::BladeAerodynamics::chord>("chord", Quantity::not_negative("m"), "")
        .required(),
    stations<&spatial::BladeAerodynamics::twist>(
        "twist", spatial::kAngle,
        "of the chord against the section's y axis, which has the `twist` of the "
        "[sections](#bladesections-in-space) already")
        .from("0"),
    stations<&spatial::BladeAerodynamics::center>(
        "center", kLength,
        "of the aerodynamic centre (of most polars the quarter of the chord): its distance from "
        "the blade's axis along the chord, positive towards the leading edge")
        .from("0"),
    by_hand("airfoil", kText | kTexts,
            "names of [aerofoils](#airfoil-polars), or files of polars, relative to the scenario")
        .required(),
    by_hand("leading_edge", kWord,
            "`\"+y\"`: the leading edge looks along the section's y axis, as on a rotor that turns "
            "about its axis in the positive sense; `\"-y\"`: about it in the negative sense")
        .from("`\"+y\"`")
        .among("+y -y")};

inline constexpr std::array kBodyDragRows{
    by_hand("station", kNumbers, kStation, "of a beam: distances from its root, ascending")
        .from("its ends")
        .within("2 or more, 0 to `length`"),
    stations<&spatial::BodyDrag::diameter>("diameter", Quantity::not_negative("m"),
                                           "of a beam: its width across the flow")
        .from("required for a beam"),
    stations<&spatial::BodyDrag::coefficient>("coefficient", Quantity::not_negative(""),
                                              "of a beam: of drag, by `diameter`")
        .from("1"),
    vector<&spatial::BodyDrag::area>(
        "area", Quantity::not_negative("m^2"),
        "of a rigid body: coefficient of drag times area, for flow along each axis of its frame")
        .from("required for a rigid body"),
    vector<&spatial::BodyDrag::point>("point", kLength,
                                      "of a rigid body: where drag acts, in its frame"),
    choice<&spatial::BodyDrag::potential, spatial::TowerPotential::none,
           spatial::TowerPotential::cylinder, spatial::TowerPotential::bak>(
        "potential",
        "of a beam of a support: the flow around it that blades meet, `\"none\"`, `\"cylinder\"` "
        "or "
        "`\"bak\"`"),
    choice<&spatial::BodyDrag::shadow, spatial::TowerShadow::none, spatial::TowerShadow::powles>(
        "shadow", "likewise, the deficit behind it, `\"none\"` or `\"powles\"`")};

inline constexpr std::array kAirfoilRows{
    by_hand("name", kText, "unlike that of any other")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("file", kText,
            "relative to the scenario's folder: a plain table, a file of AeroDyn 15, or C81 "
            "([formats](aerodynamics.md#8-aerofoil-files)); **its angles are in degrees**")
        .from("none"),
    by_hand("polar", kTables,
            "polars by Reynolds or Mach number, `[[airfoil.polar]]`, with the keys below")
        .from("none")};

inline constexpr std::array kPolarRows{
    by_hand("reynolds", kNumber, spatial::kReynolds,
            "Reynolds number of the polar, ascending from one to the next")
        .from("none; required where there are several, or `mach`")
        .within("greater than 0"),
    by_hand("mach", kNumber, spatial::kMach,
            "in place of it: Mach number of the polar, ascending from one to the next")
        .from("none"),
    by_hand("angle", kNumbers, spatial::kAngle,
            "angles of attack, ascending; the first is −π, the last π")
        .from("required without `file`")
        .within("3 or more"),
    by_hand("lift", kNumbers, spatial::kCoefficient, "coefficient of lift, equal at both ends")
        .from("required without `file`")
        .within("−100 to 100"),
    by_hand("drag", kNumbers, spatial::kCoefficient, "of drag, likewise")
        .from("required without `file`")
        .within(
            "−100 to 100; 0 or more: down to −0.01 with a warning, as extrapolated polars have it"),
    by_hand("moment", kNumbers, spatial::kCoefficient, "about the aerodynamic centre, nose up")
        .from("0")
        .within("−100 to 100")};

}  // namespace spoke::keys
