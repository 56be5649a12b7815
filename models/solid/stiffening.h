#pragma once

// Geometric stiffness of the linear stresses under unit loads: of rotation, of translation, and of
// wrenches on places. docs/formulation.md, section 13.

#include <Eigen/Core>
#include <vector>

#include "models/solid/assembly.h"
#include "models/space/solid.h"

namespace spoke::solid {

/// Returns the loads - M A^(k) x of the six monomials of w, a column each, in the displacements of
/// nodes: 3 n x 6 [kg m, forces by (rad/s)^2]. `m`: n x n [kg]; `x`: places of the nodes in B [m].
Eigen::MatrixXd spin_loads(const Sparse& m, const std::vector<space::Position>& x);
/// Returns the loads - M e_c of accelerations along x, y and z, a column each: 3 n x 3 [kg, forces
/// by m/s^2].
Eigen::MatrixXd translation_loads(const Sparse& m);
/// Returns E^T, the loads of unit forces and moments on a place, in nf coordinates q.
Eigen::MatrixXd place_loads(const space::SolidPlace& place, Eigen::Index coordinates);

/// Geometric stiffness kg of unit loads, as values in the places of those of m, a column each.
struct StressMatrices {
  Eigen::MatrixXd own;                  ///< six columns
  Eigen::MatrixXd translation;          ///< three
  std::vector<Eigen::MatrixXd> places;  ///< six each
};

/// Writes them into the matrices of a solid: projected on the shapes, or as they are.
void write_stiffening(const StressMatrices& stresses, const Sparse& m, space::ReducedSolid& solid);
void write_stiffening(const StressMatrices& stresses, space::NodalSolid& solid);

}  // namespace spoke::solid
