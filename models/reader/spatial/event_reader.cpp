// Events: their conditions, and whether there is what they act on.

#include "models/reader/spatial/event_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "models/reader/keys/event_keys.h"
#include "models/reader/row_reader.h"

namespace spoke::spatial {
namespace {

constexpr const char* kConditionExpected = "a sensor, > or <, and a number, as \"hub.speed > 1.4\"";

std::vector<int> read_blades(const TomlSection& section) {
  std::vector<int> blades;
  if (!section.has("blades")) return blades;
  for (const double number : section.numbers("blades", Quantity::positive(""))) {
    if (number != std::floor(number) || number > kMostOfAKind)
      section.fail_expected("blades", "an array of numbers of blades, from 1");
    blades.push_back(static_cast<int>(number));
  }
  return blades;
}

EventTurn read_turn(const TomlSection& section) {
  EventTurn turn;
  keys::read(section, keys::kEventYawRows, &turn);
  return turn;
}

Event read_event(const TomlSection& section) {
  Event event;
  event.name = section.text("name", "");
  event.when = section.text("when", "");
  keys::read(section, keys::kEventRows, &event);
  if (section.has("generator")) {
    keys::read_word(section, keys::kEventRows, "generator");
    event.generator_off = true;
  }
  if (section.has("controller")) {
    keys::read_word(section, keys::kEventRows, "controller");
    event.controller_off = true;
  }
  if (section.has("pitch")) {
    const TomlSection pitch =
        section.section("pitch", keys::keys_of(keys::kEventYawRows, keys::kEventPitchRows));
    event.pitch = read_turn(pitch);
    event.pitch->blades = read_blades(pitch);
  }
  if (section.has("yaw"))
    event.yaw = read_turn(section.section("yaw", keys::keys_of(keys::kEventYawRows)));
  return event;
}

/// Returns the names of the joints that a controller pitches.
const std::vector<std::string>* find_pitched_joints(const Model& model) {
  if (model.pitch_control) return &model.pitch_control->joints;
  return model.outer_control ? &model.outer_control->joints : nullptr;
}

bool is_named(const Joint& joint, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), joint.name) != names.end();
}

/// Whether a controller pitches each of the blades and the subsystems on hubs.
std::vector<bool> find_pitched(const Model& model) {
  std::vector<bool> pitched;
  const std::vector<std::string>* names = find_pitched_joints(model);
  const auto add = [&](const auto& joints, int rotor) {
    pitched.push_back(names && (model.pitch_control || rotor == 0) &&
                      std::any_of(joints.begin(), joints.end(), [&](const auto& joint) {
                        return is_named(joint.joint, *names);
                      }));
  };
  for (const Blade& blade : model.blades) add(blade.joints, blade.rotor);
  for (const Subsystem& subsystem : model.subsystems)
    if (!is_support(model, subsystem)) add(subsystem.joints, subsystem.rotor);
  return pitched;
}

Fault find_turn_fault(const EventTurn& turn) {
  const FirstFault first;
  if (turn.to) first("to", *turn.to, kAngle);
  if (turn.rate) first("rate", *turn.rate, Quantity::positive("rad/s"));
  if (turn.to && !turn.rate)
    first.add({"rate", "is missing, expected the rate at which the angle goes to `to` (rad/s)"});
  if (turn.rate && !turn.to)
    first.add({"to", "is missing, expected the angle that is reached at the rate (rad)"});
  return first.found();
}

Fault find_pitch_fault(const EventTurn& turn, const Model& model) {
  const std::vector<bool> pitched = find_pitched(model);
  if (std::none_of(pitched.begin(), pitched.end(), [](bool is) { return is; }))
    return {"",
            "turns blades, but no controller does, expected [control.turbine] with their joint"};
  const std::vector<int>& blades = turn.blades;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const auto end = blades.begin() + static_cast<std::ptrdiff_t>(i);
    const std::string is = "is " + std::to_string(blades[i]);
    if (blades[i] < 1 || blades[i] > std::ssize(pitched))
      return {"blades", is + ", expected 1 to " + std::to_string(pitched.size())};
    if (std::find(blades.begin(), end, blades[i]) != end)
      return {"blades", is + " twice, expected each blade once"};
    if (!pitched[static_cast<std::size_t>(blades[i] - 1)])
      return {"blades", is + ", which no controller pitches, expected a blade with its joint"};
  }
  return find_turn_fault(turn);
}

