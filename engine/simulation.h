#pragma once

// The main interface of the engine: makes a system from a scenario, steps it, reads sensors and
// states.

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formulation.h"
#include "engine/load.h"
#include "engine/loops_at_start.h"
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

/// Properties of the linearised model at rest.
struct LinearProperties {
  double lowest_frequency = 0.0;   ///< natural frequency [rad/s]
  double highest_frequency = 0.0;  ///< natural frequency [rad/s]
  /// The largest stable step of rk4, with damping and linear drag [s]; without these 2 sqrt(2) /
  /// highest_frequency. In space the smaller one of those at rest and at the largest speed that the
  /// drive prescribes.
  double rk4_largest_step = 0.0;
};

/// A view of the coordinates of deformation of one body [m, rad]. In the plane 3 E values for E
/// elements: first the E axial ones (u), then the 2 E of bending (v and psi by node, without those
/// that the reference frame fixes). In space 6 E values: u, v, w and rotations tx, ty, tz by node,
/// without those that the frame fixes; none for a rigid body.
struct BodyState {
  std::vector<double> coordinates;    ///< [m, rad]
  std::vector<double> velocities;     ///< [m/s, rad/s]
  std::vector<double> accelerations;  ///< [m/s^2, rad/s^2]
};

/// The motion of a hub in the inertial frame, in the plane or in space; vectors are resolved there.
struct HubFrame : HubPose {
  spatial::Vector velocity = spatial::Vector::Zero();              ///< of the origin [m/s]
  spatial::Vector angular_velocity = spatial::Vector::Zero();      ///< [rad/s]
  spatial::Vector acceleration = spatial::Vector::Zero();          ///< of the origin [m/s^2]
  spatial::Vector angular_acceleration = spatial::Vector::Zero();  ///< [rad/s^2]
};

/// The motion of a planar hub in the inertial frame: x [m], y [m], angle [rad] and their
/// derivatives.
struct HubMotion {
  Twist position{0.0, 0.0, 0.0};      ///< [m, rad]
  Twist velocity{0.0, 0.0, 0.0};      ///< [m/s, rad/s]
  Twist acceleration{0.0, 0.0, 0.0};  ///< [m/s^2, rad/s^2]
};

/// The motion of a coordinate of a joint at one time.
struct CoordinateMotion {
  double value = 0.0;         ///< [rad, m]
  double velocity = 0.0;      ///< [rad/s, m/s]
  double acceleration = 0.0;  ///< [rad/s^2, m/s^2]
};

/// The motion of an anchor at one time, in the frame in which it moves (Anchor::frame).
struct AnchorMotion {
  spatial::Vector translation = spatial::Vector::Zero();            ///< [m]
  spatial::Vector velocity = spatial::Vector::Zero();               ///< [m/s]
  spatial::Vector acceleration = spatial::Vector::Zero();           ///< [m/s^2]
  spatial::Vector rotation = spatial::Vector::Zero();               ///< rotation vector [rad]
  spatial::Vector rotation_rate = spatial::Vector::Zero();          ///< its derivative [rad/s]
  spatial::Vector rotation_acceleration = spatial::Vector::Zero();  ///< its second one [rad/s^2]
};

class SimulationCore;

/// Simulates one system. Copied by clone() alone; different Simulations may run in different
/// threads.
class SPOKE_EXPORT Simulation {
 public:
  /// Builds the constants of the system, its step graph and executor, and evaluates the
  /// accelerations at t = 0. `loads` act besides those of the scenario. Throws InputError, naming
  /// the key, if the scenario could not stand in a file as it is (docs/scenario.md); if an option
  /// is not valid; if the model does not fit the memory of this machine; if a load has no place on
  /// the system. Throws LoadError if a load fails at t = 0, DivergenceError if there is no
  /// acceleration.
  explicit Simulation(const Scenario& scenario, const SimulationOptions& options = {},
                      const Loads& loads = {});
  ~Simulation();
  /// Returns a simulation at the same state, which goes on by itself to the bits that this one
  /// would: states, sensors, warnings, with the drive, motions, factors and wind in force. It takes
  /// the copying of the state, and a table and step graph of its own; the scenario is not read
  /// again, and bodies, meshes, wind and the factors of their matrices, none of which changes, are
  /// shared. So both may be stepped at once, in two threads; this one is not to be used by another
  /// thread meanwhile. Loads of the program's own and a wind of its own are shared, too: both call
  /// them, at times at once; what such a load keeps besides its arguments, both change. Options
  /// are the same: each has an executor of its own, and "auto" chooses anew. Throws StateError
  /// after a step that could not be completed, and if an observer or a load that this simulation
  /// calls asks; InputError if several processes simulate the model together, or its memory does
  /// not suffice for another one.
  Simulation clone() const;
  /// Moves a simulation. The one that is moved from may only be destroyed or assigned to.
  Simulation(Simulation&&) noexcept;
  /// Moves a simulation, as the constructor does.
  Simulation& operator=(Simulation&&) noexcept;

