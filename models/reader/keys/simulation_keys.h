#pragma once

// Keys of how a model is simulated, damped and measured.

#include <limits>

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/sensor_quantities.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kIntegrationRows{
    choice<&Integration::method, IntegrationMethod::generalized_alpha, IntegrationMethod::rk4>(
        "method",
        "`\"generalized_alpha\"`: implicit, for steps that suit the motion; `\"rk4\"`: explicit, "
        "for steps below the stability limit, which `spoke check` prints"),
    number<&Integration::step>("step", Quantity::positive("s"),
                               "time step; shortened if needed, so that it divides the duration")
        .within("greater than 0, at most `duration`, at most 1e10 steps"),
    number<&Integration::duration>("duration", Quantity::positive("s"), "simulated time")
        .required(),
    number<&Integration::spectral_radius>("spectral_radius", Quantity::between(0.0, 1.0),
                                          "spectral radius of `generalized_alpha` at infinite "
                                          "frequency: 1 damps no mode, 0 damps the fast ones most")
        .within("0 to 1; at most 0.95 with [closed loops](#bladeloop-closed-loops) that are rigid"),
    number<&Integration::tolerance>(
        "tolerance", Quantity::positive("m, rad"),
        "tolerance of the iteration within a step of `generalized_alpha`: largest change of a "
        "coordinate in the last iteration; with `iterate_to = \"error\"` the most that is left of "
        "a change, if it is not the default"),
    by_hand("iterate_to", kWord,
            "`\"error\"`: the iteration goes on until what is left, by the contraction seen, is a "
            "small share of the step's own error, so that smaller steps have smaller errors down "
            "to round-off ([formulation.md](formulation.md#generalized_alpha)); `\"tolerance\"`: "
            "until its last change is below `tolerance`")
        .from("`\"error\"`; `\"tolerance\"` where `tolerance` is given")
        .among("error tolerance"),
    count<&Integration::iterations>(
        "iterations", Count{0, kMostIterations},
        "number of iterations per step; 0: as many as the tolerance needs"),
    count<&Integration::max_iterations>(
        "max_iterations", Count{1, kMostIterations},
        "if a step needs more iterations than this, the simulation has diverged"),
    number<&Integration::loop_redundancy>(
        "loop_redundancy", Quantity::inside(0.0, 1.0),
        "a row of rigid closed loops is redundant, and dropped, where its pivot at the start is "
        "below this share of the largest one")};

inline constexpr std::array kInitialRows{
    choice<&Initial::state, InitialState::undeformed, InitialState::equilibrium>(
        "state",
        "`\"undeformed\"`: joints at their `initial`, the hub with the speed of its drive at t = "
        "0; `\"equilibrium\"`: of steady rotation, as [`spoke static`](modes.md) finds it"),
    option<&Initial::speed>(
        "speed", kSpeed,
        "of the equilibrium: where the drive prescribes the rotation, its speed at its start, or "
        "after its ramp up; else any. Without it, the speed after the ramp up, `initial_speed` of "
        "a drive, or the part of `angular_velocity` of a free hub along its axis")
        .from("see left")
        .within("only with `\"equilibrium\"`")};

inline constexpr std::array kLimitsRows{
    number<&Limits::deflection>(
        "deflection", Quantity::not_negative(""),
        "deflection of a body in its floating frame, as a share of the body's length, beyond which "
        "linear elasticity no longer holds well and a warning is given; with `strain = "
        "\"nonlinear\"` deflection of an element, as a share of its length; 0: no limit"),
    number<&Limits::energy_growth>("energy_growth", Quantity::not_negative(""),
                                   "growth of the energy beyond the work done, as a share of the "
                                   "largest energy so far; 0: no limit"),
    choice<&Limits::on_energy_growth, EnergyGrowth::warn, EnergyGrowth::stop>(
        "on_energy_growth",
        "`\"warn\"`, or `\"stop\"`: the simulation has diverged (exit status 3)"),
    number<&Limits::step_error>("step_error", Quantity::not_negative(""),
                                "estimated error of a step of `generalized_alpha`, of an angle in "
                                "rad, of a displacement by a length of the model; 0: no limit"),
    number<&Limits::momentum>("momentum", Quantity::not_negative(""),
                              "change of the momentum of a free model on which nothing acts, by "
                              "the largest so far; 0: no limit")};

