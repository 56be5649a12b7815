#pragma once

// Writes meshes as files of gmsh and Abaqus, for tests of their readers.

#include <string>

#include "models/solid_body.h"

namespace spoke::test {

/// How a .msh file is written.
enum class MshForm { text, binary, swapped_binary };

/// Returns a mesh as a file of gmsh's format 2.2 or 4.1: its nodes backwards, its sets of faces as
/// physical surfaces, all elements in the physical volume "BODY", and a point that belongs to
/// nothing. Mid nodes are found by their places: edges must be straight.
std::string write_msh22(const spatial::SolidMesh& mesh, MshForm form = MshForm::text);
std::string write_msh41(const spatial::SolidMesh& mesh, MshForm form = MshForm::text);

/// Returns a mesh as an .inp file as gmsh exports it: its nodes backwards, sets of faces as
/// membranes M3D6 in *ELSET, all elements in the set "BODY", with a material.
std::string write_inp(const spatial::SolidMesh& mesh);

/// Gives the nodes numbers with gaps: 7, 10, 13, ...
void number_with_gaps(spatial::SolidMesh& mesh);

}  // namespace spoke::test
