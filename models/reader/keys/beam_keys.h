#pragma once

// Keys of beams and blades in space.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kBeamRows{
    number<&spatial::Beam::length>("length", Quantity::positive("m"), "from root to tip")
        .required(),
    count<&spatial::Beam::bodies>("bodies", Count{1, kMostOfAKind},
                                  "flexible bodies along the blade"),
    count<&spatial::Beam::elements>("elements", Count{1, kMostOfAKind}, "finite elements per body"),
    by_hand("sections", kTable, "what the blade is made of, next table")
        .required()
        .as("beam.sections"),
    choice<&spatial::Beam::reference_frame, ReferenceFrame::clamped, ReferenceFrame::chord>(
        "reference_frame",
        "where a body's floating frame sits: `\"clamped\"` tangent to its inboard end, `\"chord\"` "
        "through both ends"),
    flag<&spatial::Beam::geometric_stiffening>(
        "geometric_stiffening",
        "whether bending within a body is stiffened by tension, of rotation, gravity, loads and "
        "the motion of the hub, and made softer by compression; without it only the joints between "
        "bodies feel that tension"),
    choice<&spatial::Beam::strain, BeamStrain::automatic, BeamStrain::linear,
           BeamStrain::nonlinear>(
        "strain",
        "how strains follow from displacements. `\"nonlinear\"`: to second order, so that the beam "
        "feels tension, bending moments and torque on its deformed shape, whatever makes them "
        "([formulation.md](formulation.md#16-strains-of-second-order)); one body of eight elements "
        "does what four of four did. `\"linear\"`: tension is that of the undeformed tree, by "
        "rotation of the hub, gravity and loads (`geometric_stiffening`): for blades on a hub that "
        "turns them: a step of the same bodies then takes a third of the time or less, beside one "
        "body of eight elements two thirds to a third. `\"automatic\"`: `\"linear\"` where the "
        "drive turns the hub, nothing in the subsystem moves by a joint or is held by a loop, and "
        "the centres of its sections lie at its axis; otherwise `\"nonlinear\"`. `spoke check` "
        "says which. Where `\"linear\"` is given and misses tension, there is a warning"),
    by_hand("point_mass", kTables, "masses that the blade carries, below")
        .from("none")
        .as("beam.point_mass")};

inline constexpr std::array kSpaceBladeRows{
    number<&spatial::Blade::azimuth>(
        "azimuth", spatial::kAngle,
        "direction of the first blade in the hub's frame, from its x axis counterclockwise"),
    number<&spatial::Blade::precone>("precone", spatial::kAngle,
                                     "angle by which the blade leaves the plane of rotation, its "
                                     "tip towards the axis' direction"),
    by_hand("joint", kTables, "joints of the blade, below").from("none").as("blade.joint"),
    by_hand("loop", kTables, "[closed loops](#closed-loops-in-space) of the blade, below")
        .from("none")
        .as("loop"),
    by_hand("coupling", kTables, "[couplings](#couplings-of-joints) of its joints")
        .from("none")
        .as("coupling"),
    by_hand("aerodynamics", kTable,
            "[chords and aerofoils](#bladeaerodynamics-chords-and-aerofoils), on which air acts")
        .from("none")
        .as("blade.aerodynamics")};

inline constexpr std::array kSectionRows{
    by_hand("station", kNumbers, kStation,
            "each greater than the one before; the first 0, the last `length`")
        .from("`[0, length]`")
        .within("2 or more"),
    stations<&spatial::Sections::mass_per_length>("mass_per_length", Quantity::positive("kg/m"),
                                                  "per length of the axis, as all that follows")
        .required()};

