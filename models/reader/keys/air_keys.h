#pragma once

// Keys of [air] and [aerodynamics].

#include "models/air.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kAirRows{
    number<&spatial::Air::density>("density", Quantity::positive("kg/m^3"), "of the air"),
    number<&spatial::Air::viscosity>(
        "viscosity", Quantity::positive("m^2/s"),
        "kinematic, for the Reynolds numbers by which polars are chosen")};

inline constexpr std::array kAerodynamicsRows{
    choice<&spatial::Air::induction, spatial::Induction::momentum, spatial::Induction::none>(
        "induction",
        "velocity that the rotor itself induces: `\"momentum\"`, blade-element momentum theory by "
        "annuli, with losses at tip and root, high thrust, hover and descent, and skewed wakes; "
        "`\"none\"`"),
    choice<&spatial::Air::inflow, spatial::Inflow::dynamic, spatial::Inflow::quasi_steady>(
        "inflow",
        "how induced velocity follows the load: `\"dynamic\"`, with two time constants after Oye; "
        "`\"quasi_steady\"`, at once"),
    number<&spatial::Air::inflow_factor>(
        "inflow_factor", Quantity::between(1.0, 2.0),
        "induced velocity by that of momentum theory. Hovering rotors induce more, since their "
        "wake contracts and its tip vortices pass near the blades: 1.1 to 1.2 are usual "
        "([aerodynamics.md](aerodynamics.md#inflow-factor)). Of turbines it is 1"),
    choice<&spatial::Air::stall, spatial::Stall::dynamic, spatial::Stall::steady>(
        "stall",
        "how separation follows the angle of attack: `\"dynamic\"`, with a lag after Oye; "
        "`\"static\"`, at once, lift is that of the polar")};

}  // namespace spoke::keys