inline constexpr std::array kOutputRows{number<&Output::interval>(
    "interval", Quantity::not_negative("s"),
    "time between the rows of `sensors.csv`, and between the files of `--vtk`; 0: every step")};

inline constexpr std::array kStatisticsRows{
    by_hand("exponents", kNamedNumbers, kExponent,
            "exponents by name: `blades` of all blades that have none of their own, `blade1` and "
            "so on of one, `support`, or the name of a [subsystem](#subsystem-trees-of-bodies)")
        .from("10 of blades and subsystems on the hub, 4 of a support")
        .within("1 to 100")};

inline constexpr std::array kGravityRows{
    by_hand("acceleration", kNumbers, kGravity, "`[x, y]` in the inertial frame")
        .from("`[0, 0]`")
        .of(std::size_t{2}),
    number<&Rotor::gravity_ramp>("ramp", kRamp, "its [rise](#loads); 0: all of it from the start")};

inline constexpr std::array kSpaceGravityRows{
    vector<&spatial::Model::gravity>("acceleration", kGravity, "`[x, y, z]` in the inertial frame"),
    number<&spatial::Model::gravity_ramp>("ramp", kRamp,
                                          "its [rise](#loads); 0: all of it from the start")};

inline constexpr std::array kDampingRows{
    number<&Damping::mass_factor>("mass_factor", Quantity::not_negative("1/s"),
                                  "factor of the mass matrix of the deformation coordinates")
        .with("`mass_factor` / (2 W)"),
    number<&Damping::stiffness_factor>("stiffness_factor", Quantity::not_negative("s"),
                                       "factor of the stiffness matrix")
        .with("`stiffness_factor` W / 2")};

inline constexpr std::array kBeamDampingRows{
    number<&DirectionDamping::flap>(
        "flap", kFactorOfStiffness,
        "factor of the stiffness by direction; in space: bending along the section's z")
        .with("factor W / 2"),
    number<&DirectionDamping::lag>(
        "lag", kFactorOfStiffness,
        "likewise: bending along the section's y; in the plane lag is all of it")
        .with("factor W / 2"),
    number<&DirectionDamping::axial>("axial", kFactorOfStiffness, "likewise: stretch")
        .with("factor W / 2"),
    number<&DirectionDamping::torsion>("torsion", kFactorOfStiffness, "in space: twist")
        .with("factor W / 2"),
    option<&DirectionDamping::flap_shear>("flap_shear", kFactorOfStiffness,
                                          "in space: shear along z")
        .from("`flap`"),
    option<&DirectionDamping::lag_shear>("lag_shear", kFactorOfStiffness, "in space: shear along y")
        .from("`lag`"),
    by_hand("mu", kNumbers, kFactorOfStiffness,
            "in space, in place of these six: BeamDyn's μ1 to μ6, which are `flap_shear`, "
            "`lag_shear`, `axial`, `lag`, `flap`, `torsion`")
        .from("none")
        .within("six numbers, 0 or more")
        .of(std::size_t{6}),
    by_hand("ratios", kNumbers, kDampingRatioOfBeams,
            "damping ratios of the lowest modes of each beam, from the lowest frequency on")
        .from("none")
        .within("0 or more, less than 1; no more than a beam has coordinates")
        .with("these"),
    by_hand("above", kNumber, kDampingRatioOfBeams,
            "damping ratio of the next mode; those above it have more, in proportion to their "
            "frequency")
        .from("the last of `ratios`")
        .within("0 or more, less than 1; only with `ratios`")
        .with("this")};

