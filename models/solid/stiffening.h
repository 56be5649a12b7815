#pragma once

// Geometric stiffness of the linear stresses under unit loads: of rotation, of translation, and of
// wrenches on places. docs/formulation.md, section 13.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "models/solid/constraints.h"
#include "models/solid/vibration.h"

namespace spoke::solid {

/// Displacements q under loads in the coordinates q.
using StaticMap = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// Returns the loads - M A^(k) x of the six monomials of w, in the displacements of nodes.
Eigen::MatrixXd spin_loads(const Sparse& m, const std::vector<space::Position>& x);
/// Returns the loads - M e_c.
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
