#pragma once

// The engine's front door: load or build a system, step, read sensors and states.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formulation/formulation.h"
#include "engine/load.h"
#include "engine/saved_state.h"
#include "engine/shape.h"
#include "engine/simulation_options.h"
#include "engine/step_trace.h"
#include "engine/tree_shape.h"
#include "engine/warnings.h"
#include "graph/step_graph.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// What a model does at rest, linearised.
struct LinearProperties {
  double lowest_frequency = 0.0;   ///< natural, of the vibrations [rad/s]
  double highest_frequency = 0.0;  ///< [rad/s]
  /// With damping and linear drag [s]; without, 2 sqrt(2) / highest_frequency. In space at rest and
  /// at the largest speed that the drive prescribes, the lesser one.
  double rk4_largest_step = 0.0;
};

/// A view of one body's deformation coordinates: in the plane 3 E values, the E axial ones (u)
/// first, then the 2 E of bending (v, psi by node, without those that the reference frame fixes);
/// in space 6 E: u, v, w and rotations tx, ty, tz by node, likewise; of a rigid body none [m, rad].
struct BodyState {
  std::vector<double> coordinates;    ///< [m, rad]
  std::vector<double> velocities;     ///< [m/s, rad/s]
  std::vector<double> accelerations;  ///< [m/s^2, rad/s^2]
};

/// A hub's motion in the inertial frame, of either world; vectors are resolved there.
struct HubFrame : HubPose {
  spatial::Vector velocity = spatial::Vector::Zero();              ///< of the origin [m/s]
  spatial::Vector angular_velocity = spatial::Vector::Zero();      ///< [rad/s]
  spatial::Vector acceleration = spatial::Vector::Zero();          ///< of the origin [m/s^2]
  spatial::Vector angular_acceleration = spatial::Vector::Zero();  ///< [rad/s^2]
};

/// A planar hub's motion in the inertial frame: x [m], y [m], angle [rad] and their derivatives.
struct HubMotion {
  Twist position{0.0, 0.0, 0.0};      ///< [m, rad]
  Twist velocity{0.0, 0.0, 0.0};      ///< [m/s, rad/s]
  Twist acceleration{0.0, 0.0, 0.0};  ///< [m/s^2, rad/s^2]
};

/// The motion of a joint's coordinate at one time.
struct CoordinateMotion {
  double value = 0.0;         ///< [rad, m]
  double velocity = 0.0;      ///< [rad/s, m/s]
  double acceleration = 0.0;  ///< [rad/s^2, m/s^2]
};

class SimulationCore;

/// Simulates one system. Not copyable; different Simulations may run in different threads.
class SPOKE_EXPORT Simulation {
 public:
  /// Builds the system's constants, its step graph and executor, and evaluates the accelerations
  /// at t = 0. `loads` act besides those of the scenario. Throws InputError if the scenario could
  /// not stand in a file as it is (docs/scenario.md), naming the key; if an option is none; if the
  /// model does not fit this machine's memory; if a load has no place on the system. Throws
  /// LoadError if a load fails at t = 0, DivergenceError if there is no acceleration.
  explicit Simulation(const Scenario& scenario, const SimulationOptions& options = {},
                      const Loads& loads = {});
  ~Simulation();
  /// The other one is only to be destroyed or assigned to.
  Simulation(Simulation&&) noexcept;
  /// The same.
  Simulation& operator=(Simulation&&) noexcept;

  const Scenario& scenario() const;          ///< as given
  const SimulationOptions& options() const;  ///< as given
  ModelSize size() const;                    ///< of the model and its graph
  /// The graph that the executor runs; valid while this lives.
  const graph::StepGraph& step_graph() const;
  /// The graph that run_until() runs: of one pass, or of the passes of a window of steps. Valid
  /// while this lives.
  const graph::StepGraph& run_graph() const;
  /// Of the model at rest, undeformed, joints as they start, without loads and gravity. Takes a
  /// while for large ones. In space, if nothing vibrates, frequencies of 0 and an infinite step;
  /// throws InputError if a tree has more than 1000 coordinates, or all have more than 100,000.
  LinearProperties linear_properties() const;
  /// The kind of the executor: "auto", "serial", ..., or the name of one of the program's own.
  std::string_view executor_name() const;
  /// In one line what runs the steps; of "auto" what it chose so far, and why.
  std::string executor_description() const;
  graph::Threads threads() const;  ///< in use by the executor

