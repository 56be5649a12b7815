#pragma once

// The state of a subsystem's bodies as one vector, set and read by world.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Returns the number of coordinates of the joint that carries a body; 0 in the plane.
int count_joint_coordinates(const TreeBody<Plane>& body);
int count_joint_coordinates(const TreeBody<Space>& body);

/// Sets the coordinates and velocities of the joint.
void put_joint(const double* q, const double* v, BodyData<Plane>& body);
void put_joint(const double* q, const double* v, BodyData<Space>& body);
/// Reads the joint's coordinates, or its accelerations (take_joint()).
void take_joint_position(const BodyData<Plane>& body, double* q);
void take_joint_position(const BodyData<Space>& body, double* q);
void take_joint(const BodyData<Plane>& body, double* a);
void take_joint(const BodyData<Space>& body, double* a);
/// Folds the rotation vector of a spherical joint into its orientation, see SteadyModel::settle();
/// `q` has the coordinates of the joint.
void fold_joint(double* q, BodyData<Plane>& body);
void fold_joint(double* q, BodyData<Space>& body);
/// Puts the joint at the coordinates that make_absolute() returned.
void put_absolute(const double* q, BodyData<Plane>& body);
void put_absolute(const double* q, BodyData<Space>& body);
/// Replaces the rotation vector of a spherical joint since its reference by the one from parent to
/// child.
void make_absolute(const BodyData<Plane>& body, double* q);
void make_absolute(const BodyData<Space>& body, double* q);
/// Lets the joint start at the coordinates that make_absolute() returned.
void put_initial(const double* q, TreeBody<Plane>& body);
void put_initial(const double* q, TreeBody<Space>& body);
/// Reads the coordinates at which the joint starts.
void take_initial(const TreeBody<Plane>& body, double* q);
void take_initial(const TreeBody<Space>& body, double* q);

/// Returns the names of a body's coordinates, those of its joint first. `body` is the body's name,
/// `joint` that of its joint.
std::vector<SubsystemCoordinate> name_coordinates(const TreeBody<Plane>& model, int index,
                                                  const std::string& body,
                                                  const std::string& joint);
std::vector<SubsystemCoordinate> name_coordinates(const TreeBody<Space>& model, int index,
                                                  const std::string& body,
                                                  const std::string& joint);

/// Returns the mass matrix of a body in [twist; deformation], made of M_RR, C and Mff.
Eigen::MatrixXd calc_body_mass(const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_mass(const BodyData<Space>& body);
/// Returns K, or D, of the deformation of a body.
Eigen::MatrixXd calc_body_stiffness(const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_stiffness(const BodyData<Space>& body);
Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Plane>& body);
Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Space>& body);

/// Adds the nodes of body `j`. Precondition: the poses in the table are those of the state.
void add_places(const SubsystemData<Plane>& data, int j, std::vector<NodePlace>& places);
void add_places(const SubsystemData<Space>& data, int j, std::vector<NodePlace>& places);

/// Returns the axes of the outer end of a body. Precondition: as of add_places().
Eigen::Matrix3d outer_axes(const SubsystemData<Plane>& data, std::size_t body);
Eigen::Matrix3d outer_axes(const SubsystemData<Space>& data, std::size_t body);

/// Returns the constants of a body from a mesh; null for others.
std::shared_ptr<const space::SolidConstants> mesh_of(const BodyData<Plane>& body);
std::shared_ptr<const space::SolidConstants> mesh_of(const BodyData<Space>& body);

/// Returns the force or moment of a wrench of either world as a vector in space.
Eigen::Vector3d force_of(const Twist& wrench);
Eigen::Vector3d force_of(const space::Twist& wrench);
Eigen::Vector3d moment_of(const Twist& wrench);
Eigen::Vector3d moment_of(const space::Twist& wrench);
/// Returns the axes of the deformed section at the inboard end of a body, in the frame of the body;
/// for a rigid body the axes of its frame.
Eigen::Matrix3d inboard_axes(const BodyData<Plane>& body);
Eigen::Matrix3d inboard_axes(const BodyData<Space>& body);

Eigen::Matrix3d axes_of(const plane::Rotation& R);
Eigen::Matrix3d axes_of(const space::Rotation& R);

/// Returns the rotation by the rotational components of `turn`.
plane::Rotation turn_of(const HubVector& turn, const Plane&);
space::Rotation turn_of(const HubVector& turn, const Space&);

}  // namespace spoke::steady
