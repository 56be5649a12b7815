#pragma once

// What an embedding program sets between steps, beyond Simulation's own functions: factors of the
// scenario's loads, the wind at the hub, and all that is in force as a value, to go back with to a
// saved state.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/saved_state.h"
#include "engine/simulation.h"
#include "models/drive.h"
#include "models/wind_course.h"
#include "spoke/export.h"

namespace spoke {

/// The drive of a rotor on a support besides the first.
struct RotorDrive {
  std::string rotor;  ///< its name
  Drive drive{};
};

/// A factor of all loads of one name in a scenario.
struct LoadFactor {
  std::string load;     ///< name of the loads
  double factor = 1.0;  ///< multiplies what the scenario says, its own factor and ramp included
};

/// The motion of a joint's coordinate that the scenario leaves to the program: from a time on it is
/// value + velocity s + acceleration s^2/2, with s the time since, as
/// Simulation::set_joint_motion() sets it; or a curve, as Simulation::set_joint_course() does.
struct JointCourse {
  int tree = 0;             ///< blade or subsystem, from 0, as of Simulation::joint_index()
  int joint = 0;            ///< as Simulation::joint_index() returns it
  int coordinate = 0;       ///< from 0
  double begin = 0.0;       ///< time from which it holds [s]
  CoordinateMotion motion;  ///< at that time
  /// Over time [s], in place of `begin` and `motion`.
  std::optional<Curve> curve{};
};

/// A torque, or a force, that the program adds to those on a free coordinate of a joint.
struct JointTorque {
  int tree = 0;         ///< blade or subsystem, from 0, as of Simulation::joint_index()
  int joint = 0;        ///< as Simulation::joint_index() returns it
  int coordinate = 0;   ///< from 0
  double torque = 0.0;  ///< on the child, and against the parent [N m, N]
};

/// The motion of an anchor that the scenario leaves to the program, likewise: of translation and
/// rotation vector, as Simulation::set_anchor_motion() or Simulation::set_anchor_course() sets it.
struct AnchorCourse {
  std::string anchor;   ///< its name
  double begin = 0.0;   ///< time from which `motion` holds [s]
  AnchorMotion motion;  ///< at that time
  /// Over time [s], in place of `begin` and `motion`.
  std::optional<spatial::MountMotion> curves{};
};

/// What is in force beside a state, and a program can set: a saved state has nothing of it. (Loads
/// of the program's own, which Simulation::set_load() replaces, are not among it.)
struct Courses {
  Drive drive{};                        ///< of the hub, of several rotors of the first
  std::vector<JointCourse> joints{};    ///< of coordinates that the scenario leaves to the program
  std::vector<LoadFactor> loads{};      ///< of loads with a name
  std::optional<WindCourse> wind{};     ///< at the hub; none: the scenario's wind blows
  std::vector<AnchorCourse> anchors{};  ///< of anchors that the scenario leaves to the program
  std::vector<JointTorque> torques{};   ///< that the program adds; of all others it is 0
  std::vector<RotorDrive> rotors{};     ///< drives of further rotors on a support
};

/// Multiplies the loads of a name, point loads, distributed ones, drags and loads on the hub, by a
/// factor from the next step on; 1 is what the scenario says, and leaves its bits. Like other
/// changes between steps it is the caller's to keep. Throws InputError, with the nearest name, if
/// no load has that name, or if the factor is not finite; else like Simulation::set_drive(). The
/// simulation then stays as it is.
SPOKE_EXPORT void set_load_factor(Simulation& simulation, std::string_view load, double factor);

/// Adds a torque, or the force of a joint that slides, to what acts on a free coordinate of a joint
/// in space, from the next step on and until it is set again: that of a motor whose controller the
/// program is. Its work is part of energy.work. Numbers count from 0, as of
/// Simulation::joint_index(). Like other changes between steps it is the caller's to keep. Throws
/// InputError if the model is in the plane, if there is no such coordinate, or if its motion is
/// prescribed, or if the torque is not finite; else like Simulation::set_drive().
/// The simulation then stays as it is.
SPOKE_EXPORT void set_joint_torque(Simulation& simulation, int tree, int joint, int coordinate,
                                   double torque);

/// Returns the names of a scenario's loads, each once, in the order in which they come.
SPOKE_EXPORT std::vector<std::string> load_names(const Scenario& scenario);

/// Lets the wind at the hub follow a course from the next step on, in place of the scenario's
/// speed, direction, gusts and turbulence; its shear stays: the velocity at another height has the
/// factor (height/height of the hub)^shear_exponent. The hub's place is that before anything moves.
/// Like other changes between steps it is the caller's to keep. A course that goes on from the
/// velocity in force takes no evaluation of the accelerations. Throws InputError if no air acts on
/// the model, if the wind has shear and the hub is not above the ground, or if a number is not
/// finite; else like Simulation::set_drive(). The simulation then stays as it is.
SPOKE_EXPORT void set_wind(Simulation& simulation, const WindCourse& course);

/// Returns the wind in force at time() where the hub was before anything moved, inertial frame
/// [m/s]. Throws InputError if no air acts on the model.
SPOKE_EXPORT Eigen::Vector3d wind_at_hub(const Simulation& simulation);

/// Returns the mean wind of a scenario there, without gusts and turbulence [m/s]; none if no air
/// acts on its model, or set_wind() would refuse it for its shear.
SPOKE_EXPORT std::optional<Eigen::Vector3d> find_mean_wind(const Scenario& scenario);

/// Returns all courses in force: the drives, each coordinate and each anchor that the scenario
/// leaves to the program, the factor of each load with a name, the wind, torques on joints. Taken
/// with Simulation::save(), they are what restore() goes back with.
SPOKE_EXPORT Courses courses(const Simulation& simulation);

/// Goes to a saved state as Simulation::restore() does, together with the courses that were in
/// force when it was saved: these need not go on from those in force now. Rotors, coordinates,
/// anchors and loads that `courses` does not name keep theirs, but for torques on joints, which
/// end. The following steps have the bits of the run that was saved. Throws InputError like
/// restore(), or if a rotor, joint, anchor or load is not there, or if a drive is of another kind
/// of motion than the one in force; the simulation then stays as it is.
SPOKE_EXPORT void restore(Simulation& simulation, const SavedState& state, const Courses& courses);

}  // namespace spoke
