// Names, frames and components of the quantities that sensors measure, by their rows.

#include "models/sensor_quantities.h"

namespace spoke {

std::span<const SensorFrame> frames_of(SensorQuantity quantity) { return row_of(quantity).frames; }

SensorFrame frame_of(const Sensor& sensor) {
  return sensor.frame.value_or(frames_of(sensor.quantity).front());
}

bool is_of_blade(SensorQuantity quantity) { return row_of(quantity).at != MeasuredAt::system; }
bool is_motion(SensorQuantity quantity) {
  return row_of(quantity).at == MeasuredAt::place && quantity != SensorQuantity::wind;
}
bool is_of_loop(SensorQuantity quantity) { return row_of(quantity).at == MeasuredAt::loop; }
bool is_of_solid(SensorQuantity quantity) {
  const MeasuredAt at = row_of(quantity).at;
  return at == MeasuredAt::interface || at == MeasuredAt::solid;
}
bool is_of_air(SensorQuantity quantity) { return row_of(quantity).at == MeasuredAt::air; }
bool has_position(SensorQuantity quantity) {
  const MeasuredAt at = row_of(quantity).at;
  return at == MeasuredAt::place || at == MeasuredAt::section || at == MeasuredAt::air;
}

std::span<const SensorComponent> components_of(SensorQuantity quantity) {
  return row_of(quantity).plane;
}

std::span<const SensorComponent> components_in_space(SensorQuantity quantity) {
  return row_of(quantity).space;
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

std::string_view name_of(SensorQuantity quantity) { return row_of(quantity).name; }

std::string_view name_of(SensorFrame frame) {
  constexpr std::array<std::string_view, 5> names{"hub", "blade", "inertial", "section", "loop"};
  return names[static_cast<std::size_t>(frame)];
}

}  // namespace spoke
