#pragma once

// A model in steady rotation: the forces on its coordinates as a function of the state, seen from
// the frame that turns with the hub, where nothing depends on time. Kinematics and terms are those
// of the step graph's own nodes.

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/bodies/air/blade_air.h"
#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "models/scenario.h"

namespace spoke::steady {

/// Components of a twist: 3 in the plane, 6 in space.
using HubVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

/// A coordinate of a subsystem.
struct SubsystemCoordinate {
  std::string name;    ///< "body 2 / node 3 / v"; "flap_hinge", numbered if the joint has several
  std::string joint;   ///< the joint whose coordinate it is; else empty
  int body = 0;        ///< of the subsystem
  int node = -1;       ///< of the body; -1: it is of the joint that carries the body
  bool turns = false;  ///< true: an angle [rad]; false: a length [m]
  double scale = 1.0;  ///< a large value of it [rad, m]
  /// Of a rotation vector theta, whose rate is not its velocity H(sense theta) theta': 1 where that
  /// is along axes of the parent, -1 along those of the child; 0: it is of none.
  int sense = 0;
  /// Whether it is no motion, but the force of a ForceState on one [N m, N].
  bool is_force = false;

  std::string unit() const {
    if (is_force) return turns ? "N m" : "N";
    return turns ? "rad" : "m";
  }
};

/// A spring in series with a damper on a coordinate q, about equilibrium, where it is relaxed: the
/// force on q is z - k q, with z' = (k q - z)/T.
struct ForceState {
  Eigen::Index coordinate = 0;  ///< q, of the subsystem
  double stiffness = 0.0;       ///< k [N m/rad, N/m]
  double time = 0.0;            ///< T [s]
  std::size_t state = 0;        ///< of those of advance_states() the one that is k q - z

  bool operator==(const ForceState&) const = default;
};

/// Returns z as one of a subsystem's coordinates, which `q` is another of.
inline SubsystemCoordinate force_on(SubsystemCoordinate q) {
  q.name += " relaxation";
  q.is_force = true;
  return q;
}

/// Returns those of a subsystem's coordinates `x` that deform one of its bodies.
template <class Scalar>
std::vector<Scalar> find_deformation(const std::vector<SubsystemCoordinate>& coordinates, int body,
                                     const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) {
  assert(x.size() == std::ssize(coordinates));
  std::vector<Scalar> own;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    if (coordinate.body == body && coordinate.node >= 0) own.push_back(x[k]);
  }
  return own;
}

/// Returns the velocity step of a coordinate for differences: its scale per time of a radian.
inline double velocity_scale(const SubsystemCoordinate& coordinate, double speed) {
  return coordinate.scale * std::max(1.0, std::abs(speed));
}

/// State at which to evaluate a subsystem. Coordinates and velocities are in the order of
/// coordinates(): for each body those of its joint, then those of its deformation. Elastic forces
/// are taken at `q_elastic`, forces of dampers at `v_elastic`; the entries of joints in `v_elastic`
/// have no effect. Rigid rows of loops have the forces `multipliers`, by row; empty: none.
struct SubsystemState {
  Eigen::VectorXd q, v;
  Eigen::VectorXd q_elastic, v_elastic;
  Eigen::VectorXd multipliers{};
  /// Whether springs in closures have the forces `multipliers`, too, rather than those of the
  /// state; their dampers follow the state.
  bool holds_springs = false;
};

/// A row of a loop of a subsystem: a direction that the loop closes.
struct ClosureRow {
  std::size_t loop = 0;  ///< of the subsystem
  bool is_dropped = false;
  double stiffness = 0.0;  ///< 0: rigid [N/m, N m/rad]
  double damping = 0.0;    ///< [N s/m, N m s/rad]
  /// Of a bearing with matrices: where its other row stands, from this one: 1 or -1; else 0.
  int other = 0;
  double cross_stiffness = 0.0;  ///< force on this row by the opening of the other one [N/m]

  bool is_rigid() const { return stiffness == 0.0 && other == 0 && !is_dropped; }
};

/// The hub's motion besides its steady rotation, in its frame: the rotation vector by which it is
/// turned, and its additional twist and acceleration.
struct HubOffset {
  HubVector turn;          ///< rotational components of a twist, the others unused [rad]
  HubVector twist;         ///< [m/s, rad/s]
  HubVector acceleration;  ///< [m/s^2, rad/s^2]
};

