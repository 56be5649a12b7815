#pragma once

// Keys of solids.

#include "models/reader/keys/quantities.h"
#include "models/scenario.h"
#include "models/spatial_model.h"
#include "models/support/key_row.h"

namespace spoke::keys {

inline constexpr std::array kSolidRows{
    by_hand("mesh", kText,
            "file, relative to the scenario's folder: gmsh `.msh` 2.2 or 4.1, Abaqus or CalculiX "
            "`.inp`; of tetrahedra with 10 nodes or hexahedra with 20 (those with 4 and 8 are too "
            "stiff, and warned of)")
        .from("required, unless there are matrices"),
    by_hand("material", kTable, "a table with `youngs_modulus`, `poissons_ratio` and `density`")
        .from("that of an `.inp`")
        .within("greater than 0; between −1 and 0.5; greater than 0")
        .in("Pa, -, kg/m³"),
    by_hand("scale", kTable,
            "`{ length = 1e-3 }`: metres by the unit of length in the mesh, here mm. `material`, "
            "and all places in the scenario, are in SI always")
        .from("1")
        .within("greater than 0"),
    choice<&spatial::SolidBody::coordinates, spatial::SolidCoordinates::reduced,
           spatial::SolidCoordinates::nodal>(
        "coordinates",
        "`\"reduced\"`: modes of vibration and of the interfaces; `\"nodal\"`: the displacements "
        "of all nodes, for small meshes and as a check"),
    by_hand("modes", kWhole, "number of vibration modes, with the interfaces held")
        .from("20, or all there are")
        .within("0 to 10000; only `\"reduced\"`")
        .of(spatial::kModes),
    by_hand("up_to", kNumber, spatial::kFrequency, "in place of `modes`: all below this frequency")
        .from("none")
        .within("greater than 0; only `\"reduced\"`"),
    by_hand(
        "damping", kNumber | kNumbers, spatial::kDampingRatio,
        "damping ratio of every mode, or an array with one for each mode. `[damping]` adds to it")
        .from("0")
        .within("0 or more; only `\"reduced\"`"),
    by_hand("geometric_stiffening", kFlag, "whether tension stiffens it")
        .from("true; of matrices whether they have it"),
    by_hand("interface", kTables, "[interfaces](#solids), one or more").from("required"),
    choice<&spatial::SolidBody::frame, spatial::SolidFrame::clamped,
           spatial::SolidFrame::mean_axis>(
        "reference_frame",
        "`\"clamped\"`: the frame is that of the first interface; `\"mean_axis\"`: deformation has "
        "neither momentum nor moment of momentum, for a body that flies by itself")
        .within("`\"mean_axis\"` only `\"reduced\"`"),
    by_hand("format", kWord, "of matrices in place of a mesh: the program that wrote them")
        .among("calculix abaqus matrix_market"),
    by_hand("mass", kText, "file of the mass matrix"),
    by_hand("stiffness", kText, "file of the stiffness matrix"),
    by_hand("nodes", kText, "file of the nodes' places"),
    by_hand("geometric_stiffness", kTable, "files of its geometric stiffness").from("none")};

inline constexpr std::array kMaterialRows{
    number<&spatial::SolidMaterial::youngs_modulus>("youngs_modulus", Quantity::positive("Pa"),
                                                    "Young's modulus")
        .required(),
    number<&spatial::SolidMaterial::poissons_ratio>("poissons_ratio", Quantity::inside(-1.0, 0.5),
                                                    "Poisson's ratio")
        .required(),
    number<&spatial::SolidMaterial::density>("density", Quantity::positive("kg/m^3"),
                                             "mass density")
        .required()};

inline constexpr std::array kScaleRows{number<&spatial::SolidBody::length_scale>(
    "length", spatial::kLengthScale, "metres by the unit of length in the mesh")};

inline constexpr std::array kInterfaceRows{
    by_hand("name", kText, "unlike that of any other interface of the body")
        .required()
        .within("letters, digits, `_`, `-`, `.`; up to 64"),
    by_hand("nodes", kText | kTable, "its nodes, see below")
        .required()
        .within("one or more, not on one line")
        .as("nodes"),
    choice<&spatial::SolidInterface::kind, spatial::InterfaceKind::rigid,
           spatial::InterfaceKind::average>(
        "kind",
        "`\"rigid\"`: they move as a rigid body; `\"average\"`: the interface follows their mean "
        "and does not stiffen them"),
    by_hand("point", kNumbers, kLength,
            "where joints and loads act, in the axes of the mesh: `[x, y, z]`")
        .from("the mean of the nodes, by area if they are on faces")
        .of(std::size_t{3})};

inline constexpr std::array kNodesRows{
    by_hand("plane", kTable, "those at most `tolerance` from a plane"),
    by_hand("cylinder", kTable, "those at most `tolerance` from the mantle of a cylinder: a bore"),
    by_hand("box", kTable, "those in a box")};

inline constexpr std::array kPlaneNodesRows{
    vector<&spatial::PlaneNodes::point>("point", kLength, "on the plane").required(),
    vector<&spatial::PlaneNodes::normal>("normal", spatial::kDirection,
                                         "of the plane, of any length")
        .required(),
    number<&spatial::PlaneNodes::tolerance>("tolerance", Quantity::positive("m"),
                                            "distance from the plane")};

inline constexpr std::array kCylinderNodesRows{
    vector<&spatial::CylinderNodes::point>("point", kLength, "on the axis").required(),
    vector<&spatial::CylinderNodes::axis>("axis", spatial::kDirection,
                                          "of the cylinder, of any length")
        .required(),
    number<&spatial::CylinderNodes::radius>("radius", Quantity::positive("m"), "of the cylinder")
        .required(),
    number<&spatial::CylinderNodes::tolerance>("tolerance", Quantity::positive("m"),
                                               "distance from its mantle")};

inline constexpr std::array kBoxNodesRows{
    vector<&spatial::BoxNodes::from>("from", kLength, "least coordinates").required(),
    vector<&spatial::BoxNodes::to>("to", kLength, "greatest coordinates").required()};

inline constexpr std::array kGeometricStiffnessRows{
    by_hand("own", kTexts,
            "six files of stiffness by the stresses under unit accelerations of rotation")
        .required()
        .of(std::size_t{6}),
    by_hand("translation", kTexts, "three by those of translation").required().of(std::size_t{3})};

}  // namespace spoke::keys
