#pragma once

// Where the bodies of a tree in space stand, for pictures and for files of other programs.

#include <vector>

#include "models/spatial_model.h"

namespace spoke {

template <class World>
struct Subsystem;
template <class World>
struct SubsystemData;
struct Space;

/// A frame in the inertial frame.
struct HubPose {
  spatial::Vector position = spatial::Vector::Zero();      ///< of the origin [m]
  spatial::Tensor rotation = spatial::Tensor::Identity();  ///< from the hub's to inertial axes
};

/// A section of a beam, or the origin of a rigid body's frame. All vectors are resolved in the
/// hub's frame as the scenario describes it.
struct TreeNode {
  spatial::Vector p = spatial::Vector::Zero();  ///< place in the hub's frame [m]
  /// From axes of the beam (of a rigid body: of its frame), which turn with the section, to the
  /// hub's.
  spatial::Tensor R = spatial::Tensor::Identity();
  /// From where it would be if no body were deformed, the joints standing as they do [m].
  spatial::Vector displacement = spatial::Vector::Zero();
  spatial::Vector rotation = spatial::Vector::Zero();          ///< likewise, rotation vector [rad]
  spatial::Vector velocity = spatial::Vector::Zero();          ///< in the inertial frame [m/s]
  spatial::Vector angular_velocity = spatial::Vector::Zero();  ///< likewise [rad/s]
};

/// What an element bears in its middle, by its strains; axes of the undeformed element.
struct ElementForces {
  double axial = 0.0;    ///< positive in tension [N]
  double shear = 0.0;    ///< magnitude [N]
  double torsion = 0.0;  ///< [N m]
  double bending = 0.0;  ///< magnitude [N m]
};

/// A body at one time.
struct TreeBodyShape {
  std::vector<TreeNode> nodes{};        ///< of a beam from its inboard end; of a rigid body one
  std::vector<ElementForces> forces{};  ///< by element
};

/// A blade or subsystem in space at one time: its bodies in the order of `spoke check`.
struct TreeShape {
  std::vector<TreeBodyShape> bodies{};
};

/// The shape of a tree at the state in the table, whose kinematics it recalculates. Bodies with
/// geometric stiffening are foreshortened node by node, as the tip's sensors have it. `to_hub`
/// takes components of the table's hub frame to those of the scenario's. `shape` keeps its memory
/// from call to call.
void calc_shape(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                const spatial::Tensor& to_hub, TreeShape& shape);

}  // namespace spoke