/// Forces of a subsystem at a state.
struct SubsystemResponse {
  Eigen::VectorXd force;        ///< on its coordinates, with inertia at zero accelerations
  HubVector hub_force;          ///< with the same inertia on the hub, at its origin, hub frame
  Eigen::VectorXd openings;     ///< of loops, by row [m, rad]
  Eigen::VectorXd multipliers;  ///< forces of all rows, those of dampers included [N, N m]
  bool is_valid = true;         ///< whether all is finite, and no body is beyond its limits
};

/// Mass matrix of a subsystem and the hub's frame, and its constant damping.
struct SubsystemMatrices {
  Eigen::MatrixXd mass;     ///< rows and columns: the hub's twist, then the coordinates
  Eigen::MatrixXd damping;  ///< D of the deformations, without joints
};

/// A node of a body, for pictures and names of shapes; hub frame.
struct NodePlace {
  Eigen::Vector3d p;       ///< [m]
  Eigen::Matrix3d axes;    ///< of its section, columns
  Eigen::Vector3d centre;  ///< centre of its mass; p except for rigid bodies [m]
  double mass = 0.0;       ///< lumped [kg]
  double inertia = 0.0;    ///< about its axis, lumped [kg m^2]
  int body = 0;            ///< of the subsystem
};

/// The tip of a subsystem against its undeformed place, hub frame.
struct TipMotion {
  Eigen::Vector3d displacement;  ///< as the sensors of the tip show it [m]
  Eigen::Vector3d rotation;      ///< rotation vector [rad]
};

/// Force of a body on its carrier: the load of the section where the body begins, like that of the
/// sensor section_force, in the axes of that section; for a rigid body in the axes of its frame.
struct RootLoad {
  std::string body;
  double station = 0.0;    ///< undeformed distance of that end from the subsystem's root [m]
  Eigen::Vector3d force;   ///< [N]
  Eigen::Vector3d moment;  ///< [N m]
};

/// What air does to a subsystem: along and about the axis of the hub, and at its stations.
struct SubsystemAir {
  double thrust = 0.0;         ///< [N]
  double torque = 0.0;         ///< [N m]
  double wind = 0.0;           ///< at the hub against it, along the axis [m/s]
  std::vector<double> places;  ///< of the stations, from the root [m]
  std::vector<air::StationAir> stations;
};

/// The time at which loads have the values that count.
enum class Instant {
  end,    ///< behind all ramps and curves
  start,  ///< at t = 0
};

/// Choice of the steady rotation of a scenario.
struct SteadyOptions {
  double speed = 0.0;  ///< of the hub about its axis [rad/s]
  Instant instant = Instant::end;
  /// Whether gravity and loads of constant direction count along the axis only even at rest.
  bool is_axial = false;
  /// Whether they count in full even where the hub turns: as they are at the azimuth of
  /// SteadyModel::move_hub().
  bool is_whole = false;
  bool has_outputs = false;  ///< whether the scenario's sensors are to be read
  /// Whether it is a support without its rotor: what follows from accelerations is then not known.
  bool is_support = false;
  /// Whether springs that relax are springs, as in motions that are fast beside them.
  bool holds_forces = false;
  /// Of further rotors on a support, by number from 1; those beyond the end stand [rad/s].
  std::vector<double> further_speeds{};

  /// Returns the speed of a rotor.
  double speed_of(int rotor) const {
    if (rotor == 0) return speed;
    const auto further = static_cast<std::size_t>(rotor) - 1;
    return further < further_speeds.size() ? further_speeds[further] : 0.0;
  }
};

class SteadyModel;

/// A subsystem of the scenario: a whole one of a model, or a member of a group that loops tie.
struct SubsystemPart {
  SteadyModel* model = nullptr;  ///< in which it is a subsystem of its own
  std::size_t subsystem = 0;     ///< its number there
  std::size_t number = 0;        ///< its number among all of the scenario
  int rotor = 0;                 ///< that carries it; of a support 0
  bool is_carried = false;       ///< whether a hub that something moves carries it
  Eigen::Index first = 0;  ///< its first coordinate among those of the subsystem it is part of
  Eigen::Index count = 0;  ///< its coordinates
  std::vector<Eigen::Index> rows{};  ///< by row of its own loops the row among those there

