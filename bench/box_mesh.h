#pragma once

// Meshes of boxes, to measure solids of any size.

#include <array>

#include "models/solid_body.h"

namespace spoke::bench {

/// A bar along x, its axis on the x axis from 0 on, of so many cells of six quadratic tetrahedra.
struct BoxSize {
  std::array<int, 3> cells{1, 1, 1};
  std::array<double, 3> lengths{1.0, 0.1, 0.1};  ///< [m]
};

/// Returns its mesh, without sets.
spatial::SolidMesh make_box_mesh(const BoxSize& size);

}  // namespace spoke::bench