/// Finds what is wrong with an action on the drive of the first rotor; `key`: generator or brake.
Fault find_drive_fault(const char* key, const Model& model) {
  if (model.hub.support == HubSupport::free && !model.support)
    return {key, "acts on the drive, but the hub is free, expected one on an axle"};
  if (prescribes_motion(model.hub.drive))
    return {key, "acts on the torque of the drive, but hub.drive.kind is \"" +
                     std::string(name_of(model.hub.drive)) +
                     "\", expected \"torque\", \"torque_by_speed\" or \"free\""};
  return {};
}

bool does_something(const Event& event) {
  return event.generator_off || event.brake > 0.0 || event.controller_off || event.pitch ||
         event.yaw;
}

Fault find_condition_fault(const Event& event) {
  if (event.at && !event.when.empty())
    return {"when", "given along with at, expected only one of them"};
  if (!event.at && event.when.empty()) return {"at", "is missing, expected a time (s), or when"};
  if (!event.when.empty() && !parse_condition(event.when))
    return {"when", "is \"" + event.when + "\", expected " + kConditionExpected};
  return {};
}

Fault find_event_fault(const Event& event, const Model& model) {
  const FirstFault first;
  keys::visit_numbers<void>(keys::kEventRows, event, first);
  if (event.at) first("at", *event.at, Quantity::not_negative("s"));
  first.add(find_condition_fault(event));
  if (!does_something(event))
    first.add({"", "does nothing, expected generator, brake, controller, pitch or yaw"});
  if (event.generator_off) first.add(find_drive_fault("generator", model));
  if (event.brake > 0.0) first.add(find_drive_fault("brake", model));
  const bool is_controlled =
      model.pitch_control || (model.outer_control && model.outer_control->has_controller);
  if (event.controller_off && !is_controlled)
    first.add({"controller", "is \"off\", but there is none, expected one in [control]"});
  if (event.pitch) first.add(find_pitch_fault(*event.pitch, model).within("pitch"));
  if (event.yaw) {
    if (!model.outer_control || model.outer_control->yaw_joint.empty())
      first.add({"yaw", "turns a yaw joint, but there is none, expected yaw_joint in [control]"});
    first.add(find_turn_fault(*event.yaw).within("yaw"));
  }
  return first.found();
}

Json turn_to_json(const EventTurn& turn) {
  Json json = Json::object();
  if (turn.to) json.set("to", *turn.to);
  if (turn.rate) json.set("rate", *turn.rate);
  if (!turn.blades.empty()) json.set("blades", turn.blades);
  return json;
}

}  // namespace

std::vector<Event> read_events(const TomlSection& root, const Model& model) {
  Model checked = model;
  for (const TomlSection& section : root.sections("event", keys::keys_of(keys::kEventRows)))
    checked.events.push_back(read_event(section));
  if (const Fault fault = find_events_fault(checked)) root.fail_at(fault.path, fault.text);
  return std::move(checked.events);
}

Fault find_events_fault(const Model& model) {
  for (std::size_t k = 0; k < model.events.size(); ++k) {
    const std::string path = "event." + std::to_string(k + 1);
    if (Fault fault = find_event_fault(model.events[k], model)) return fault.within(path);
    for (std::size_t i = 0; i < k; ++i)
      if (name_of_event(model.events[i], i) == name_of_event(model.events[k], k))
        return Fault{"name", "is \"" + name_of_event(model.events[k], k) +
                                 "\" as another one, expected each name once"}
            .within(path);
  }
  return {};
}

Json event_to_json(const Event& event) {
  Json json;
  if (!event.name.empty()) json.set("name", event.name);
  if (event.at) json.set("at", *event.at);
  if (!event.when.empty()) json.set("when", event.when);
  keys::write_numbers(keys::kEventRows, &event, json);
  if (event.generator_off) json.set("generator", "off");
  if (event.controller_off) json.set("controller", "off");
  if (event.pitch) json.set("pitch", turn_to_json(*event.pitch));
  if (event.yaw) json.set("yaw", turn_to_json(*event.yaw));
  return json;
}

}  // namespace spoke::spatial