  /// Returns its own coordinates of those of the subsystem.
  auto part_of(const auto& q) const { return q.segment(first, count); }
  /// Returns the forces of the rows of its own loops.
  Eigen::VectorXd forces_of(const Eigen::VectorXd& multipliers) const {
    return multipliers.size() > 0 ? Eigen::VectorXd(multipliers(rows)) : multipliers;
  }
};

/// The hub of a rotor on something that moves it.
struct CarriedHub {
  std::string name;         ///< of the rotor; may be empty where there is one
  double speed = 0.0;       ///< [rad/s]
  NodePlace place;          ///< in the frame of the base
  HubVector wrench;         ///< of its carrier and the drive on it, along its axes [N, N m]
  std::size_t carrier = 0;  ///< number of the scenario's subsystem that carries it
  int body = 0;             ///< that it is there
};

class SupportedModel;

class SteadyModel {
 public:
  virtual ~SteadyModel() = default;
  SteadyModel() = default;
  SteadyModel(const SteadyModel&) = delete;
  SteadyModel& operator=(const SteadyModel&) = delete;

  /// Returns this model if it is a rotor on a support, else null.
  virtual SupportedModel* on_support() { return nullptr; }
  const SupportedModel* on_support() const { return const_cast<SteadyModel*>(this)->on_support(); }
  /// Whether a subsystem is a support: it is in the frame of its base, which stands, rather than in
  /// that of the hub.
  virtual bool stands(std::size_t) const { return false; }
  /// Returns a number of the hub that carries a subsystem; a support has one of its own.
  virtual std::size_t hub_of(std::size_t) const { return 0; }
  /// Returns the number of hubs that carry blades: one, or several on a support.
  virtual std::size_t hubs() const { return 1; }
  /// Returns the model of what a hub carries, with the hub.
  virtual const SteadyModel& rotor(std::size_t) const { return *this; }
  /// Returns what comes before "hub" and "axle" in their names: nothing for the first ones.
  virtual std::string prefix_of(std::size_t) const { return {}; }
  virtual std::size_t subsystems() const = 0;
  virtual const std::string& name_of(std::size_t subsystem) const = 0;
  /// Returns the name of something within a subsystem with that of the subsystem.
  virtual std::string full_name(std::size_t subsystem, const std::string& inner) const {
    return name_of(subsystem) + " / " + inner;
  }
  /// Whether rotors and their support, all at rest, are one subsystem.
  virtual bool is_standing_machine() const { return false; }
  /// Returns the hubs of rotors that something carries, where the model was evaluated last, with
  /// these wrenches of an equilibrium; none if there is one hub, which is the model's.
  virtual std::vector<CarriedHub> carried_hubs(const std::vector<HubVector>&) const { return {}; }
  /// Returns the scenario's subsystems that a subsystem consists of: one, unless loops between them
  /// tie several.
  virtual std::vector<SubsystemPart> members(std::size_t subsystem);
  virtual const std::vector<std::string>& body_names(std::size_t subsystem) const = 0;
  virtual const std::vector<SubsystemCoordinate>& coordinates(std::size_t subsystem) const = 0;
  /// Returns the solids of a subsystem, undeformed.
  virtual std::vector<SolidDeformation> solids(std::size_t subsystem) const = 0;
  /// Returns the direction of a subsystem about the hub's axis [rad].
  virtual double azimuth(std::size_t subsystem) const = 0;
  /// Returns the azimuths of all subsystems [rad].
  std::vector<double> azimuths() const {
    std::vector<double> all(subsystems());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = azimuth(i);
    return all;
  }
  /// Returns the axes of the undeformed carrier of a body that is fixed to the hub, in the hub
  /// frame: for a blade x along it, z along the axis of rotation.
  virtual Eigen::Matrix3d root_axes(std::size_t subsystem, int body) const = 0;
  virtual bool is_spatial() const = 0;
  /// Returns the number of components of a twist.
  virtual int twist_size() const = 0;
  /// Returns the index of the first rotational component.
  int first_rotation() const { return is_spatial() ? 3 : 2; }
  /// Returns the components that are unknowns of the model: all of a free hub, the rotation of a
  /// driven one.
  virtual const std::vector<int>& free_components() const = 0;
  virtual bool is_hub_free() const = 0;
  /// Whether the drive's torque follows from the balance alone, so that it holds the speed.
  virtual bool has_torque_drive() const = 0;
  /// Returns the speed of the hub, of several on a support that of the first.
  double speed() const { return speed_; }
  /// Returns the speed of the hub that carries a subsystem; of a support that of the first one.
  virtual double speed_of(std::size_t) const { return speed_; }
  /// Whether any hub turns.
  virtual bool turns() const { return speed_ != 0.0; }

