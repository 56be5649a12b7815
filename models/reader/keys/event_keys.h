#pragma once

// Keys of [[event]].

#include "models/event.h"
#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kEventRows{
    by_hand("name", kText, "as the summary and the plots call it")
        .from("`event` and its number")
        .within("each once"),
    option<&Event::at>("at", Quantity::not_negative("s"), "time at which it happens")
        .from("required, or `when`"),
    by_hand("when", kText,
            "in place of `at`: a column of `sensors.csv`, `>` or `<`, and a number in its unit, as "
            "`\"hub.speed > 1.4\"`"),
    number<&Event::delay>("delay", Quantity::not_negative("s"),
                          "time from then to what it does, in steps, rounded up"),
    by_hand("generator", kWord, "`\"off\"`: the drive has no torque from then on")
        .from("it goes on")
        .among("off"),
    number<&Event::brake>("brake", Quantity::not_negative("N m"),
                          "torque of a shaft brake, on the hub's side of a gearbox"),
    number<&Event::brake_speed>("brake_speed", Quantity::positive("rad/s"),
                                "from which on the brake has that torque"),
    by_hand("controller", kWord, "`\"off\"`: no controller moves anything from then on")
        .from("it goes on")
        .among("off"),
    by_hand("pitch", kTable, "turns blades, a table of the keys below").from("none"),
    by_hand("yaw", kTable, "turns the yaw joint of a controller, likewise").from("none")};

inline constexpr std::array kEventYawRows{
    option<&EventTurn::to>("to", spatial::kAngle, "angle to which the demand goes")
        .from("none: the joints stop where they are"),
    option<&EventTurn::rate>("rate", Quantity::positive("rad/s"), "at which it goes there")
        .from("required with `to`")};

inline constexpr std::array kEventPitchRows{
    by_hand("blades", kNumbers, Quantity::positive(""),
            "numbers of blades, from 1, subsystems on hubs behind blades")
        .from("all that a controller moves")
        .within("each once")};

}  // namespace spoke::keys
