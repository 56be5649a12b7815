#pragma once

// The constants of a body whose directions do not meet, by direction and with four nodes or
// elements side by side, as vector registers take them (docs/formulation.md, section 10).
//
// The directions are axial (u), torsion (tx), and two planes of bending: (v, tz) with y and
// (w, -ty) with z. In each plane a node has a place and a slope, and both planes have the same
// masses.

#include <array>
#include <vector>

#include "models/space/slot_masses.h"

namespace spoke::space {

/// Of four neighbours, the first first; of those beyond the body's end, zero.
using Lanes = std::array<double, 4>;

/// Factors of a node's inner neighbour, of itself and of its outer neighbour.
struct Band {
  Lanes inner{}, own{}, outer{};
};

/// Four nodes. A node's slots are its place r and its axes t, d, g along x, y, z.
struct NodeLanes {
  /// A momentum, component by component: x follows from u, y from (v, tz), z from (w, -ty).
  struct Momentum {
    Lanes undeformed{};  ///< x component [kg m]
    Band axial;          ///< of u [kg]
    Band place, slope;   ///< [kg, kg m]
  };
  Momentum r;  ///< of the places
  Momentum t;  ///< of the axes along x
  /// What moves with u: the places, and what the elements at the node add by their stretch.
  Momentum stretched;
  // Of the axes along y and z, which turn with the node.
  Band d, g;                             ///< [kg m^2]
  Lanes d_undeformed{}, g_undeformed{};  ///< y component of d, z component of g [kg m^2]
  // How accelerations count in the body's momentum.
  Lanes axial{}, place{}, slope{};  ///< [kg, kg m]
};

/// Four elements.
struct ElementLanes {
  Lanes length{};  ///< [m]
  Lanes axial{};   ///< stiffness against stretch [N/m]
  Lanes torsion{};
  /// Of the outer node's displacement and slope as seen from the inner, by plane.
  struct Bending {
    Lanes shear{}, mixed{}, moment{};
  };
  std::array<Bending, 2> bending;
  /// A tension matrix, on the rise between the nodes and the slopes of both, and its trapeze
  /// effect.
  struct Tension {
    Lanes rise{}, rise_inner{}, rise_outer{}, inner{}, between{}, outer{};
    Lanes torsion{};
  };
  std::array<Tension, ElementStiffening::kWeights> tension;
  /// Propeller matrices 22 and 33 by their entries 11, 12, 22.
  std::array<std::array<Lanes, 3>, 2> propeller{};
};

struct Directions {
  std::vector<NodeLanes> nodes;  ///< from the first node that has coordinates
  std::vector<ElementLanes> elements;
};

/// What they are made of, by node and element, as in FlexibleBody.
struct DirectedBody {
  const std::vector<Position>& nodes;
  const std::vector<BeamElement>& beam;
  const SlotMasses& slots;
  const std::vector<NodeMomentum>& C_t;
  int first_node;
};

/// Preconditions: the directions of the body do not meet, and no small masses turn with it.
Directions make_directions(const DirectedBody& body);

}  // namespace spoke::space