  double time() const;                 ///< [s]
  double step_size() const;            ///< in use [s]
  std::int64_t steps() const;          ///< done so far
  std::int64_t planned_steps() const;  ///< in the whole duration
  std::int64_t evaluations() const;    ///< of the accelerations, so far
  /// Whether the duration is over.
  bool done() const { return steps() >= planned_steps(); }

  /// One time step. Throws DivergenceError, after which the simulation stays at the failed step and
  /// must not be stepped again until a state is restored. Throws LoadError if a load fails; the
  /// simulation then stands at the end of the step before, and can be stepped again.
  void step();
  /// Steps until time() >= t - half a step, or done(), and tells `observe` of every step, in order,
  /// on the calling thread; t [s], infinity: to the end. Faster than as many calls of step(): see
  /// SimulationOptions::window. Throws InputError if t is not a number. Throws DivergenceError and
  /// LoadError like step(), after the observer was told of all complete steps; what the observer
  /// throws ends the run at the step that it was told of.
  void run_until(double t, const StepObserver& observe = {});
  /// Asks the run_until() that is calling an observer to return soon: once all blades have made the
  /// steps that any of them has begun, each of which the observer is told. Without effect
  /// elsewhere.
  void stop();
  /// Makes `steps` steps as run_until() does, to the same bits, by what runs the steps at present,
  /// and records which thread ran which node when; `options.finished` is told of every step's
  /// slices as it is finished. An executor that chooses waits with it meanwhile: run_until()
  /// before, to see what it chooses. Steps that are less than half a window run without. Throws
  /// like run_until(), after `options.unfinished` was told what was recorded until then. Throws
  /// InputError unless 1 <= steps <= planned_steps() - this->steps().
  StepTrace trace(std::int64_t steps, const StepObserver& observe = {},
                  const TraceOptions& options = TraceOptions());

  /// Copies the state, at the cost of some vectors of coordinates. Throws StateError after a step
  /// that could not be completed.
  SavedState save() const;
  /// Goes back, or on, to a saved state of any simulation of the same model, formulation and step
  /// size, whatever its executor, threads and window: what follows has the bits of the run that was
  /// saved. Also after DivergenceError. Throws InputError, saying what differs, if the state is of
  /// another model, or if a number of it is not finite; the simulation then stays as it is.
  void restore(const SavedState& state);

  /// Sensor names in the order of sensor_values(): "blade1.tip.x", ..., "energy.residual", further
  /// ones of the blades, and those of Scenario::sensors (docs/results.md).
  const std::vector<std::string>& sensor_names() const;
  /// Units of the sensors, in the same order: "m", "rad", "N m", "J", ...
  const std::vector<std::string>& sensor_units() const;
  /// The sensors at time(). The span is valid until the next step.
  std::span<const double> sensor_values() const;
  /// A sensor's place in sensor_values(), which it keeps: the handle of those who read it often.
  /// Throws InputError for an unknown name.
  std::size_t sensor_index(std::string_view name) const;
  /// One sensor at time(). Throws InputError for an unknown name.
  double sensor(std::string_view name) const;

  /// What makes the results doubtful so far, at most one of each kind, in the order of kinds; a
  /// function of the steps alone, as restore() sets it back. Growth of the energy is looked for at
  /// steps that an observer is told of, or at all if limits.on_energy_growth says "stop": then
  /// DivergenceError is thrown, and the simulation stands at the end of that step.
  std::vector<Warning> warnings() const;
  /// The largest estimated error of a step so far.
  StepAccuracy step_accuracy() const;

