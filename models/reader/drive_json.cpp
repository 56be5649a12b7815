// The keys of each kind of drive.

#include "models/reader/drive_json.h"

namespace spoke {
namespace {

void add_drive(const SpinUp& drive, Json& json) {
  json.set("speed", drive.speed);
  json.set("ramp", drive.ramp);
}

void add_drive(const SpinUpHoldSpinDown& drive, Json& json) {
  json.set("speed", drive.speed);
  json.set("ramp", drive.ramp);
  json.set("hold", drive.hold);
  json.set("ramp_down", drive.ramp_down);
}

void add_drive(const SpeedTable& drive, Json& json) {
  json.set("time", drive.speed.times());
  json.set("speed", drive.speed.values());
}

void add_drive(const TorqueDrive& drive, Json& json) {
  if (drive.torque.times().size() == 1) {
    json.set("torque", drive.torque.values().front());
  } else {
    json.set("time", drive.torque.times());
    json.set("torque", drive.torque.values());
  }
  json.set("initial_speed", drive.initial_speed);
}

void add_drive(const TorqueBySpeed& drive, Json& json) {
  json.set("speed", drive.torque.times());
  json.set("torque", drive.torque.values());
  json.set("initial_speed", drive.initial_speed);
  json.set("ramp", drive.ramp);
}

void add_drive(const FreeDrive& drive, Json& json) {
  json.set("initial_speed", drive.initial_speed);
}
void add_drive(const ConstantSpeed& drive, Json& json) { json.set("speed", drive.speed); }
void add_drive(const FixedDrive&, Json&) {}

}  // namespace

Json drive_to_json(const Drive& drive) {
  Json json = {{"kind", name_of(drive)}};
  std::visit([&](const auto& d) { add_drive(d, json); }, drive);
  return json;
}

}  // namespace spoke
