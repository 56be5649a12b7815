#pragma once

// Keys at the top level of a scenario.

#include "models/reader/keys/quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kScenarioRows{
    by_hand("title", kText, "text printed and written to the results")
        .from("the file's name without folder and ending"),
    by_hand("world", kWord, "`\"plane\"`, or `\"space\"`: a [model in space](#models-in-space)")
        .from("`\"plane\"`")
        .among("plane space"),
    by_hand("hub", kTable, "[the hub](#hub) in the middle"),
    by_hand("anchor", kTables,
            "[places that move](#anchor-places-that-move), for loops to close on"),
    by_hand("blade", kTable, "[blades](#blade-all-blades-alike), all alike"),
    by_hand("blades", kTables, "[blades one by one](#blades-blades-one-by-one)"),
    by_hand("subsystem", kTables, "in space: [trees of bodies](#subsystem-trees-of-bodies)"),
    by_hand("support", kTable, "in space: [what carries the axle](#support-what-carries-the-axle)"),
    by_hand("rotor", kTables, "in space: [several rotors](#rotor-several-rotors) on a support"),
    by_hand("gravity", kTable, "[gravity](#gravity)"),
    by_hand("damping", kTable, "[damping](#damping) of all bodies"),
    by_hand("load", kTables,
            "[forces and moments at a point](#load-a-force-and-a-moment-at-a-point)"),
    by_hand("distributed_load", kTables,
            "[forces and moments per length](#distributed_load-a-force-and-a-moment-per-length)"),
    by_hand("drag", kTables, "in the plane: [drag](#drag-against-the-motion)"),
    by_hand("hub_load", kTables, "[forces and torques on the hub](#hub_load-on-the-hub)"),
    by_hand("control", kTable,
            "in space: [control of pitch](#controlpitch-pitch-by-the-speed), [a "
            "library](#controllibrary-a-library-of-bladeds-kind), or [a controller of the "
            "program's](#controlprogram-a-controller-that-the-program-gives)"),
    by_hand("event", kTables, "in space: [what happens once](#event-what-happens-once)"),
    by_hand("initial", kTable, "[where the simulation starts](#initial)"),
    by_hand("integration", kTable, "[how the motion is integrated](#integration), and for how long")
        .required(),
    by_hand("limits", kTable, "[limits of the results](#limits)"),
    by_hand("output", kTable, "[how often results are written](#output)"),
    by_hand("sensor", kTables, "[what is measured besides](#sensor-what-is-measured-besides)"),
    by_hand("air", kTable, "in space: [air](#air-blades-in-air)"),
    by_hand("wind", kTable, "in space: [wind](#wind)"),
    by_hand("aerodynamics", kTable,
            "in space: [induction, inflow, stall](#aerodynamics-induction-inflow-stall)"),
    by_hand("airfoil", kTables, "in space: [polars](#airfoil-polars)"),
    by_hand("statistics", kTable, "[exponents of damage](#statistics-exponents-of-damage)")};

}  // namespace spoke::keys