inline constexpr std::array kStiffnessRows{
    stations<&spatial::Sections::axial_stiffness>("axial_stiffness", Quantity::positive("N"), "EA")
        .required(),
    stations<&spatial::Sections::flap_stiffness>("flap_stiffness", Quantity::positive("N m^2"),
                                                 "∫ E z² dA about the tension centre")
        .required(),
    stations<&spatial::Sections::lag_stiffness>("lag_stiffness", Quantity::positive("N m^2"),
                                                "∫ E y² dA about the tension centre")
        .required(),
    stations<&spatial::Sections::torsion_stiffness>("torsion_stiffness",
                                                    Quantity::positive("N m^2"), "GJ")
        .required()};

inline constexpr std::array kShearStiffnessRows{
    stations<&spatial::Sections::flap_shear_stiffness>(
        "flap_shear_stiffness", Quantity::positive("N"),
        "GA along z, with the factor of the section's shape")
        .from("no shear deformation"),
    stations<&spatial::Sections::lag_shear_stiffness>("lag_shear_stiffness",
                                                      Quantity::positive("N"), "likewise, along y")
        .from("no shear deformation")};

inline constexpr std::array kSectionInertiaRows{
    stations<&spatial::Sections::flap_inertia>("flap_inertia", Quantity::positive("kg m"),
                                               "∫ ρ z² dA about the mass centre")
        .from("as of one material: `mass_per_length` EI/EA"),
    stations<&spatial::Sections::lag_inertia>("lag_inertia", Quantity::positive("kg m"),
                                              "∫ ρ y² dA about the mass centre")
        .from("as of one material: `mass_per_length` EI/EA")};

inline constexpr std::array kSectionMatrixRows{
    by_hand("mass_center", kNumberArrays, kLength, "arrays `[y, z]`").from("on the axis"),
    by_hand("tension_center", kNumberArrays, kLength,
            "where an axial force bends nothing: arrays `[y, z]`")
        .from("on the axis"),
    by_hand("shear_center", kNumberArrays, kLength,
            "where a shear force twists nothing: arrays `[y, z]`")
        .from("on the axis"),
    by_hand("stiffness_6x6", kNumberArrays,
            "in place of all stiffnesses, `tension_center` and `shear_center`: for each station an "
            "array of 36 numbers, row by row, or of the 21 of the upper triangle")
        .within("symmetric, positive definite")
        .in("N, N m, N m²"),
    by_hand("mass_6x6", kNumberArrays,
            "in place of `mass_per_length`, `mass_center` and the inertias: likewise")
        .within("likewise; of a thin slice")
        .in("kg/m, kg, kg m"),
    by_hand("matrix_convention", kWord, "`\"spoke\"` or `\"beamdyn\"`: the axes of both matrices")
        .from("`\"spoke\"`")
        .among("spoke beamdyn")};

inline constexpr std::array kSectionShapeRows{
    stations<&spatial::Sections::twist>("twist", spatial::kAngle,
                                        "rotation of the section about +x")
        .from("0"),
    stations<&spatial::Sections::sweep>("sweep", kLength, "y coordinate of the axis").from("0"),
    stations<&spatial::Sections::prebend>("prebend", kLength, "z coordinate of the axis").from("0"),
    stations<&spatial::Sections::chord>("chord", Quantity::not_negative("m"),
                                        "size of the section along its y, to be shown")
        .from("not given"),
    stations<&spatial::Sections::thickness>("thickness", Quantity::not_negative("m"),
                                            "size of the section along its z, to be shown")
        .from("not given")};

inline constexpr std::array kSpacePointMassRows{
    number<&spatial::PointMass::position>("position", kStation, "station")
        .required()
        .within("0 to `length`"),
    number<&spatial::PointMass::mass>("mass", Quantity::positive("kg"), "its mass").required(),
    vector<&spatial::PointMass::offset>(
        "offset", kLength, "`[x, y, z]` of its centre from the axis, in the beam's frame"),
    by_hand("inertia", kNumber | kNumbers, spatial::kInertia,
            "about its centre, in the beam's axes, as of the hub")
        .from("0")};

}  // namespace spoke::keys
