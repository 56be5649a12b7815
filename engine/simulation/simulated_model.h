#pragma once

// A model on the table, of either world: what a simulation needs of it besides its steps.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/load.h"
#include "engine/loops_at_start.h"
#include "engine/simulation/anchors.h"
#include "engine/simulation/diagnosis.h"
#include "engine/simulation/sensors.h"
#include "engine/simulation/spatial_joints.h"
#include "engine/simulation_options.h"
#include "engine/step/step_context.h"
#include "engine/tree_shape.h"
#include "models/drive.h"
#include "models/scenario.h"

namespace spoke {

/// Size of a model.
struct ModelExtent {
  int subsystems = 0;
  int bodies = 0;
  int coordinates = 0;       ///< of deformations and joints, and free ones of the hub
  int loops = 0;             ///< closed ones
  int couplings = 0;         ///< of joints
  int independent_rows = 0;  ///< of loops, rigid and not redundant; known once it is allocated
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
  virtual Anchors anchors() = 0;

  /// Returns the memory of the rings of the table for one step [bytes].
  virtual double ring_bytes() const = 0;
  /// Allocates the table with so many records, and places loads and sensors. Must be called once,
  /// before all else.
  virtual void allocate(int records) = 0;
  /// Makes a copy of the model at the end of step `steps`, at which it stands, allocated with so
  /// many records: motions, loads, wind and sensors are those in force, constants are shared, see
  /// begin_copy(). `scenario` must outlive the copy. Throws InputError if the memory of this
  /// machine does not suffice.
  virtual std::unique_ptr<SimulatedModel> copy(const Scenario& scenario, int records,
                                               std::int64_t steps) = 0;
  /// Shares the subsystems out, see spoke::share_out().
  virtual void share_out(Exchange& exchange) = 0;
  /// Puts the bodies at coordinates, see spoke::put_bodies().
  virtual void put_bodies(const std::vector<Eigen::VectorXd>& q) = 0;

  virtual ModelExtent extent() const = 0;
  virtual double memory_bytes() const = 0;
  virtual std::size_t count_state() = 0;
  virtual std::uint64_t hash() const = 0;
  /// Whether there is such a body, counted from 0.
  virtual bool has_body(std::int64_t subsystem, std::int64_t body) const = 0;
  /// Whether there is such a row of a loop, counted from 0 through all loops of the subsystem.
  virtual bool has_loop_row(std::int64_t subsystem, std::int64_t row) const = 0;
  /// Returns the drive of a rotor, by its number.
  virtual Drive& drive(int rotor) = 0;
  /// Replaces the drive of the first rotor by another one of the same kind, and puts the hub where
  /// that begins.
  /// Precondition: t = 0.
  virtual void begin_drive(const Drive& drive) = 0;
  /// Returns the place of load number `index` of those given, which `other` may replace. Throws
  /// InputError if there is none, or if `other` cannot replace it.
  virtual std::shared_ptr<const Load>& replaceable_load(
      int index, const std::shared_ptr<const Load>& other) = 0;

  // Views, see Simulation: for markers that require_place() accepts, at a state whose accelerations
  // and wrenches are in the table.
  /// Throws InputError if a marker is on no body.
  virtual void require_place(const Marker& marker) const = 0;
  virtual MarkerState marker(const Marker& marker, double t) const = 0;
  virtual Wrench joint_reaction(int subsystem, int joint) const = 0;
  /// Throws InputError if there is no such subsystem, or no loop of that name on it.
  virtual void require_loop(int subsystem, std::string_view loop) const = 0;
  virtual Wrench loop_reaction(int subsystem, std::string_view loop, double t) const = 0;
  virtual Wrench hub_reaction() const = 0;
  virtual Wrench section_force(const Marker& marker) const = 0;

  // Sensors of the world, see Sensors and SpatialSensors.
  virtual const std::vector<std::string>& sensor_names() const = 0;
  virtual const std::vector<std::string>& sensor_units() const = 0;
  /// Takes the state at the start as reference of energy, and returns that energy [J].
  virtual double start_sensors() = 0;
  /// Returns the strain energy that the tolerance of the iteration leaves open, see
  /// calc_energy_resolution() [J].
  virtual double energy_resolution() const = 0;
  virtual void sample(std::int64_t step, double t) = 0;
  virtual const std::vector<double>& measure(const WorkDone& work, std::int64_t step) = 0;
  virtual const EnergyBalance& balance() const = 0;
  /// Returns the balance of a free model on which nothing acts at the step measured last; else
  /// null.
  virtual const MomentumBalance* momentum() const = 0;
  /// Returns the record of a complete step.
  virtual const StepRecord& record(std::int64_t step) const = 0;

  /// Calculates a shape or the pose of the hub, see Simulation::calc_shape() and hub_pose().
  virtual void calc_shape(int subsystem, double t, TreeShape& shape) = 0;
  virtual HubPose hub_pose() const = 0;
  /// Returns velocities and accelerations of the frame of the hub at time t [s], see
  /// Simulation::hub_frame().
  virtual MarkerState hub_frame(double t) const = 0;
  /// Returns the motion of what a support stands on, see Simulation::base_frame().
  virtual MarkerMotion base_frame(double t) const = 0;
  /// See Simulation::loops_at_start().
  virtual LoopsAtStart loops_at_start() const = 0;
  /// Returns the motion of an anchor's frame, or of the mount's (-1), see Simulation.
  virtual MarkerMotion carrier_frame(int anchor, double t) const = 0;

  /// Makes the error of a failed step, see diagnose().
  virtual DivergenceError diagnose(const FailedStep& failed) const = 0;
  /// Returns the load that has failed, see UserLoads::find_failed().
  virtual FailedLoad find_failed_load(const std::string& at) const = 0;
};

}  // namespace spoke
