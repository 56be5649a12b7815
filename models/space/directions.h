#pragma once

// The constants of a body whose directions are decoupled, by direction and with four nodes or
// elements side by side, as vector registers take them (docs/formulation.md, section 10).
//
// The directions are axial (u), torsion (tx), and two planes of bending: (v, tz) with y and (w,
// -ty) with z. In each plane a node has a place and a slope, and both planes have the same masses.

#include <array>
#include <vector>

#include "models/space/slot_masses.h"

namespace spoke::space {

/// Values of four neighbours, the first one first; zero beyond the body's end.
using Lanes = std::array<double, 4>;

/// Factors of a node's inner neighbour, of itself and of its outer neighbour.
struct Band {
  Lanes inner{}, own{}, outer{};
};

/// Four nodes. A node's slots are its place r and its axes t, d, g along x, y, z.
struct NodeLanes {
  /// A momentum, component by component: x follows from u, y from (v, tz), z from (w, -ty).
  struct Momentum {
    Lanes undeformed{};  ///< x component of the undeformed body [kg m]
    Band axial;          ///< factors of u [kg]
    Band place, slope;   ///< [kg, kg m]
  };
  Momentum r;  ///< momentum of the places
  Momentum t;  ///< momentum of the axes along x
  /// Momentum that goes with u: that of the places, and the share of the stretch of the elements at
  /// the node.
  Momentum stretched;
  // Momenta of the axes along y and z, which turn with the node.
  Band d, g;  ///< [kg m^2]
  /// y component of d, z component of g, undeformed [kg m^2].
  Lanes d_undeformed{}, g_undeformed{};
  // Momentum of the body per acceleration of the coordinates.
  Lanes axial{}, place{}, slope{};  ///< [kg, kg m]
};

/// Four elements.
struct ElementLanes {
  Lanes length{};  ///< [m]
  Lanes axial{};   ///< stiffness against stretch [N/m]
  Lanes torsion{};
  /// Bending stiffness by plane, for displacement and slope of the outer node relative to the inner
  /// one.
  struct Bending {
    Lanes shear{}, mixed{}, moment{};
  };
  std::array<Bending, 2> bending;
  /// A tension matrix for the rise between the nodes and the slopes of both, and its trapeze
  /// effect.
  struct Tension {
    Lanes rise{}, rise_inner{}, rise_outer{}, inner{}, between{}, outer{};
    Lanes torsion{};
  };
  std::array<Tension, ElementStiffening::kWeights> tension;
  /// Second moments of turned sections, 22 and 33: a quarter, for sums of the rotations of both
  /// nodes in place of means.
  std::array<Lanes, 2> turning{};
};

struct Directions {
  std::vector<NodeLanes> nodes;  ///< nodes from the first one that has coordinates
  std::vector<ElementLanes> elements;
};

/// The data from which directions are made, by node and element, as in FlexibleBody.
struct DirectedBody {
  const std::vector<Position>& nodes;
  const std::vector<BeamElement>& beam;
  const SlotMasses& slots;
  const std::vector<NodeMomentum>& C_t;
  int first_node;
};

/// Sorts a body's constants by direction. Preconditions: its directions are decoupled, and no small
/// masses turn with it.
Directions make_directions(const DirectedBody& body);

}  // namespace spoke::space