  /// Sets the share of loads, gravity and the speed's square, from 0 to 1.
  virtual void set_share(double share) = 0;

  // States of actors on a subsystem that follow its motion with a delay, as inflow and separation.
  /// Holds them at those of the state that was evaluated last, or lets them follow every state at
  /// once again.
  virtual void hold_states(std::size_t subsystem, bool holds) = 0;
  /// Holds them at states that advance_states() returned.
  virtual void hold_states_at(std::size_t subsystem, std::span<const double> states) = 0;
  /// Holds them as they are a time `elapsed` [s] behind where they are held, at the state that was
  /// evaluated last; inputs are linear meanwhile. Held nowhere: in equilibrium. Returns them;
  /// empty: there are none.
  virtual std::vector<double> advance_states(std::size_t subsystem, double elapsed) = 0;
  /// Returns those of the states that are states of linear models, too, where held ones are
  /// springs.
  virtual std::vector<ForceState> force_states(std::size_t subsystem) const = 0;

  /// Adds a motion about the axis to the hub's steady rotation, besides which the offsets of all
  /// that follows are: its turn, its speed, and its acceleration.
  virtual void move_hub(double turn, double rate, double acceleration) = 0;

  /// Returns the coordinates at the start of the search: undeformed, joints where the scenario has
  /// them.
  virtual Eigen::VectorXd initial(std::size_t subsystem) const = 0;
  /// Takes coordinates as the state about which spherical joints turn, and sets their rotation
  /// vectors to zero.
  virtual void settle(std::size_t subsystem, Eigen::VectorXd& q) = 0;
  /// Turns spherical joints to where another model of the same bodies has settled, whose absolute()
  /// returned these coordinates.
  virtual void settle_at(std::size_t subsystem, const Eigen::VectorXd& absolute) = 0;

  virtual void evaluate(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                        SubsystemResponse& response) = 0;
  // At the state that was evaluated last.
  /// Returns the derivatives of the elastic forces by the deformations, without joints: constant
  /// but for strains of second order.
  virtual const Eigen::MatrixXd& stiffness(std::size_t subsystem) = 0;
  /// Returns the accelerations that the step graph finds. They also yield the forces of bodies on
  /// their carriers, see root_loads().
  virtual Eigen::VectorXd accelerations(std::size_t subsystem) = 0;
  virtual SubsystemMatrices matrices(std::size_t subsystem) = 0;
  /// Returns the twist of a body's frame, in it: columns for the twist of the hub, then for the
  /// velocities of the coordinates.
  virtual Eigen::MatrixXd twists(std::size_t subsystem, int body) = 0;
  /// Returns the product of the mass matrix of matrices() with velocities `v` of the coordinates,
  /// the hub's being zero. Leaves the model with these velocities.
  virtual Eigen::VectorXd momenta(std::size_t subsystem, const Eigen::VectorXd& v) = 0;

  /// Returns the rows of the subsystem's loops.
  virtual const std::vector<ClosureRow>& closure_rows(std::size_t subsystem) const = 0;
  /// Returns the name of a loop of the subsystem with springs against which the hub turns, as
  /// bearings on the mount; empty: there is none, and nothing depends on the hub's azimuth.
  virtual const std::string& standing_springs(std::size_t subsystem) const = 0;
  /// Returns a loop with its name: `loop "foot"`, or `coupling "gear"`.
  virtual std::string loop_words(std::size_t subsystem, std::size_t loop) const = 0;
  // At the state that was evaluated last.
  /// Returns the rates of openings by velocities, row by row: columns for the hub's twist, then for
  /// the coordinates. Transposed it takes the forces of rows to those on hub and coordinates.
  virtual Eigen::MatrixXd closures(std::size_t subsystem) = 0;
  /// Returns what loops exert on their places, by these forces of their rows.
  virtual std::vector<LoopLoad> loop_loads(std::size_t subsystem,
                                           const Eigen::VectorXd& multipliers) const = 0;

