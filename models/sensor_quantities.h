#pragma once

// What is measured: a row for each quantity. A quantity that is added here, and in SensorQuantity,
// is known to readers, messages, documents and files; engine/bodies/ measures it.

#include <algorithm>
#include <array>

#include "models/sensor.h"

namespace spoke {

/// What a quantity is measured at, and so which keys belong to it.
enum class MeasuredAt {
  place,      ///< a place on a body that moves
  section,    ///< a section of a beam
  air,        ///< a section in air
  joint,      ///< a joint
  loop,       ///< a closed loop
  coupling,   ///< a coupling of joints
  interface,  ///< an interface of a solid
  solid,      ///< a solid, or places of it
  tree,       ///< a blade or subsystem
  system      ///< the whole
};

/// All that is known of a quantity.
struct QuantityRow {
  SensorQuantity quantity;
  std::string_view name;  ///< in files
  MeasuredAt at;
  std::span<const SensorFrame> frames;     ///< the usual one first
  std::span<const SensorComponent> plane;  ///< its values there; none: known in space alone
  std::span<const SensorComponent> space;
};

namespace quantities {

using Components = std::array<SensorComponent, 3>;

inline constexpr Components kDisplacement{{{"x", "m"}, {"y", "m"}, {"rotation", "rad"}}};
inline constexpr Components kVelocity{{{"x", "m/s"}, {"y", "m/s"}, {"rotation", "rad/s"}}};
inline constexpr Components kAcceleration{
    {{"x", "m/s^2"}, {"y", "m/s^2"}, {"rotation", "rad/s^2"}}};
inline constexpr Components kWrench{{{"x", "N"}, {"y", "N"}, {"moment", "N m"}}};
inline constexpr Components kMomentum{{{"x", "kg m/s"}, {"y", "kg m/s"}, {"angular", "kg m^2/s"}}};
inline constexpr std::array<SensorComponent, 1> kEnergy{{{"", "J"}}};
inline constexpr std::array<SensorComponent, 1> kCouplingForce{{{"", ""}}};
inline constexpr std::array<SensorComponent, 1> kStress{{{"", "Pa"}}};

// Components in space.
using Six = std::array<SensorComponent, 6>;

inline constexpr Six kDisplacement6{{{"x", "m"},
                                     {"y", "m"},
                                     {"z", "m"},
                                     {"rotation.x", "rad"},
                                     {"rotation.y", "rad"},
                                     {"rotation.z", "rad"}}};
inline constexpr Six kVelocity6{{{"x", "m/s"},
                                 {"y", "m/s"},
                                 {"z", "m/s"},
                                 {"rotation.x", "rad/s"},
                                 {"rotation.y", "rad/s"},
                                 {"rotation.z", "rad/s"}}};
inline constexpr Six kAcceleration6{{{"x", "m/s^2"},
                                     {"y", "m/s^2"},
                                     {"z", "m/s^2"},
                                     {"rotation.x", "rad/s^2"},
                                     {"rotation.y", "rad/s^2"},
                                     {"rotation.z", "rad/s^2"}}};
inline constexpr Six kWrench6{{{"force.x", "N"},
                               {"force.y", "N"},
                               {"force.z", "N"},
                               {"moment.x", "N m"},
                               {"moment.y", "N m"},
                               {"moment.z", "N m"}}};
inline constexpr Six kMomentum6{{{"x", "kg m/s"},
                                 {"y", "kg m/s"},
                                 {"z", "kg m/s"},
                                 {"angular.x", "kg m^2/s"},
                                 {"angular.y", "kg m^2/s"},
                                 {"angular.z", "kg m^2/s"}}};

inline constexpr Components kWind{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"}}};
inline constexpr std::array<SensorComponent, 4> kAirFlow{{{"angle_of_attack", "rad"},
                                                          {"relative_speed", "m/s"},
                                                          {"axial_induction", ""},
                                                          {"tangential_induction", ""}}};
inline constexpr Six kAirLoad{{{"lift", ""},
                               {"drag", ""},
                               {"moment", ""},
                               {"axial_force", "N/m"},
                               {"tangential_force", "N/m"},
                               {"pitching_moment", "N"}}};

using Frame = SensorFrame;
inline constexpr std::array kMotionFrames{Frame::hub, Frame::blade, Frame::inertial};
inline constexpr std::array kSectionFrames{Frame::section, Frame::blade, Frame::hub,
                                           Frame::inertial};
inline constexpr std::array kJointFrames{Frame::blade, Frame::hub, Frame::inertial};
inline constexpr std::array kLoopFrames{Frame::loop, Frame::blade, Frame::hub, Frame::inertial};
inline constexpr std::array kHubFrames{Frame::inertial, Frame::hub};
inline constexpr std::array kInertial{Frame::inertial};

using Quantity = SensorQuantity;
inline constexpr std::array kRows{
    QuantityRow{Quantity::displacement, "displacement", MeasuredAt::place, kMotionFrames,
                kDisplacement, kDisplacement6},
    QuantityRow{Quantity::velocity, "velocity", MeasuredAt::place, kMotionFrames, kVelocity,
                kVelocity6},
    QuantityRow{Quantity::acceleration, "acceleration", MeasuredAt::place, kMotionFrames,
                kAcceleration, kAcceleration6},
    QuantityRow{Quantity::section_force, "section_force", MeasuredAt::section, kSectionFrames,
                kWrench, kWrench6},
    QuantityRow{Quantity::joint_reaction, "joint_reaction", MeasuredAt::joint, kJointFrames,
                kWrench, kWrench6},
    QuantityRow{Quantity::hub_reaction, "hub_reaction", MeasuredAt::system, kHubFrames, kWrench,
                kWrench6},
    QuantityRow{Quantity::momentum, "momentum", MeasuredAt::system, kInertial, kMomentum,
                kMomentum6},
    QuantityRow{Quantity::blade_momentum, "blade_momentum", MeasuredAt::tree, kInertial, kMomentum,
                kMomentum6},
    QuantityRow{Quantity::kinetic_energy, "kinetic_energy", MeasuredAt::tree, kInertial, kEnergy,
                kEnergy},
    QuantityRow{Quantity::loop_reaction, "loop_reaction", MeasuredAt::loop, kLoopFrames, kWrench,
                kWrench6},
    QuantityRow{Quantity::loop_opening, "loop_opening", MeasuredAt::loop, kLoopFrames,
                kDisplacement, kDisplacement6},
    QuantityRow{Quantity::interface_force,
                "interface_force",
                MeasuredAt::interface,
                kJointFrames,
                {},
                kWrench6},
    QuantityRow{Quantity::von_mises, "von_mises", MeasuredAt::solid, kInertial, {}, kStress},
    QuantityRow{Quantity::air_flow, "air_flow", MeasuredAt::air, kInertial, {}, kAirFlow},
    QuantityRow{Quantity::air_load, "air_load", MeasuredAt::air, kInertial, {}, kAirLoad},
    QuantityRow{Quantity::strain_energy, "strain_energy", MeasuredAt::tree, kInertial, kEnergy,
                kEnergy},
    QuantityRow{Quantity::coupling_force,
                "coupling_force",
                MeasuredAt::coupling,
                kInertial,
                {},
                kCouplingForce},
    QuantityRow{Quantity::wind, "wind", MeasuredAt::place, kInertial, {}, kWind}};

static_assert(std::is_sorted(kRows.begin(), kRows.end(),
                             [](const QuantityRow& a, const QuantityRow& b) {
                               return a.quantity < b.quantity;
                             }),
              "in the order of SensorQuantity");

/// Whether a quantity is known in a world.
constexpr bool is_known(const QuantityRow& row, bool in_plane) {
  return !in_plane || !row.plane.empty();
}

/// The names of all quantities of a world, with a space between any two.
template <bool in_plane>
inline constexpr auto kJoinedNames = [] {
  constexpr std::size_t size = [] {
    std::size_t sum = 0;
    for (const QuantityRow& row : kRows)
      if (is_known(row, in_plane)) sum += row.name.size() + 1;
    return sum - 1;
  }();
  std::array<char, size> text{};
  std::size_t end = 0;
  for (const QuantityRow& row : kRows) {
    if (!is_known(row, in_plane)) continue;
    if (end > 0) text[end++] = ' ';
    for (const char letter : row.name) text[end++] = letter;
  }
  return text;
}();

}  // namespace quantities

/// Returns the row of a quantity.
constexpr const QuantityRow& row_of(SensorQuantity quantity) {
  return quantities::kRows[static_cast<std::size_t>(quantity)];
}

/// The names of all quantities of a world, as the words of a key.
template <bool in_plane>
inline constexpr std::string_view kQuantityNames{quantities::kJoinedNames<in_plane>.data(),
                                                 quantities::kJoinedNames<in_plane>.size()};

}  // namespace spoke
