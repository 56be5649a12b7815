// The keys of each kind of drive.

#include "models/reader/drive_json.h"

#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

// Curves come before the numbers.
template <class D>
void add_curves(const D&, Json&) {}
void add_curves(const SpeedTable& drive, Json& json) {
  json.set("time", drive.speed.times());
  json.set("speed", drive.speed.values());
}
void add_curves(const TorqueDrive& drive, Json& json) {
  if (drive.torque.times().size() == 1) {
    json.set("torque", drive.torque.values().front());
  } else {
    json.set("time", drive.torque.times());
    json.set("torque", drive.torque.values());
  }
}
void add_curves(const TorqueBySpeed& drive, Json& json) {
  json.set("speed", drive.torque.times());
  json.set("torque", drive.torque.values());
}

template <class D>
void add_drive(const D& drive, Json& json) {
  add_curves(drive, json);
  if constexpr (HasRows<D>) keys::write(rows_of(drive), &drive, json);
}

}  // namespace

Json drive_to_json(const Drive& drive) {
  Json json = {{"kind", name_of(drive)}};
  std::visit([&](const auto& own) { add_drive(own, json); }, drive);
  return json;
}

}  // namespace spoke