  /// The hub's motion at time(). Throws InputError if the model is in space.
  HubMotion hub() const;
  /// The hub's motion at time(), of either world.
  HubFrame hub_frame() const;
  /// The deformation of a body. Throws InputError if there is none, both counted from 0, in space
  /// blades before subsystems.
  BodyState body(int blade, int body) const;
  /// Where the nodes of a blade stand at time(), and the tension of its elements. `shape` keeps its
  /// memory from call to call. Throws InputError if there is no such blade, counted from 0.
  void calc_shape(int blade, BladeShape& shape) const;
  /// The same of a blade or subsystem of a model in space, counted from 0 in the order of
  /// Scenario::space. Throws InputError if there is none.
  void calc_shape(int tree, TreeShape& shape) const;
  /// Where the hub's frame is at time(), of either world.
  HubPose hub_pose() const;

  // What follows is of the state at time(), and takes one evaluation of the accelerations when
  // first asked for at a state. Places that do not exist throw InputError; after a step that
  // failed, StateError.

  /// Motion and deflection of a point anywhere on a body.
  MarkerState marker(const Marker& marker) const;
  /// What the joint inboard of a body (0: at the hub) does to the body, about the joint; inertial
  /// frame.
  Wrench joint_reaction(int blade, int joint) const;
  /// What support and drive do to the hub, about its axis, in space about its origin; inertial
  /// frame. It carries the hub and
  /// the roots of the blades; of blades with geometric stiffening also a moment that the model puts
  /// on the hub directly, since bending takes mass nearer to the axis.
  Wrench hub_reaction() const;
  /// What the part of a blade outboard of a section does to the part inboard, in the frame of the
  /// section: in the plane x the axial force (positive in tension), y the shear force, z the
  /// bending moment; in space all six, x the torque among the moments. By the strains of the finite
  /// element, so that along an element of a uniform blade the axial force is constant, and the
  /// shear force; where two elements meet, those of the outer one, in space of the inner one.
  Wrench section_force(const Marker& marker) const;

  // Changes between steps. They act from the next step on. They are the caller's: no saved state
  // contains them, and restore() leaves them as they are.

  /// The drive in force.
  const Drive& drive() const;
  /// Replaces the drive, by one that prescribes the hub's rotation if and only if the present one
  /// does, and then goes on from the hub's angle and speed (to 1e-9 rad and rad/s). Throws
  /// InputError, StateError after a step that failed, LoadError or DivergenceError if there is no
  /// acceleration with it; the simulation then stays as it is.
  void set_drive(const Drive& drive);
  /// The number of the joint of that name on a blade or subsystem, counted from 0 in the order of
  /// Scenario::space: the handle of those who use it often. Throws InputError if there is none.
  int joint_index(int tree, std::string_view name) const;
  /// Where a joint's coordinate is at time() whose motion is prescribed, by whatever; joint as in
  /// joint_reaction(), coordinate from 0 in the order of the scenario. Throws InputError if there
  /// is none.
  CoordinateMotion joint_motion(int tree, int joint, int coordinate = 0) const;
  /// Replaces the motion of a coordinate that the scenario leaves to the program (motion = { by =
  /// "program" }): from time() on value + velocity s + acceleration s^2/2, with s the time since.
  /// It goes on from where the coordinate is, joint_motion(), in value and velocity (to 1e-9); a
  /// controller thus sets accelerations. Throws like set_drive(); the simulation then stays as it
  /// is.
  void set_joint_motion(int tree, int joint, int coordinate, const CoordinateMotion& motion);
  /// The same by a function of time: `course` over time [s], which goes on likewise; a constant
  /// stretch before time() lets it start from rest.
  void set_joint_motion(int tree, int joint, int coordinate, const Curve& course);
  /// Replaces load number `index` of those given to the constructor, by one with the same markers.
  /// To change the parameters of a load of one's own, change them and set it again. Throws
  /// like set_drive().
  void set_load(int index, std::shared_ptr<const Load> load);

  /// 64-bit hash (FNV-1a) of the state: hub position and velocity, all coordinates and velocities.
  std::uint64_t state_hash() const;

 private:
  friend SimulationCore& core_of(Simulation& simulation);

  std::unique_ptr<SimulationCore> core_;
};

}  // namespace spoke
