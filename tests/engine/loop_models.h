#pragma once

// Models with closed loops whose forces and motions are known.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::test {

/// Returns a place on a rigid body of that name.
inline LoopPlace place_on(const std::string& body, const spatial::Vector& point) {
  LoopPlace place;
  place.name = body;
  place.point = point;
  return place;
}
/// Returns a place that no body carries; `name`: of an anchor.
inline LoopPlace place_on(LoopPlace::Carrier carrier, const spatial::Vector& point,
                          const std::string& name = "") {
  LoopPlace place = place_on(name, point);
  place.carrier = carrier;
  return place;
}

inline Sensor loop_sensor(SensorQuantity quantity, const std::string& name,
                          const std::string& subsystem, const std::string& loop,
                          SensorFrame frame = SensorFrame::loop) {
  Sensor sensor;
  sensor.quantity = quantity;
  sensor.name = name;
  sensor.subsystem = subsystem;
  sensor.loop = loop;
  sensor.frame = frame;
  return sensor;
}

/// Makes a slider of 2 kg on a rail along the x axis of a hub that turns at 3 rad/s. Its centre is
/// at 0.5 m, where a rod from the hub's axis holds it.
inline Scenario make_slider() {
  Scenario scenario = parse_scenario(R"(
world = "space"
[hub]
drive = { kind = "constant", speed = 3.0 }
[integration]
duration = 1.0
step = 0.01
[[subsystem]]
name = "rail"
[[subsystem.body]]
name = "slider"
kind = "rigid"
mass = 2.0
inertia = [0.02, 0.03, 0.04]
[[subsystem.joint]]
parent = "hub"
child = "slider"
kind = "prismatic"
axis = [1.0, 0.0, 0.0]
offset = [0.5, 0.0, 0.0]
)",
                                     "slider.toml");
  Loop rod;
  rod.name = "rod";
  rod.kind = LoopKind::distance;
  rod.from = place_on("slider", spatial::Vector::Zero());
  rod.to = place_on(LoopPlace::Carrier::hub, spatial::Vector::Zero());
  scenario.space->subsystems[0].loops.push_back(rod);
  return scenario;
}

/// Makes a blade of 2 kg that is rigid and pitches about the x axis, its centre of mass at y = 0.05
/// m; `hub`: keys of the hub. A pitch link of 0.3 m, upright, leads from its horn at y = 0.1 m to
/// an anchor "plate", which the program moves. There are `count` of them, side by side.
inline Scenario make_pitching(const std::string& hub, int count = 1) {
  const std::string head = "world = \"space\"\n[hub]\n" + hub + R"(
[gravity]
acceleration = [0.0, 0.0, -9.81]
[integration]
duration = 1.0
step = 0.005
)";
  std::string text = head;
  for (int i = 0; i < count; ++i)
    text += "[[subsystem]]\nname = \"blade" + std::string(1, static_cast<char>('A' + i)) + R"("
[[subsystem.body]]
name = "horn"
kind = "rigid"
mass = 2.0
center = [0.4, 0.05, 0.0]
inertia = [0.02, 0.3, 0.3]
[[subsystem.joint]]
name = "pitch"
parent = "hub"
child = "horn"
kind = "revolute"
axis = [1.0, 0.0, 0.0]
offset = [0.1, 0.0, )" +
            std::to_string(0.2 * i) + "]\n";
  Scenario scenario = parse_scenario(text, "pitching.toml");
  Anchor plate;
  plate.name = "plate";
  plate.turns_with_hub = true;
  plate.motion = ProgramAnchorMotion{};
  scenario.space->anchors.push_back(plate);
  for (int i = 0; i < count; ++i) {
    Loop link;
    link.name = "link";
    link.kind = LoopKind::distance;
    link.from = place_on("horn", {0.1, 0.1, 0.0});
    link.to = place_on(LoopPlace::Carrier::anchor, {0.2, 0.1, 0.2 * i - 0.3}, "plate");
    scenario.space->subsystems[static_cast<std::size_t>(i)].loops.push_back(link);
  }
  return scenario;
}

}  // namespace spoke::test