inline constexpr std::array kSensorRows{
    by_hand("name", kText, "in the names of the columns, such as `blade1.NAME.x`")
        .from("the `quantity`")
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("quantity", kWord, "what is measured, see below")
        .required()
        .among(kQuantityNames<true>),
    by_hand("blade", kWhole | kWord, "number of the blade, from 1, or `\"all\"`")
        .from("`\"all\"`")
        .within("1 to the number of blades")
        .among("all")
        .of(Count{1, kMostOfAKind}),
    by_hand("position", kNumber, kStation, "distance from the blade's root")
        .from("the tip of each blade; required for `section_force`")
        .within("0 to the blade's length"),
    by_hand("joint", kWhole, "number of the joint, from 1 at the root")
        .from("required for `joint_reaction`")
        .within("1 to the number of bodies")
        .of(Count{1, std::numeric_limits<int>::max()}),
    by_hand("loop", kText,
            "name of a [closed loop](#bladeloop-closed-loops), which each blade that the sensor is "
            "on must have")
        .from("required for `loop_reaction`, `loop_opening`"),
    by_hand(
        "frame", kWord,
        "in which a motion is observed and vectors are resolved: `\"hub\"`, `\"blade\"` (as the "
        "hub's, x along the undeformed blade), `\"inertial\"`, `\"section\"` (turns with the cross "
        "section), `\"loop\"` (turns with the place `to` of the loop; of a `distance`, x is along "
        "the rod: its force, positive in tension, or its elongation, and only x is not 0)")
        .from("the first in the table below")
        .within("those in the table below")
        .among("hub blade inertial section loop")};

inline constexpr std::array kSpaceSensorRows{
    by_hand("name", kText, "in the names of the columns, such as `blade1.NAME.x`")
        .from("the `quantity`")
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("quantity", kWord, "what is measured, see below")
        .required()
        .among(kQuantityNames<false>),
    by_hand("blade", kWhole | kWord, "number of the blade, from 1, or `\"all\"`")
        .from("`\"all\"`")
        .within("1 to the number of blades")
        .among("all")
        .of(Count{1, kMostOfAKind}),
    by_hand("subsystem", kText, "name of a subsystem, in place of `blade`"),
    by_hand("body", kText,
            "name of its body, for a motion, a section force or the reaction of a joint"),
    by_hand("position", kNumber, kStation, "distance from the root of the blade or the beam")
        .from("the tip of each blade; required for `section_force`")
        .within("0 to its length"),
    by_hand("joint", kWhole, "number of the joint, from 1 at the root")
        .from("required for `joint_reaction`")
        .within("1 to the number of bodies")
        .of(Count{1, std::numeric_limits<int>::max()}),
    by_hand("loop", kText,
            "name of a [closed loop](#bladeloop-closed-loops), which each blade, or the subsystem, "
            "that the sensor is on must have")
        .from("required for `loop_reaction`, `loop_opening`"),
    by_hand("coupling", kText, "name of a coupling of the subsystem")
        .from("required for `coupling_force`"),
    by_hand("interface", kText, "of a solid: name of the interface")
        .from("the second, where there are two"),
    by_hand("node", kWhole,
            "of a solid, in place of `interface`: number of a node in the mesh's file")
        .from("none")
        .of(Count{1, std::numeric_limits<int>::max()}),
    by_hand(
        "frame", kWord,
        "in which a motion is observed and vectors are resolved: `\"hub\"`, `\"blade\"` (as the "
        "hub's, x along the undeformed blade), `\"inertial\"`, `\"section\"` (turns with the cross "
        "section), `\"loop\"` (turns with the place `to` of the loop; of a `distance`, x is along "
        "the rod: its force, positive in tension, or its elongation, and only x is not 0)")
        .from("the first of its quantity")
        .within("those of its [quantity](#sensor-what-is-measured-besides)")
        .among("hub blade inertial section loop")};

}  // namespace spoke::keys
