#pragma once

// Solids for tests: boxes of material, held at their ends.

#include <memory>
#include <string>

#include "models/solid/solid_problem.h"
#include "tests/models/solid/grid_mesh.h"

namespace spoke::test {

/// Nodes of a set of a mesh, which all count equally.
solid::ChosenNodes choose_equally(const spatial::SolidMesh& mesh, const std::string& set);

/// A problem without interfaces whose frame has its origin at `origin`.
solid::SolidProblem make_problem(const spatial::SolidMesh& mesh,
                                 const spatial::SolidMaterial& material,
                                 const spatial::Vector& origin);

/// Adds an interface at the mean of a set's nodes.
void add_interface(solid::SolidProblem& problem, const std::string& set,
                   spatial::InterfaceKind kind = spatial::InterfaceKind::rigid);

/// Returns the bar grid(nx, ny, nz; lengths), its section centred on the x axis if `is_centred`.
spatial::SolidMesh make_bar(std::array<int, 3> cells, std::array<double, 3> lengths,
                            spatial::ElementKind kind, bool is_centred = false);

/// The L-bracket of references: grid(4, 1, 4; 0.4, 0.1, 0.4) of tet10, cells with i = 0 or k = 0.
spatial::SolidMesh make_bracket();

/// E 70e9, nu 0.33, rho 2700.
spatial::SolidMaterial aluminium();

}  // namespace spoke::test
