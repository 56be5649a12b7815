#pragma once

// A model in steady rotation: the forces on its coordinates as a function of the state, seen from
// the frame that turns with the hub, where nothing depends on time. Kinematics and terms are those
// of the step graph's own nodes; what is said here of "trees" holds for the blades of the plane,
// too.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/linearize.h"
#include "models/scenario.h"

namespace spoke::steady {

/// Components of a twist: 3 in the plane, 6 in space.
using HubVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

/// A coordinate of a tree.
struct TreeCoordinate {
  std::string name;    ///< "body 2 / node 3 / v", "flap_hinge"; of joints numbered if several
  std::string joint;   ///< of a joint's, the joint
  int body = 0;        ///< of the tree
  int node = -1;       ///< of the body; -1: of the joint that carries it
  bool turns = false;  ///< [rad], else [m]
  double scale = 1.0;  ///< a large value of it [rad, m]
};

/// Velocities of a coordinate by which to differ: what its scale is in the time of a radian.
inline double velocity_scale(const TreeCoordinate& coordinate, double speed) {
  return coordinate.scale * std::max(1.0, std::abs(speed));
}

/// Where to evaluate a tree. Coordinates and velocities in the order of coordinates(): by body its
/// joint's, then its deformation's. Elastic forces are taken at `q_elastic`, their dampers at
/// `v_elastic`, of which those of joints do not count.
struct TreeState {
  Eigen::VectorXd q, v;
  Eigen::VectorXd q_elastic, v_elastic;
};

/// How the hub moves besides its steady rotation, in its frame: the rotation vector by which it is
/// turned, and its additional twist and acceleration.
struct HubOffset {
  HubVector turn;          ///< rotational components of a twist, the others unused [rad]
  HubVector twist;         ///< [m/s, rad/s]
  HubVector acceleration;  ///< [m/s^2, rad/s^2]
};

/// What a tree does there.
struct TreeResponse {
  Eigen::VectorXd force;  ///< on its coordinates, with that of inertia at zero accelerations
  HubVector hub_force;    ///< likewise on the hub, at its origin, hub frame
  bool is_valid = true;   ///< all is finite, and no body is beyond its limits
};

/// Mass matrix of a tree and the hub's frame, and its constant damping.
struct TreeMatrices {
  Eigen::MatrixXd mass;     ///< hub's twist first, then the coordinates
  Eigen::MatrixXd damping;  ///< D of the deformations, without joints
};

/// A node of a body, for pictures and names of shapes; hub frame.
struct NodePlace {
  Eigen::Vector3d p;       ///< [m]
  Eigen::Matrix3d axes;    ///< of its section, columns
  Eigen::Vector3d centre;  ///< of its mass; p, but for rigid bodies [m]
  double mass = 0.0;       ///< lumped [kg]
  double inertia = 0.0;    ///< about its axis, lumped [kg m^2]
  int body = 0;            ///< of the tree
};

/// The tip of a tree against its undeformed place, hub frame.
struct TipMotion {
  Eigen::Vector3d displacement;  ///< as the sensors have it [m]
  Eigen::Vector3d rotation;      ///< rotation vector [rad]
};

/// What a body does to what carries it: the load of the section where it begins, like that of the
/// sensors section_force, in that section's axes; of a rigid body in its frame's.
struct RootLoad {
  std::string body;
  double station = 0.0;    ///< undeformed distance of that end from the tree's root [m]
  Eigen::Vector3d force;   ///< [N]
  Eigen::Vector3d moment;  ///< [N m]
};

/// When what acts on a model has the values that count.
enum class Instant {
  end,    ///< those that curves end with, all ramps over
  start,  ///< those at t = 0
};

/// What of a scenario is steady.
struct SteadyOptions {
  double speed = 0.0;  ///< of the hub about its axis [rad/s]
  Instant instant = Instant::end;
  bool has_outputs = false;  ///< whether the scenario's sensors are to be read
};

class SteadyModel {
 public:
  virtual ~SteadyModel() = default;
  SteadyModel() = default;
  SteadyModel(const SteadyModel&) = delete;
  SteadyModel& operator=(const SteadyModel&) = delete;

