#pragma once

// A model on the table, whatever its world: what a simulation asks of it besides its steps.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/load.h"
#include "engine/simulation/diagnosis.h"
#include "engine/simulation/sensors.h"
#include "engine/simulation/spatial_joints.h"
#include "engine/simulation_options.h"
#include "engine/step/step_context.h"
#include "engine/tree_shape.h"
#include "models/drive.h"
#include "models/scenario.h"

namespace spoke {

/// How large a model is.
struct ModelExtent {
  int subsystems = 0;
  int bodies = 0;
  int coordinates = 0;  ///< deformations, joints and the free ones of the hub
};

/// The data of a model, its sensors, and words about it.
class SimulatedModel {
 public:
  virtual ~SimulatedModel() = default;
  SimulatedModel() = default;
  SimulatedModel(const SimulatedModel&) = delete;
  SimulatedModel& operator=(const SimulatedModel&) = delete;

  virtual StepContext& context() = 0;
  const StepContext& context() const { return const_cast<SimulatedModel*>(this)->context(); }
  /// Null if the model is in space.
  virtual SystemContext<Plane>* plane() { return nullptr; }
  // Null if the model is in the plane.
  virtual SystemContext<Space>* space() { return nullptr; }
  virtual SpatialJoints* joints() { return nullptr; }

  /// What the rings of the table hold of a step [bytes].
  virtual double ring_bytes() const = 0;
  /// Allocates the table with so many records, and places loads and sensors. Once, first.
  virtual void allocate(int records) = 0;
  /// See spoke::share_out().
  virtual void share_out(Exchange& exchange) = 0;
  /// By which it would share out.
  virtual std::vector<double> weights() const = 0;
  /// See spoke::put_bodies().
  virtual void put_bodies(const std::vector<Eigen::VectorXd>& q) = 0;

  virtual ModelExtent extent() const = 0;
  virtual double memory_bytes() const = 0;
  virtual std::size_t count_state() = 0;
  virtual std::uint64_t hash() const = 0;
  /// Whether there is such a body, counted from 0.
  virtual bool has_body(std::int64_t blade, std::int64_t body) const = 0;
  virtual Drive& drive() = 0;
  /// Puts another drive of the same kind in place, and the hub where that begins. At t = 0.
  virtual void begin_drive(const Drive& drive) = 0;
  /// Load number `index` of those given, which `other` may replace. Throws InputError if there is
  /// none, or if `other` cannot.
  virtual std::shared_ptr<const Load>& replaceable_load(
      int index, const std::shared_ptr<const Load>& other) = 0;

  // Views, see Simulation: of markers that require_place() accepts, at a state whose accelerations
  // and wrenches are in the table.
  /// Throws InputError if a marker is on no body.
  virtual void require_place(const Marker& marker) const = 0;
  virtual MarkerState marker(const Marker& marker, double t) const = 0;
  virtual Wrench joint_reaction(int blade, int joint) const = 0;
  virtual Wrench hub_reaction() const = 0;
  virtual Wrench section_force(const Marker& marker) const = 0;

  // Sensors, see Sensors.
  virtual const std::vector<std::string>& sensor_names() const = 0;
  virtual const std::vector<std::string>& sensor_units() const = 0;
  /// Takes the state at the start as reference of energy; returns that energy [J].
  virtual double start_sensors() = 0;
  /// Strain energy that the iteration's tolerance leaves open, see calc_energy_resolution() [J].
  virtual double energy_resolution() const = 0;
  virtual void sample(std::int64_t step, double t) = 0;
  virtual const std::vector<double>& measure(const WorkDone& work, std::int64_t step) = 0;
  virtual const EnergyBalance& balance() const = 0;
  /// Of a free model on which nothing acts, at the step measured last; else null.
  virtual const MomentumBalance* momentum() const = 0;
  /// Of a complete step.
  virtual const StepRecord& record(std::int64_t step) const = 0;

  /// See Simulation::calc_shape() and hub_pose().
  virtual void calc_shape(int tree, double t, TreeShape& shape) = 0;
  virtual HubPose hub_pose() const = 0;
  /// Velocities and accelerations of the hub's frame at time t [s]; see Simulation::hub_frame().
  virtual MarkerState hub_frame(double t) const = 0;

  /// See diagnose() and describe_failed_load().
  virtual DivergenceError diagnose(const FailedStep& failed) const = 0;
  virtual std::string describe_failed_load(const std::string& at) const = 0;
};

}  // namespace spoke
