#pragma once

// Sensors of a scenario besides those that every simulation has.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/blade_choice.h"
#include "spoke/export.h"

namespace spoke {

/// The quantity that a sensor measures (docs/scenario.md defines each).
enum class SensorQuantity {
  displacement,  ///< displacement of a section from its undeformed place [m, rad]
  velocity,      ///< velocity of a section [m/s, rad/s]
  acceleration,  ///< acceleration of a section [m/s^2, rad/s^2]
  /// Force and moment that the blade outboard of a section exerts on the blade inboard [N, N m].
  section_force,
  joint_reaction,  ///< force and moment that a joint exerts on the body outboard of it [N, N m]
  hub_reaction,    ///< force and moment that support and drive exert on the hub [N, N m]
  momentum,        ///< momentum of hub and blades, about the inertial origin [kg m/s, kg m^2/s]
  blade_momentum,  ///< momentum of a blade, about the inertial origin [kg m/s, kg m^2/s]
  kinetic_energy,  ///< kinetic energy of a blade [J]
  /// Force and moment that a loop's closure exerts on its place `from`, about it [N, N m].
  loop_reaction,
  /// How far a loop is open along the directions that it locks: displacement and small rotation of
  /// `from` from where the closure wants it [m, rad]. Rigid directions are closed to round-off.
  loop_opening,
  /// Force and moment that joints, loops and loads exert on a solid at an interface, about its
  /// point [N, N m].
  interface_force,
  von_mises,  ///< largest von Mises stress of a solid, or that at a place of it [Pa]
  /// Flow around a section in air: angle of attack [rad], relative speed [m/s], induction factors.
  air_flow,
  /// What air does there: coefficients of lift, drag and moment, and by length the forces along the
  /// rotor's axis and in the direction of its turn [N/m], and the pitching moment [N m/m].
  air_load,
  /// Energy of the deformation of a blade, of the springs of its joints and loops, and of gravity's
  /// tension [J].
  strain_energy,
  /// Force of a coupling of joints: times the ratio of a coordinate it is the effort on that.
  coupling_force,
  wind,  ///< velocity of the air at a place where no rotor disturbs it [m/s]
};

/// The frame in which a motion is observed, and in which vectors are resolved.
enum class SensorFrame {
  hub,       ///< turns with the hub
  blade,     ///< turns with the hub, x along the undeformed blade
  inertial,  ///< stands still
  section,   ///< turns with the cross section
  /// Of a loop: turns with its place `to`; of kind `distance`, x is the force of the rod, positive
  /// in tension, or its elongation, and all other values are 0.
  loop,
};

/// A joint of a blade by its number, from 1 at the root, as in files. Whole numbers do not convert:
/// an index, from 0, is no number.
class JointChoice {
 public:
  /// Returns joint `number`, inboard of body `number`.
  static constexpr JointChoice number(int number) { return JointChoice(number); }

  constexpr int number() const { return number_; }  ///< number from 1
  /// Returns the index of the body outboard of the joint, from 0.
  constexpr int body() const { return number_ - 1; }

 private:
  explicit constexpr JointChoice(int number) : number_(number) {}

  int number_;
};

/// One sensor, on one blade or on every blade; in space also on a body of a subsystem.
struct Sensor {
  SensorQuantity quantity = SensorQuantity::displacement;  ///< the quantity measured
  std::string name;  ///< name within the names of its columns; empty: that of the quantity
  BladeChoice blade = BladeChoice::all();
  std::optional<double> position;  ///< distance from the blade's root [m]; empty: the tip
  /// The joint whose reaction is measured; required for joint_reaction.
  std::optional<JointChoice> joint;
  /// Frame of observation and components; empty: the quantity's usual one, see frame_of().
  std::optional<SensorFrame> frame;
  /// Name of a subsystem in space that the sensor is on, in place of a blade.
  std::string subsystem{};
  /// The body of the subsystem, for quantities at a position or of a joint, which is the one that
  /// carries the body.
  std::string body{};
  /// Interface of a solid; required for interface_force. For motions, empty without `node`: the
  /// only one that does not carry its frame.
  std::string interface {};
  /// Node of a solid, by its number in the file of its mesh.
  std::optional<int> node = std::nullopt;
  /// Name of the loop, of the blade or the subsystem; required for loop_reaction and loop_opening.
  std::string loop{};
  /// Name of the coupling of the subsystem; required for coupling_force.
  std::string coupling{};
};

/// Returns the frame in force.
SPOKE_EXPORT SensorFrame frame_of(const Sensor& sensor);
/// Returns the frames in which a quantity may be resolved, the usual one first.
SPOKE_EXPORT std::span<const SensorFrame> frames_of(SensorQuantity quantity);
/// Returns whether the quantity belongs to a blade.
SPOKE_EXPORT bool is_of_blade(SensorQuantity quantity);
/// Returns whether the quantity is a displacement or a derivative of one.
SPOKE_EXPORT bool is_motion(SensorQuantity quantity);
/// Returns whether the quantity is one of a closed loop.
SPOKE_EXPORT bool is_of_loop(SensorQuantity quantity);
/// Returns whether the quantity is one of solids alone.
SPOKE_EXPORT bool is_of_solid(SensorQuantity quantity);
/// Returns whether the quantity is one of blades in air.
SPOKE_EXPORT bool is_of_air(SensorQuantity quantity);
/// Returns whether the quantity is measured at a position along a blade.
SPOKE_EXPORT bool has_position(SensorQuantity quantity);

/// A value of a sensor: the last word of its column's name, and its unit.
struct SensorComponent {
  std::string_view name;  ///< empty: the only value
  std::string_view unit;  ///< SI
};
/// Returns the values of a quantity in the plane, in the order of their columns.
SPOKE_EXPORT std::span<const SensorComponent> components_of(SensorQuantity quantity);
/// Returns the values of a quantity in space, in the order of their columns.
SPOKE_EXPORT std::span<const SensorComponent> components_in_space(SensorQuantity quantity);
/// Returns the prefix of a sensor's columns on blade `blade` (from 0; any number if the sensor is
/// on none): "blade1.mid".
SPOKE_EXPORT std::string prefix_of(const Sensor& sensor, int blade);

/// Returns the name that scenario files use: "displacement", "velocity", ...
SPOKE_EXPORT std::string_view name_of(SensorQuantity quantity);
/// Returns the name that scenario files use: "hub", "blade", "inertial", "section" or "loop".
SPOKE_EXPORT std::string_view name_of(SensorFrame frame);

}  // namespace spoke
