// Names, frames and components of the quantities that sensors measure.

#include "models/sensor.h"

#include <algorithm>
#include <array>

namespace spoke {
namespace {

using Components = std::array<SensorComponent, 3>;

constexpr Components kDisplacement{{{"x", "m"}, {"y", "m"}, {"rotation", "rad"}}};
constexpr Components kVelocity{{{"x", "m/s"}, {"y", "m/s"}, {"rotation", "rad/s"}}};
constexpr Components kAcceleration{{{"x", "m/s^2"}, {"y", "m/s^2"}, {"rotation", "rad/s^2"}}};
constexpr Components kWrench{{{"x", "N"}, {"y", "N"}, {"moment", "N m"}}};
constexpr Components kMomentum{{{"x", "kg m/s"}, {"y", "kg m/s"}, {"angular", "kg m^2/s"}}};
constexpr std::array<SensorComponent, 1> kEnergy{{{"", "J"}}};
constexpr std::array<SensorComponent, 1> kStress{{{"", "Pa"}}};

// Components in space.
using Six = std::array<SensorComponent, 6>;

constexpr Six kDisplacement6{{{"x", "m"},
                              {"y", "m"},
                              {"z", "m"},
                              {"rotation.x", "rad"},
                              {"rotation.y", "rad"},
                              {"rotation.z", "rad"}}};
constexpr Six kVelocity6{{{"x", "m/s"},
                          {"y", "m/s"},
                          {"z", "m/s"},
                          {"rotation.x", "rad/s"},
                          {"rotation.y", "rad/s"},
                          {"rotation.z", "rad/s"}}};
constexpr Six kAcceleration6{{{"x", "m/s^2"},
                              {"y", "m/s^2"},
                              {"z", "m/s^2"},
                              {"rotation.x", "rad/s^2"},
                              {"rotation.y", "rad/s^2"},
                              {"rotation.z", "rad/s^2"}}};
constexpr Six kWrench6{{{"force.x", "N"},
                        {"force.y", "N"},
                        {"force.z", "N"},
                        {"moment.x", "N m"},
                        {"moment.y", "N m"},
                        {"moment.z", "N m"}}};
constexpr Six kMomentum6{{{"x", "kg m/s"},
                          {"y", "kg m/s"},
                          {"z", "kg m/s"},
                          {"angular.x", "kg m^2/s"},
                          {"angular.y", "kg m^2/s"},
                          {"angular.z", "kg m^2/s"}}};

constexpr std::array<SensorComponent, 4> kAirFlow{{{"angle_of_attack", "rad"},
                                                   {"relative_speed", "m/s"},
                                                   {"axial_induction", ""},
                                                   {"tangential_induction", ""}}};
constexpr Six kAirLoad{{{"lift", ""},
                        {"drag", ""},
                        {"moment", ""},
                        {"axial_force", "N/m"},
                        {"tangential_force", "N/m"},
                        {"pitching_moment", "N"}}};

using Frame = SensorFrame;
constexpr std::array kMotionFrames{Frame::hub, Frame::blade, Frame::inertial};
constexpr std::array kSectionFrames{Frame::section, Frame::blade, Frame::hub, Frame::inertial};
constexpr std::array kJointFrames{Frame::blade, Frame::hub, Frame::inertial};
constexpr std::array kLoopFrames{Frame::loop, Frame::blade, Frame::hub, Frame::inertial};
constexpr std::array kHubFrames{Frame::inertial, Frame::hub};
constexpr std::array kInertial{Frame::inertial};

}  // namespace

std::span<const SensorFrame> frames_of(SensorQuantity quantity) {
  switch (quantity) {
    case SensorQuantity::section_force:
      return kSectionFrames;
    case SensorQuantity::joint_reaction:
    case SensorQuantity::interface_force:
      return kJointFrames;
    case SensorQuantity::loop_reaction:
    case SensorQuantity::loop_opening:
      return kLoopFrames;
    case SensorQuantity::hub_reaction:
      return kHubFrames;
    case SensorQuantity::momentum:
    case SensorQuantity::blade_momentum:
    case SensorQuantity::kinetic_energy:
    case SensorQuantity::von_mises:
    case SensorQuantity::air_flow:
    case SensorQuantity::air_load:
      return kInertial;
    default:
      return kMotionFrames;
  }
}

SensorFrame frame_of(const Sensor& sensor) {
  return sensor.frame.value_or(frames_of(sensor.quantity).front());
}

bool is_of_blade(SensorQuantity quantity) {
  return quantity != SensorQuantity::hub_reaction && quantity != SensorQuantity::momentum;
}

bool is_motion(SensorQuantity quantity) {
  return quantity == SensorQuantity::displacement || quantity == SensorQuantity::velocity ||
         quantity == SensorQuantity::acceleration;
}

bool is_of_loop(SensorQuantity quantity) {
  return quantity == SensorQuantity::loop_reaction || quantity == SensorQuantity::loop_opening;
}

bool is_of_solid(SensorQuantity quantity) {
  return quantity == SensorQuantity::interface_force || quantity == SensorQuantity::von_mises;
}

bool is_of_air(SensorQuantity quantity) {
  return quantity == SensorQuantity::air_flow || quantity == SensorQuantity::air_load;
}

bool has_position(SensorQuantity quantity) {
  return is_motion(quantity) || quantity == SensorQuantity::section_force || is_of_air(quantity);
}

std::span<const SensorComponent> components_of(SensorQuantity quantity) {
  switch (quantity) {
    case SensorQuantity::velocity:
      return kVelocity;
    case SensorQuantity::acceleration:
      return kAcceleration;
    case SensorQuantity::section_force:
    case SensorQuantity::joint_reaction:
    case SensorQuantity::hub_reaction:
    case SensorQuantity::loop_reaction:
    case SensorQuantity::interface_force:
      return kWrench;
    case SensorQuantity::momentum:
    case SensorQuantity::blade_momentum:
      return kMomentum;
    case SensorQuantity::kinetic_energy:
      return kEnergy;
    case SensorQuantity::von_mises:
      return kStress;
    default:
      return kDisplacement;
  }
}

std::span<const SensorComponent> components_in_space(SensorQuantity quantity) {
  switch (quantity) {
    case SensorQuantity::velocity:
      return kVelocity6;
    case SensorQuantity::acceleration:
      return kAcceleration6;
    case SensorQuantity::section_force:
    case SensorQuantity::joint_reaction:
    case SensorQuantity::hub_reaction:
    case SensorQuantity::loop_reaction:
    case SensorQuantity::interface_force:
      return kWrench6;
    case SensorQuantity::momentum:
    case SensorQuantity::blade_momentum:
      return kMomentum6;
    case SensorQuantity::kinetic_energy:
      return kEnergy;
    case SensorQuantity::von_mises:
      return kStress;
    case SensorQuantity::air_flow:
      return kAirFlow;
    case SensorQuantity::air_load:
      return kAirLoad;
    default:
      return kDisplacement6;
  }
}

std::string prefix_of(const Sensor& sensor, int blade) {
  const std::string name(sensor.name.empty() ? name_of(sensor.quantity) : sensor.name);
  if (!sensor.subsystem.empty() && is_of_blade(sensor.quantity)) {
    std::string prefix = sensor.subsystem;
    prefix.erase(std::remove(prefix.begin(), prefix.end(), ' '), prefix.end());
    return prefix + "." + name;
  }
  return is_of_blade(sensor.quantity) ? "blade" + std::to_string(blade + 1) + "." + name : name;
}

std::string_view name_of(SensorQuantity quantity) {
  constexpr std::array<std::string_view, 15> names{
      "displacement", "velocity",        "acceleration",   "section_force",  "joint_reaction",
      "hub_reaction", "momentum",        "blade_momentum", "kinetic_energy", "loop_reaction",
      "loop_opening", "interface_force", "von_mises",      "air_flow",       "air_load"};
  return names[static_cast<std::size_t>(quantity)];
}

std::string_view name_of(SensorFrame frame) {
  constexpr std::array<std::string_view, 5> names{"hub", "blade", "inertial", "section", "loop"};
  return names[static_cast<std::size_t>(frame)];
}

}  // namespace spoke
