#pragma once

// The deformed shape of a blade, for pictures and for files of other programs.

#include <vector>

#include "models/rotor.h"

namespace spoke {

template <class World>
struct Subsystem;
template <class World>
struct SubsystemData;
struct Plane;

/// A node of a blade. All vectors are resolved in the hub frame.
struct ShapeNode {
  Position p{0.0, 0.0};             ///< place in the hub frame [m]
  Position displacement{0.0, 0.0};  ///< from its undeformed place [m]
  Position velocity{0.0, 0.0};      ///< relative to the inertial frame [m/s]
  double angle = 0.0;               ///< rotation of the section from its undeformed direction [rad]
};

/// The shape of a blade at one time. Nodes count from 0 at the root; the last node of a body is the
/// first one of the next. Element e of body j joins node j elements + e and the next one.
struct BladeShape {
  int bodies = 0;                    ///< of the blade
  int elements = 0;                  ///< of each body
  std::vector<ShapeNode> nodes;      ///< bodies * elements + 1
  std::vector<double> axial_forces;  ///< mean of each element, positive in tension [N]
  /// In the middle of each element, positive where the blade bends counterclockwise [N m].
  std::vector<double> bending_moments;
};

/// Calculates the shape of a blade at the state in the table, whose kinematics it recalculates. The
/// tip is where the sensors of the tip have it: bodies with geometric stiffening are foreshortened,
/// node by node. The axial force is that of the stretch of the element, EA (u_2 - u_1)/l, the
/// bending moment that of its curvature, EI (psi_2 - psi_1)/l. `shape` keeps its memory from call
/// to call.
void calc_shape(const Blade& blade, const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data,
                BladeShape& shape);

}  // namespace spoke
