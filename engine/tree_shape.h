#pragma once

// The deformed shape of a blade or subsystem in space, for pictures and for files of other
// programs.

#include <memory>
#include <vector>

#include "models/spatial_model.h"

namespace spoke {

template <class World>
struct Subsystem;
template <class World>
struct SubsystemData;
struct Space;
namespace space {
struct SolidConstants;
}

/// The pose of the hub in the inertial frame.
struct HubPose {
  spatial::Vector position = spatial::Vector::Zero();      ///< of the origin [m]
  spatial::Tensor rotation = spatial::Tensor::Identity();  ///< from the hub's to inertial axes
};

/// A section of a beam, the origin of a rigid body's frame, or for a solid that of its frame, the
/// point of an interface or of a set of nodes that a load acts on. All vectors are resolved in the
/// hub's frame as the scenario describes it.
struct TreeNode {
  spatial::Vector p = spatial::Vector::Zero();  ///< place in the hub's frame [m]
  /// Rotation from the axes of the beam (for a rigid body: of its frame), which turn with the
  /// section, to those of the hub.
  spatial::Tensor R = spatial::Tensor::Identity();
  /// Displacement from the place with all bodies undeformed and the joints as they are [m].
  spatial::Vector displacement = spatial::Vector::Zero();
  spatial::Vector rotation = spatial::Vector::Zero();  ///< from there, rotation vector [rad]
  spatial::Vector velocity = spatial::Vector::Zero();  ///< in the inertial frame [m/s]
  spatial::Vector angular_velocity = spatial::Vector::Zero();  ///< in the inertial frame [rad/s]
};

/// Loads in the middle of an element, by its strains, in the axes of the undeformed element.
struct ElementForces {
  double axial = 0.0;    ///< positive in tension [N]
  double shear = 0.0;    ///< magnitude [N]
  double torsion = 0.0;  ///< [N m]
  double bending = 0.0;  ///< magnitude [N m]
};

/// The shape of a body at one time.
struct TreeBodyShape {
  /// From the inboard end of a beam; one for a rigid body; for a solid that of its frame, then
  /// one for each interface, then one for each set of nodes that loads act on.
  std::vector<TreeNode> nodes{};
  std::vector<ElementForces> forces{};  ///< by element of a beam
  /// Constants of a solid; null for other bodies.
  std::shared_ptr<const space::SolidConstants> solid{};
  std::vector<double> coordinates{};  ///< of the deformation of a solid
  std::vector<double> velocities{};   ///< their rates
};

/// The shape of a blade or subsystem in space at one time: its bodies in the order of `spoke
/// check`.
struct TreeShape {
  std::vector<TreeBodyShape> bodies{};
};

/// Calculates the shape of a blade or subsystem at the state in the table, whose kinematics it
/// recalculates. Bodies with geometric stiffening are foreshortened node by node, as the sensors of
/// the tip have it. `to_hub` takes components of the hub frame of the table to those of the
/// scenario. `shape` keeps its memory from call to call.
void calc_shape(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                const spatial::Tensor& to_hub, TreeShape& shape);

}  // namespace spoke
