#pragma once

// Models with solids for tests.

#include <string>

#include "models/spatial_model.h"
#include "models/system/spatial_system.h"
#include "tests/models/solid/grid_mesh.h"

namespace spoke::test {

/// Makes a solid from a box: its face at the least x is the interface "root", that at the greatest
/// "tip".
spatial::SolidBody make_bar(const GridMesh& grid, const spatial::SolidMaterial& material,
                            spatial::InterfaceKind root = spatial::InterfaceKind::rigid,
                            spatial::InterfaceKind tip = spatial::InterfaceKind::rigid);

/// A box of 1 x 0.1 x 0.1 m on its axis, 4 x 1 x 1 tet10.
GridMesh slender_grid();
/// Soft rubber: E 1e7 Pa, nu 0.3, rho 1000 kg/m^3.
spatial::SolidMaterial rubber();

/// Two trees on a hub: a bar of rigid interfaces on a hinge, which carries a bar that follows
/// averages on a spherical joint, a beam and a rigid body; and a bar with mean axes that carries
/// another one.
spatial::Model make_solid_trees(
    HubSupport support, spatial::SolidCoordinates coordinates = spatial::SolidCoordinates::reduced);

/// Cuts the solids of nodal coordinates into so many slices, which small ones are not else.
System<Space> cut_solids(System<Space> system, int slices);

}  // namespace spoke::test
