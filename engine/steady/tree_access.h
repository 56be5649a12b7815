#pragma once

// What differs between the worlds where a tree's state is set and read as one vector.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/steady/steady_model.h"
#include "engine/table/step_data.h"

namespace spoke::steady {

/// Coordinates of the joint that carries a body; none in the plane.
int count_joint_coordinates(const TreeBody<Plane>& body);
int count_joint_coordinates(const TreeBody<Space>& body);

/// Sets the coordinates or velocities of the joint.
void put_joint(const double* q, const double* v, BodyData<Plane>& body);
void put_joint(const double* q, const double* v, BodyData<Space>& body);
/// Its coordinates, and its accelerations.
void take_joint_position(const BodyData<Plane>& body, double* q);
void take_joint_position(const BodyData<Space>& body, double* q);
void take_joint(const BodyData<Plane>& body, double* a);
void take_joint(const BodyData<Space>& body, double* a);
/// Folds the rotation vector of a spherical joint into its orientation, see settle(); `q`: of the
/// joint.
void fold_joint(double* q, BodyData<Plane>& body);
void fold_joint(double* q, BodyData<Space>& body);
/// Puts the joint at what make_absolute() yields.
void put_absolute(const double* q, BodyData<Plane>& body);
void put_absolute(const double* q, BodyData<Space>& body);
/// The rotation vector of a spherical joint in place of the one since its reference.
void make_absolute(const BodyData<Plane>& body, double* q);
void make_absolute(const BodyData<Space>& body, double* q);
/// Where the joint's coordinates begin.
void take_initial(const TreeBody<Plane>& body, double* q);
void take_initial(const TreeBody<Space>& body, double* q);

/// Names of a body's coordinates, its joint's first. `body`: its name, `joint`: that of its joint.
std::vector<TreeCoordinate> name_coordinates(const TreeBody<Plane>& model, int index,
                                             const std::string& body, const std::string& joint);
std::vector<TreeCoordinate> name_coordinates(const TreeBody<Space>& model, int index,
                                             const std::string& body, const std::string& joint);

/// M_RR, C and Mff of a body: its mass matrix in [twist; deformation].
Eigen::MatrixXd calc_body_mass(const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_mass(const BodyData<Space>& body);
/// K and D of its deformation.
Eigen::MatrixXd calc_body_stiffness(const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_stiffness(const BodyData<Space>& body);
Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Space>& body);

/// Nodes of body `j`; the poses in the table must be those of the state.
void add_places(const SubsystemData<Plane>& data, int j, std::vector<NodePlace>& places);
void add_places(const SubsystemData<Space>& data, int j, std::vector<NodePlace>& places);

/// A vector or wrench of the plane among those of space, and one of space.
Eigen::Vector3d force_of(const Twist& wrench);
Eigen::Vector3d force_of(const space::Twist& wrench);
Eigen::Vector3d moment_of(const Twist& wrench);
Eigen::Vector3d moment_of(const space::Twist& wrench);
/// Axes of the deformed section at the body's inboard end, in the body's frame; of a rigid body
/// those of its frame.
Eigen::Matrix3d inboard_axes(const BodyData<Plane>& body);
Eigen::Matrix3d inboard_axes(const BodyData<Space>& body);

Eigen::Matrix3d axes_of(const Rotation& R);
Eigen::Matrix3d axes_of(const space::Rotation& R);

/// Hub frame turned by the rotational components of `turn`.
Rotation turn_of(const HubVector& turn, const Plane&);
space::Rotation turn_of(const HubVector& turn, const Space&);

}  // namespace spoke::steady