  const Scenario& scenario() const;          ///< as given
  const SimulationOptions& options() const;  ///< as given
  ModelSize size() const;                    ///< of the model and its graph
  /// Returns the graph of one pass that the executor runs; valid while this lives.
  const graph::StepGraph& step_graph() const;
  /// Returns the graph that run_until() runs: of one pass, or of the passes of a window of steps.
  /// Valid while this lives.
  const graph::StepGraph& run_graph() const;
  /// Returns properties of the model at rest, undeformed, joints as they start, without loads and
  /// gravity. Takes a while for large models. In space, if nothing vibrates, frequencies are 0 and
  /// the step is infinite; throws InputError if a blade or subsystem has more than 1000
  /// coordinates, or all have more than 100,000.
  LinearProperties linear_properties() const;
  /// Returns the kind of the executor: "auto", "serial", ..., or the name of an executor of the
  /// program.
  std::string_view executor_name() const;
  /// Returns one line about what runs the steps; for "auto" what it has chosen so far, and why.
  std::string executor_description() const;
  graph::Threads threads() const;  ///< in use by the executor

  /// Returns what the start made of closed loops: which joints were moved and how far, freedoms and
  /// redundant rows.
  LoopsAtStart loops_at_start() const;

  double time() const;                 ///< [s]
  double step_size() const;            ///< in use [s]
  std::int64_t steps() const;          ///< done so far
  std::int64_t planned_steps() const;  ///< in the whole duration
  std::int64_t evaluations() const;    ///< of the accelerations, so far
  /// Whether the duration is over.
  bool done() const { return steps() >= planned_steps(); }

  /// Makes one time step. Throws DivergenceError, after which the simulation stays at the failed
  /// step and must not be stepped again until a state is restored. Throws LoadError if a load
  /// fails; the simulation then stands at the end of the step before, and can be stepped again.
  void step();
  /// Makes steps until time() >= t - half a step, or done(). Calls `observe` for every step, in
  /// order, on the calling thread. t [s]; infinity: to the end. Faster than as many calls of
  /// step(), see SimulationOptions::window. Throws InputError if t is not a number. Throws
  /// DivergenceError and LoadError like step(), after `observe` was called for all complete steps;
  /// an exception that `observe` throws ends the run at its step.
  void run_until(double t, const StepObserver& observe = {});
  /// Asks the run_until() that is calling an observer to return soon: as soon as all blades have
  /// made the steps that any of them has begun, for each of which the observer is called. Has no
  /// effect elsewhere.
  void stop();
  /// Makes `steps` steps as run_until() does, to the same bits, with the present executor, and
  /// records which thread ran which node when. `options.finished` is called with the slices of
  /// every step as it is finished. An executor that chooses postpones that: call run_until()
  /// before, to see what it chooses. Steps that are less than half a window run without a window.
  /// Throws like run_until(), after `options.unfinished` was called with the records until then.
  /// Throws InputError unless 1 <= steps <= planned_steps() - this->steps().
  StepTrace trace(std::int64_t steps, const StepObserver& observe = {},
                  const TraceOptions& options = TraceOptions());

  /// Returns a copy of the state, at the cost of some vectors of coordinates. Throws StateError
  /// after a step that could not be completed.
  SavedState save() const;
  /// Goes back or forward to a saved state of any simulation of the same model, formulation and
  /// step size, whatever its executor, threads and window: the following steps have the bits of the
  /// run that was saved. May be called after DivergenceError. Throws InputError, saying what
  /// differs, if the state is of another model, or if a number in it is not finite; the simulation
  /// then stays as it is.
  void restore(const SavedState& state);