  virtual std::size_t trees() const = 0;
  virtual const std::string& name_of(std::size_t tree) const = 0;
  virtual const std::vector<TreeCoordinate>& coordinates(std::size_t tree) const = 0;
  /// Direction of a tree about the hub's axis [rad].
  virtual double azimuth(std::size_t tree) const = 0;
  /// Of all trees.
  std::vector<double> azimuths() const {
    std::vector<double> all(trees());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = azimuth(i);
    return all;
  }
  /// Axes of what carries a body, where that is fixed to the hub: of a blade x along it, z along
  /// the axis of rotation; hub frame.
  virtual Eigen::Matrix3d root_axes(std::size_t tree, int body) const = 0;
  virtual bool is_spatial() const = 0;
  /// Components of a twist.
  virtual int twist_size() const = 0;
  /// Index of the first rotational one.
  int first_rotation() const { return is_spatial() ? 3 : 2; }
  /// Which of them are unknowns of the model: all of a free hub, the rotation of a driven one.
  virtual const std::vector<int>& free_components() const = 0;
  virtual bool is_hub_free() const = 0;
  /// Whether the drive's torque depends on nothing but the balance: it is then what holds the
  /// speed.
  virtual bool has_torque_drive() const = 0;
  double speed() const { return speed_; }

  /// Sets the share of loads, gravity and the speed's square, from 0 to 1.
  virtual void set_share(double share) = 0;

  /// Coordinates at the start of the search: undeformed, joints where the scenario has them.
  virtual Eigen::VectorXd initial(std::size_t tree) const = 0;
  /// Takes coordinates as the state about which spherical joints are turned, and sets the rotation
  /// vectors of these to zero.
  virtual void settle(std::size_t tree, Eigen::VectorXd& q) = 0;
  /// Turns spherical joints from where another model of the same bodies has settled: at coordinates
  /// that its absolute() yields.
  virtual void settle_at(std::size_t tree, const Eigen::VectorXd& absolute) = 0;

  virtual void evaluate(std::size_t tree, const TreeState& state, const HubOffset& hub,
                        TreeResponse& response) = 0;
  /// K of the deformations, without joints; constant.
  virtual const Eigen::MatrixXd& stiffness(std::size_t tree) const = 0;
  // At the state that was evaluated last.
  /// The accelerations that the step graph finds, and so what bodies do to those that carry them.
  virtual Eigen::VectorXd accelerations(std::size_t tree) = 0;
  virtual TreeMatrices matrices(std::size_t tree) = 0;

  /// Forces of the hub's own inertia, of drive and loads at an offset, its acceleration being zero.
  virtual HubVector hub_force(const HubOffset& hub) const = 0;
  /// Mass of the hub alone.
  virtual Eigen::MatrixXd hub_mass() const = 0;

  // At the state that was evaluated last.
  virtual std::vector<NodePlace> places(std::size_t tree) = 0;
  virtual TipMotion tip(std::size_t tree) = 0;
  /// After accelerations().
  virtual std::vector<RootLoad> root_loads(std::size_t tree) const = 0;
  /// By body, its largest deflection across its axis by its length; of rigid ones 0.
  virtual std::vector<double> bending(std::size_t tree) const = 0;
  /// What a free joint's coordinates are; spherical ones as the rotation vector from parent to
  /// child.
  virtual Eigen::VectorXd absolute(std::size_t tree, const Eigen::VectorXd& q) const = 0;

  // What comes out, if SteadyOptions::has_outputs.
  /// What measure() yields: displacement of the tip, and the scenario's sensors on the tree whose
  /// frames turn with the hub.
  virtual const std::vector<LinearSignal>& outputs(std::size_t tree) const = 0;
  /// Sensors of the scenario's that are no such outputs, by the names of their columns.
  virtual const std::vector<std::string>& other_sensors() const = 0;
  /// At the state that was evaluated last, after accelerations().
  virtual Eigen::VectorXd measure(std::size_t tree) = 0;

  HubOffset no_offset() const {
    const HubVector none = HubVector::Zero(twist_size());
    return {none, none, none};
  }

 protected:
  double speed_ = 0.0;
};

/// The model of a scenario in steady rotation: loads, motors and prescribed joints with the values
/// that their curves have at options.instant, pitch by azimuth with its mean. Where the hub turns,
/// gravity and loads of constant direction count with their part along the axis. Where the hub is
/// free, gravity does not count: all falls alike. Throws InputError like Simulation.
std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options);

}  // namespace spoke::steady