  /// Returns the forces of the hub's own inertia, of drive and loads at an offset whose
  /// acceleration is zero.
  virtual HubVector hub_force(const HubOffset& hub) const = 0;
  /// Returns the mass matrix of the hub alone.
  virtual Eigen::MatrixXd hub_mass() const = 0;

  // At the state that was evaluated last.
  virtual std::vector<NodePlace> places(std::size_t subsystem) = 0;
  virtual TipMotion tip(std::size_t subsystem) = 0;
  /// Returns what air does to a subsystem; none: nothing.
  virtual std::optional<SubsystemAir> air(std::size_t subsystem) const = 0;
  /// Precondition: accelerations() was called at this state.
  virtual std::vector<RootLoad> root_loads(std::size_t subsystem) const = 0;
  /// Returns for each body its largest deflection across its axis by its length; 0 for rigid ones.
  virtual std::vector<double> bending(std::size_t subsystem) const = 0;
  /// Returns q with the rotation vectors of spherical joints taken from parent to child.
  virtual Eigen::VectorXd absolute(std::size_t subsystem, const Eigen::VectorXd& q) const = 0;

  // Outputs; only if SteadyOptions::has_outputs.
  /// Returns names and units of the values of measure(): displacement of the tip, and the
  /// scenario's sensors on the subsystem whose frames turn with the hub.
  virtual const std::vector<LinearSignal>& outputs(std::size_t subsystem) const = 0;
  /// Returns the matrix that takes outputs to axes that are turned by `angle` about the hub's:
  /// vectors along the hub's axes change, those along a blade's or a section's stay.
  virtual Eigen::MatrixXd turn_outputs(std::size_t subsystem, double angle) const = 0;
  /// Returns the names of the columns of the scenario's sensors that are not such outputs.
  virtual const std::vector<std::string>& other_sensors() const = 0;
  /// Returns the outputs at the state that was evaluated last. Precondition: accelerations() was
  /// called there.
  virtual Eigen::VectorXd measure(std::size_t subsystem) = 0;

  HubOffset no_offset() const {
    const HubVector none = HubVector::Zero(twist_size());
    return {none, none, none};
  }

 protected:
  double speed_ = 0.0;
};

inline std::vector<SubsystemPart> SteadyModel::members(std::size_t subsystem) {
  SubsystemPart part{this, subsystem, subsystem};
  part.count = std::ssize(coordinates(subsystem));
  for (Eigen::Index r = 0; r < std::ssize(closure_rows(subsystem)); ++r) part.rows.push_back(r);
  return {part};
}

/// Holds the delayed states of actors on a subsystem, as SteadyModel::hold_states(), at those of a
/// state while it lives: motions that are fast beside the inflow leave it as it is.
class HeldStates {
 public:
  HeldStates(std::size_t subsystem, const SubsystemState& state, SteadyModel& model)
      : subsystem_(subsystem), model_(model) {
    SubsystemResponse response;
    model.evaluate(subsystem, state, model.no_offset(), response);
    model.hold_states(subsystem, true);
  }
  ~HeldStates() { model_.hold_states(subsystem_, false); }
  HeldStates(const HeldStates&) = delete;
  HeldStates& operator=(const HeldStates&) = delete;

 private:
  std::size_t subsystem_;
  SteadyModel& model_;
};

/// Makes the model of a scenario in steady rotation. Loads, motors and prescribed joints have the
/// values of their curves at options.instant, pitch by azimuth its mean. Where the hub turns,
/// gravity and loads of constant direction count with their part along the axis. Where the hub is
/// free, gravity does not count, since all parts fall alike. A rotor on a support is a
/// SupportedModel. Throws InputError like Simulation.
std::unique_ptr<SteadyModel> make_steady_model(const Scenario& scenario,
                                               const SteadyOptions& options);

/// Makes the model of a rotor of a scenario in space alone, without what carries it: its axle
/// stands as on the undeformed support, and `options.speed` is its speed.
std::unique_ptr<SteadyModel> make_rotor_model(const Scenario& scenario, int rotor,
                                              const SteadyOptions& options);

}  // namespace spoke::steady
