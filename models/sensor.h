#pragma once

// What a scenario wants measured besides the sensors that every simulation has.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/blade_choice.h"
#include "spoke/export.h"

namespace spoke {

/// What a sensor measures (docs/scenario.md says how).
enum class SensorQuantity {
  displacement,    ///< of a section from its undeformed place [m, rad]
  velocity,        ///< of a section [m/s, rad/s]
  acceleration,    ///< of a section [m/s^2, rad/s^2]
  section_force,   ///< what the blade outboard of a section does to the blade inboard [N, N m]
  joint_reaction,  ///< what a joint does to the body outboard of it [N, N m]
  hub_reaction,    ///< what support and drive do to the hub [N, N m]
  momentum,        ///< of hub and blades, about the inertial origin [kg m/s, kg m^2/s]
  blade_momentum,  ///< of a blade, likewise
  kinetic_energy,  ///< of a blade [J]
};

/// The frame in which a motion is observed, and in which vectors are resolved.
enum class SensorFrame {
  hub,       ///< turns with the hub
  blade,     ///< the same, x along the undeformed blade
  inertial,  ///< stands still
  section,   ///< turns with the cross section
};

/// A joint of a blade by its number, from 1 at the root, as in files. Whole numbers do not convert:
/// an index, from 0, is no number.
class JointChoice {
 public:
  /// Joint `number`, inboard of body `number`.
  static constexpr JointChoice number(int number) { return JointChoice(number); }

  constexpr int number() const { return number_; }  ///< from 1
  /// Of the body outboard of it, from 0.
  constexpr int body() const { return number_ - 1; }

 private:
  explicit constexpr JointChoice(int number) : number_(number) {}

  int number_;
};

/// One sensor, on one blade or on every blade; in space also on a body of a subsystem.
struct Sensor {
  SensorQuantity quantity = SensorQuantity::displacement;  ///< what it measures
  std::string name;  ///< in the names of its columns; empty: the quantity's
  BladeChoice blade = BladeChoice::all();
  std::optional<double> position;    ///< from the blade's root [m]; empty: the tip
  std::optional<JointChoice> joint;  ///< of a joint's reaction, which needs one
  std::optional<SensorFrame> frame;  ///< empty: the quantity's usual one, see frame_of()
  std::string subsystem{};           ///< in space, in place of a blade: its name
  /// Of the subsystem, for what is at a position or a joint: the joint is the one that carries it.
  std::string body{};
};

/// The frame in force.
SPOKE_EXPORT SensorFrame frame_of(const Sensor& sensor);
/// Frames in which a quantity may be resolved, the usual one first.
SPOKE_EXPORT std::span<const SensorFrame> frames_of(SensorQuantity quantity);
/// Whether a sensor of this quantity is one of a blade.
SPOKE_EXPORT bool is_of_blade(SensorQuantity quantity);
/// Whether it is a displacement or a derivative of one.
SPOKE_EXPORT bool is_motion(SensorQuantity quantity);
/// Whether it is at a position along a blade.
SPOKE_EXPORT bool has_position(SensorQuantity quantity);

/// A value of a sensor: the last word of its column's name, and its unit.
struct SensorComponent {
  std::string_view name;  ///< empty: the only one
  std::string_view unit;  ///< SI
};
/// The values of a quantity in the plane, in the order of their columns.
SPOKE_EXPORT std::span<const SensorComponent> components_of(SensorQuantity quantity);
/// The same in space.
SPOKE_EXPORT std::span<const SensorComponent> components_in_space(SensorQuantity quantity);
/// What the names of a sensor's columns begin with on blade `blade` (from 0; of none, any number):
/// "blade1.mid".
SPOKE_EXPORT std::string prefix_of(const Sensor& sensor, int blade);

/// "displacement", "velocity", ...
SPOKE_EXPORT std::string_view name_of(SensorQuantity quantity);
/// "hub", "blade", "inertial", "section".
SPOKE_EXPORT std::string_view name_of(SensorFrame frame);

}  // namespace spoke
