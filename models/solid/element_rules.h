#pragma once

// Rules of quadrature on parent elements: the tetrahedron with corners at 0 and the three unit
// vectors, and the cube from -1 to 1.

#include <Eigen/Core>
#include <vector>

namespace spoke::solid {

/// A place of a parent element and its weight.
struct ParentPoint {
  Eigen::Vector3d place;
  double weight;
};

std::vector<ParentPoint> tetrahedron_1();    ///< exact to degree 1
std::vector<ParentPoint> tetrahedron_4();    ///< to degree 2
std::vector<ParentPoint> tetrahedron_14();   ///< to degree 5 (Walkington)
std::vector<ParentPoint> tetrahedron_125();  ///< to degree 7 (Gauss's, collapsed)

/// Gauss's rule of `points` (2, 3 or 5) along each axis: exact to degree 2 points - 1 in each
/// coordinate.
std::vector<ParentPoint> cube_points(int points);

}  // namespace spoke::solid
