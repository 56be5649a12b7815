#pragma once

// Coordinates of a solid: which displacements of its nodes are free, and how those of interfaces
// follow from them. docs/formulation.md, section 13.

#include <Eigen/Core>
#include <vector>

#include "models/solid/assembly.h"
#include "models/solid/solid.h"

namespace spoke::solid {

/// An interface with its nodes, or a set of nodes that a load acts on.
struct HeldNodes {
  std::string name;
  spatial::InterfaceKind kind = spatial::InterfaceKind::rigid;
  ChosenNodes chosen;
};

/// Maps the displacements of nodes to a place's [displacement; rotation] by their weighted mean
/// (RBE3): six rows, three columns a chosen node. Rotations about axes that the nodes do not
/// determine, since they are on one line or one point, are 0. `x`: places of all nodes.
Eigen::Matrix<double, 6, Eigen::Dynamic> make_average(const ChosenNodes& chosen,
                                                      const std::vector<space::Position>& x);

/// Coordinates q with u = Xi q: three of each free node in the order of the nodes, then six of each
/// rigid interface that the frame does not fix, (displacement of its point, rotation).
struct Constraints {
  Sparse Xi;         ///< 3 n x nf
  int boundary = 0;  ///< coordinates of rigid interfaces, the last of q
  /// Displacements that follow from others since the mean of an interface is 0: six, or none.
  std::vector<int> dependent;
  std::vector<space::SolidPlace> places;  ///< interfaces, then sets, in nodal coordinates
  /// The rigid motions in q: translations, and rotations about B's origin. Of the frame `mean_axis`
  /// only, else empty.
  Eigen::MatrixXd rigid;
};

/// Makes coordinates and places. The frame `clamped` fixes the first interface: a rigid one's
/// nodes; of one of kind `average` six displacements follow from the others, so that its mean is 0.
/// `nodes`: places of the nodes in B, chosen points too. Precondition: nodes of rigid interfaces
/// belong to no other, those of an interface are not on one line.
Constraints make_constraints(const std::vector<space::Position>& nodes,
                             const std::vector<HeldNodes>& interfaces,
                             const std::vector<HeldNodes>& sets, spatial::SolidFrame frame);

}  // namespace spoke::solid
