#pragma once

// Keys of blades in the plane.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/support/key_row.h"

namespace spoke::keys {

/// Whether a blade is described by a material and a cross section.
inline bool is_uniform(const Blade& blade) { return blade.sections == BladeSections{}; }

inline constexpr std::array kBladeRows{
    number<&Blade::length>("length", Quantity::positive("m"), "from root to tip").required(),
    count<&Blade::bodies>("bodies", Count{1, kMostOfAKind}, "flexible bodies along the blade"),
    count<&Blade::elements>("elements", Count{1, kMostOfAKind}, "finite elements per body"),
    number<&Blade::density>("density", Quantity::positive("kg/m^3"), "mass density")
        .required()
        .from("required, unless there are `sections`")
        .when(keys::holds<Blade, is_uniform>),
    number<&Blade::area>("area", Quantity::positive("m^2"), "area of the cross section")
        .required()
        .from("as `density`")
        .when(keys::holds<Blade, is_uniform>),
    number<&Blade::second_moment>("second_moment", Quantity::positive("m^4"),
                                  "second moment of area for bending in the plane")
        .required()
        .from("as `density`")
        .when(keys::holds<Blade, is_uniform>),
    number<&Blade::youngs_modulus>("youngs_modulus", Quantity::positive("Pa"), "Young's modulus")
        .required()
        .from("as `density`")
        .when(keys::holds<Blade, is_uniform>),
    flag<&Blade::geometric_stiffening>(
        "geometric_stiffening",
        "whether bending within a body is stiffened by tension, of rotation, gravity, loads and "
        "the motion of the hub, and made softer by compression; without it only the joints between "
        "bodies feel that tension"),
    choice<&Blade::reference_frame, ReferenceFrame::clamped, ReferenceFrame::chord>(
        "reference_frame",
        "where a body's floating frame sits: `\"clamped\"` tangent to its inboard end, `\"chord\"` "
        "through both ends"),
    choice<&Blade::strain, BeamStrain::automatic, BeamStrain::linear, BeamStrain::nonlinear>(
        "strain",
        "how strains follow from displacements. `\"nonlinear\"`: to second order, so that a body "
        "feels tension and moments on its deformed shape, whatever makes them "
        "([formulation.md](formulation.md#16-strains-of-second-order)); one body of eight elements "
        "does what four of four did. `\"linear\"`: tension is that of the undeformed blade, by "
        "rotation, gravity, loads and the motion of the hub (`geometric_stiffening`), in less "
        "time. `\"automatic\"`: `\"nonlinear\"` with closed loops, whose tension linear strains do "
        "not know, otherwise `\"linear\"`"),
    number<&Blade::azimuth>(
        "azimuth", spatial::kAngle,
        "direction of the first blade in the hub's frame, from its x axis counterclockwise"),
    by_hand("sections", kTable, "properties that change along the blade, below")
        .as("blade.sections"),
    by_hand("point_mass", kTables, "masses that the blade carries, below")
        .from("none")
        .as("blade.point_mass"),
    by_hand("loop", kTables, "[closed loops](#bladeloop-closed-loops), below")
        .from("none")
        .as("loop")};

inline constexpr std::array kBladeCountRows{
    by_hand("count", kWhole, "number of blades, spaced evenly around the hub")
        .from("required, unless `[[blades]]` are given")
        .within("1 to 100000")
        .of(Count{1, kMostOfAKind})};

inline constexpr std::array kBladeSectionsRows{
    by_hand(
        "station", kNumbers, kStation,
        "distances from the root, each greater than the one before; the first 0, the last `length`")
        .required()
        .within("2 or more"),
    stations<&BladeSections::mass_per_length>("mass_per_length", Quantity::positive("kg/m"), "ρA")
        .required(),
    stations<&BladeSections::axial_stiffness>("axial_stiffness", Quantity::positive("N"), "EA")
        .required(),
    stations<&BladeSections::bending_stiffness>("bending_stiffness", Quantity::positive("N m^2"),
                                                "EI, for bending in the plane")
        .required()};

inline constexpr std::array kPointMassRows{
    by_hand("position", kNumber, kStation, "distance from the root")
        .required()
        .within("0 to `length`"),
    number<&PointMass::mass>("mass", Quantity::positive("kg"), "its mass").required(),
    number<&PointMass::inertia>("inertia", Quantity::not_negative("kg m^2"),
                                "its moment of inertia about its centre, for rotation in the "
                                "plane; with `geometric_stiffening = false` it feels, wrongly, a "
                                "moment of ω² `inertia` times the angle that the section turns")};

}  // namespace spoke::keys
