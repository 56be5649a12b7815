#pragma once

// A solid without a mesh: nodes in a grid, each cell with mass and a rod between any two corners.

#include "models/space/solid.h"

namespace spoke::test {

struct Lattice {
  int x = 4, y = 1, z = 1;    ///< cells along the axes
  bool has_rigid_end = true;  ///< whether the nodes at the greatest x move as a rigid interface
  double cell = 0.1;          ///< length of a cell [m]
};

/// Makes the constants of such a solid in the coordinates of its nodes, in the order of the nodes
/// with the interface's first. The nodes at x = 0 stand fixed; they are the first place. The second
/// is the interface at the other end, or the mean displacement of its nodes.
space::SolidConstants make_lattice(const Lattice& lattice);

}  // namespace spoke::test