  /// Returns the names of the sensors in the order of sensor_values(): "blade1.tip.x", ...,
  /// "energy.residual", further ones of the blades, and those of Scenario::sensors
  /// (docs/results.md).
  const std::vector<std::string>& sensor_names() const;
  /// Returns the units of the sensors in the same order: "m", "rad", "N m", "J", ...
  const std::vector<std::string>& sensor_units() const;
  /// Returns the sensors at time(). The span is valid until the next step.
  std::span<const double> sensor_values() const;
  /// Returns the place of a sensor in sensor_values(), which does not change, for programs that
  /// read it often. Throws InputError for an unknown name.
  std::size_t sensor_index(std::string_view name) const;
  /// Returns one sensor at time(). Throws InputError for an unknown name.
  double sensor(std::string_view name) const;

  /// Returns the warnings so far, at most one of each kind, in the order of kinds. They are a
  /// function of the steps alone; restore() sets them back. Growth of the energy is looked for at
  /// steps for which an observer is called, or at all steps if limits.on_energy_growth is "stop":
  /// then DivergenceError is thrown, and the simulation stands at the end of that step.
  std::vector<Warning> warnings() const;
  /// Returns the largest estimated error of a step so far.
  StepAccuracy step_accuracy() const;
  /// Returns the events of the scenario in its order, with the times at which they acted. They
  /// depend on the steps alone; restore() sets them back.
  std::vector<EventInRun> events() const;

  /// Returns the motion of the hub at time(). Throws InputError if the model is in space.
  HubMotion hub() const;
  /// Returns the motion of the hub at time(), in the plane or in space.
  HubFrame hub_frame() const;
  /// Returns the motion of the frame of an anchor at time(), counted from 0 in the order of the
  /// scenario, in the inertial frame. Throws InputError if there is none.
  MarkerMotion anchor_frame(int anchor) const;
  /// Returns the motion of the frame in which the hub turns about its axle, likewise: the hub's at
  /// an angle of 0; where there is a support, that of what it stands on.
  MarkerMotion mount_frame() const;
  /// Returns the deformation of a body. Throws InputError if there is none; both numbers count from
  /// 0, in space blades before subsystems.
  BodyState body(int blade, int body) const;
  /// Calculates the places of the nodes of a blade at time(), and the tension of its elements.
  /// `shape` keeps its memory from call to call. Throws InputError if there is no such blade,
  /// counted from 0.
  void calc_shape(int blade, BladeShape& shape) const;
  /// Calculates the shape of a blade or subsystem of a model in space, counted from 0 in the order
  /// of Scenario::space. Throws InputError if there is none.
  void calc_shape(int tree, TreeShape& shape) const;
  /// Returns the pose of the frame of the hub at time(), in the plane or in space.
  HubPose hub_pose() const;
  /// Returns the motion of what a support stands on, the ground or the fuselage, in the inertial
  /// frame; that of the hub where there is no support.
  MarkerMotion base_frame() const;

  // The following functions are for the state at time(), and take one evaluation of the
  // accelerations at the first call for a state. Places that do not exist throw InputError; after a
  // step that failed all throw StateError.

  /// Returns motion and deflection of a point anywhere on a body.
  MarkerState marker(const Marker& marker) const;
  /// Returns the wrench of the joint inboard of a body (0: at the hub) on the body, about the
  /// joint, in the inertial frame.
  Wrench joint_reaction(int blade, int joint) const;
  /// Returns the wrench that the loop of that name on a blade or subsystem exerts on its place
  /// `from`, about it, in the inertial frame. A loop of kind `distance` pulls along the line
  /// between its places where it is in tension. Throws InputError, with the nearest name, if there
  /// is no such loop.
  Wrench loop_reaction(int tree, std::string_view loop) const;
  /// Returns the wrench of support and drive on the hub, about its axis, in space about its origin,
  /// in the inertial frame. It carries the hub and the roots of the blades; if blades have
  /// geometric stiffening, also a moment that the model puts on the hub directly, since bending
  /// takes mass nearer to the axis.
  Wrench hub_reaction() const;
  /// Returns the wrench of the part of a blade outboard of a section on the part inboard, in the
  /// frame of the section: in the plane x is the axial force (positive in tension), y the shear
  /// force, z the bending moment; in space there are all six components, and x is the torque among
  /// the moments. It follows from the strains of the finite element, so that axial and shear force
  /// are constant along an element of a uniform blade; where two elements meet, it is that of the
  /// outer one, in space of the inner one.
  Wrench section_force(const Marker& marker) const;

  // Changes between steps. They act from the next step on. No saved state contains them, and
  // restore() leaves them as they are: to go back with those that were in force, take courses() of
  // engine/courses.h with save(), and give both to the restore() there.

  /// Returns the drive in force, of several rotors that of the one by this name; of the first
  /// without a name. Throws InputError, with the nearest name, if there is no such rotor.
  const Drive& drive(std::string_view rotor = {}) const;
  /// Replaces the drive, likewise. The new one must prescribe the rotation of the hub if and only
  /// if the present one does, and must then go on from angle and speed of the hub (to 1e-9 rad and
  /// rad/s). Throws InputError; StateError after a step that failed; LoadError or DivergenceError
  /// if there is no acceleration with it. The simulation then stays as it is.
  void set_drive(const Drive& drive, std::string_view rotor = {});
  /// Returns the number of the joint of that name on a blade or subsystem, counted from 0 in the
  /// order of Scenario::space, for programs that use it often. Throws InputError if there is none.
  int joint_index(int tree, std::string_view name) const;
  /// Returns the motion at time() of a coordinate of a joint: as the scenario or the program
  /// prescribes it, or as it is found of one that is free (its acceleration by the last
  /// evaluation); joint as in joint_reaction(), coordinate from 0 in the order of the scenario.
  /// Throws InputError if there is none, or if it is free and one of a rotation in space.
  CoordinateMotion joint_motion(int tree, int joint, int coordinate = 0) const;
  /// Replaces the motion of a coordinate that the scenario leaves to the program (motion = { by =
  /// "program" }): from time() on it is value + velocity s + acceleration s^2/2, with s the time
  /// since. It must go on from joint_motion() in value and velocity (to 1e-9); a controller thus
  /// sets accelerations. Throws like set_drive(); the simulation then stays as it is.
  void set_joint_motion(int tree, int joint, int coordinate, const CoordinateMotion& motion);
  /// Replaces the motion by a function of time: `course` over time [s], which must go on from
  /// joint_motion() in value and velocity; a constant stretch before time() lets it start from
  /// rest.
  void set_joint_course(int tree, int joint, int coordinate, const Curve& course);
  /// Does the same. It is a template so that {} means a CoordinateMotion.
  template <std::convertible_to<Curve> Course>
  void set_joint_motion(int tree, int joint, int coordinate, const Course& course) {
    set_joint_course(tree, joint, coordinate, course);
  }
  /// Returns the motion at time() of an anchor, prescribed by the scenario or the program; if it
  /// turns with the hub, without that rotation. Throws InputError, with the nearest name, if there
  /// is none of that name.
  AnchorMotion anchor_motion(std::string_view anchor) const;
  /// Replaces the motion of an anchor that the scenario leaves to the program (motion = { by =
  /// "program" }): from time() on translation and rotation vector are value + rate s + acceleration
  /// s^2/2, with s the time since. They must go on from anchor_motion() in value and rate (to
  /// 1e-9); a controller thus sets accelerations. Throws like set_drive(); the simulation then
  /// stays as it is.
  void set_anchor_motion(std::string_view anchor, const AnchorMotion& motion);
  /// Replaces the motion by functions of time [s], which must go on from anchor_motion() in value
  /// and rate; constant stretches before time() let them start from rest.
  void set_anchor_course(std::string_view anchor, const spatial::MountMotion& course);
  /// Does the same. It is a template so that {} means an AnchorMotion.
  template <std::convertible_to<spatial::MountMotion> Course>
  void set_anchor_motion(std::string_view anchor, const Course& course) {
    set_anchor_course(anchor, course);
  }
  /// Replaces load number `index` of those given to the constructor by one with the same markers.
  /// To change parameters of a load of your own, change them and set the load again. Throws like
  /// set_drive().
  void set_load(int index, std::shared_ptr<const Load> load);

  /// Returns a 64-bit hash (FNV-1a) of the state: position and velocity of the hub, all coordinates
  /// and velocities.
  std::uint64_t state_hash() const;

 private:
  friend SimulationCore& core_of(Simulation& simulation);
  explicit Simulation(std::unique_ptr<SimulationCore> core);

  std::unique_ptr<SimulationCore> core_;
};

}  // namespace spoke
