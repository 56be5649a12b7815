// Rules for controllers: their numbers, and the joints that they move.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/names.h"
#include "models/reader/spatial/fault.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

/// A joint that a controller may move, and where it is, for people.
struct Candidate {
  const Joint* joint = nullptr;
  std::string place;
};

/// Returns the named joints of blades and of subsystems on the hub.
std::vector<Candidate> find_candidates(const Model& model) {
  std::vector<Candidate> found;
  const auto add = [&found](const Joint& joint, const std::string& place) {
    if (!joint.name.empty()) found.push_back({&joint, place});
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    for (const BladeJoint& joint : model.blades[i].joints)
      add(joint.joint, "blade " + std::to_string(i + 1));
  for (const Subsystem& subsystem : model.subsystems)
    if (!is_support(model, subsystem))
      for (const SubsystemJoint& joint : subsystem.joints) add(joint.joint, subsystem.name);
  return found;
}

/// Whether a joint of the support has this name.
bool is_on_support(const std::string& name, const Model& model) {
  for (const Subsystem& subsystem : model.subsystems)
    if (is_support(model, subsystem) &&
        std::any_of(subsystem.joints.begin(), subsystem.joints.end(),
                    [&](const SubsystemJoint& joint) { return joint.joint.name == name; }))
      return true;
  return false;
}

/// Returns what is wrong with a joint that a controller is to move; empty if nothing is.
std::string find_joint_fault(const Candidate& candidate) {
  const Joint& joint = *candidate.joint;
  const std::string where = " on " + candidate.place;
  if (joint.kind != JointKind::revolute)
    return "names a joint of kind \"" + std::string(name_of(joint.kind)) + "\"" + where +
           ", expected one of kind \"revolute\"";
  if (joint.coordinates.empty() || !joint.coordinates[0].motion)
    return "names a joint that turns freely" + where +
           ", expected one whose motion is prescribed, as by motion = { constant = 0.0 }, to which "
           "the angle is added";
  if (std::holds_alternative<ProgramMotion>(*joint.coordinates[0].motion))
    return "names a joint that the program moves" + where +
           ", expected one whose motion is constant, a table or by the azimuth";
  return {};
}

/// Returns what is wrong with a name of joints; empty if nothing is.
std::string find_joint_name_fault(const std::string& name, const Model& model) {
  std::vector<std::string_view> names;
  bool is_there = false;
  for (const Candidate& candidate : find_candidates(model)) {
    if (std::find(names.begin(), names.end(), candidate.joint->name) == names.end())
      names.push_back(candidate.joint->name);
    if (candidate.joint->name != name) continue;
    is_there = true;
    if (std::string fault = find_joint_fault(candidate); !fault.empty()) return fault;
  }
  if (is_there) return {};
  if (is_on_support(name, model))
    return "is \"" + name + "\", a joint of the support, expected one on the hub";
  if (names.empty())
    return "is \"" + name + "\", but no joint of a blade or a subsystem has a name";
  return describe_unknown(name, names);
}

Fault find_joints_fault(const std::vector<std::string>& joints, const Model& model) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string path = "joints." + std::to_string(i + 1);
    const auto end = joints.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(joints.begin(), end, joints[i]) != end)
      return {path, "is \"" + joints[i] + "\" as another one, expected each name once"};
    if (std::string fault = find_joint_name_fault(joints[i], model); !fault.empty())
      return {path, fault};
  }
  return {};
}

/// Returns what is wrong with the name of a joint that yaws a support; empty if nothing is.
std::string find_yaw_fault(const std::string& name, const Model& model) {
  if (name.empty()) return {};
  if (!model.support) return "is \"" + name + "\", but there is no [support]";
  std::vector<std::string_view> names;
  const Subsystem& support = model.subsystems.back();
  for (const SubsystemJoint& joint : support.joints) {
    if (joint.joint.name == name) return find_joint_fault({&joint.joint, "the support"});
    if (!joint.joint.name.empty()) names.push_back(joint.joint.name);
  }
  if (names.empty()) return "is \"" + name + "\", but no joint of the support has a name";
  return describe_unknown(name, names);
}

Fault find_record_fault(const std::vector<LibraryRecord>& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string path = "record." + std::to_string(i + 1);
    const FirstFault first;
    find_range_faults("", keys::kLibraryRecordRows, records[i], first);
    first("number", records[i].number, keys::kRecordNumbers, Presence::required);
    if (records[i].sensor.empty()) first.add({"sensor", "is empty, expected the name of a sensor"});
    for (std::size_t k = 0; k < i; ++k)
      if (records[k].number == records[i].number)
        first.add({"number", "is " + std::to_string(records[i].number) +
                                 " as of another record, expected each number once"});
    if (first.found()) return Fault(first.found()).within(path);
  }
  return {};
}

void find_sign_fault(const char* key, double sign, const FirstFault& first) {
  if (sign != 1.0 && sign != -1.0) first.add({key, "is " + describe(sign) + ", expected 1 or -1"});
}

Fault find_limits_fault(const PitchControl& control) {
  const FirstFault first;
  if (!(control.maximum > control.minimum))
    first.add({"maximum", "is " + describe(control.maximum) + ", expected more than minimum, " +
                              describe(control.minimum) + " (rad)"});
  if (!(control.initial >= control.minimum && control.initial <= control.maximum))
    first.add({"initial", "is " + describe(control.initial) + ", expected minimum to maximum, " +
                              describe(control.minimum) + " to " + describe(control.maximum) +
                              " (rad)"});
  if (control.half_gain_angle && !(control.minimum > -*control.half_gain_angle))
    first.add({"half_gain_angle",
               "is " + describe(*control.half_gain_angle) + ", expected more than -minimum, " +
                   describe(-control.minimum) + " (rad), at which gains would be infinite"});
  return first.found();
}

}  // namespace

Fault find_fault(const PitchControl& control, const Model& model) {
  const FirstFault first;
  keys::visit_numbers<void>(keys::kPitchControlRows, control, first);
  keys::visit_options(
      keys::kPitchControlRows, control,
      [&](std::string_view key, const std::optional<double>& value, const Quantity& quantity) {
        if (value) first(key, *value, quantity);
      });
  if (control.speed == 0.0)
    first.add({"speed", "is 0, expected the set point of a hub that turns (rad/s)"});
  if (control.proportional == 0.0 && control.integral == 0.0)
    first.add({"integral", "is 0, as proportional is, expected that one of them is not"});
  first("initial", control.initial, kAngle);
  find_sign_fault("sign", control.sign, first);
  if (control.schedule && control.half_gain_angle)
    first.add({"schedule", "given along with half_gain_angle, expected only one of them"});
  if (control.schedule) {
    for (const double factor : control.schedule->values())
      first("schedule.factor", factor, Quantity::positive(""));
    for (const double angle : control.schedule->times()) first("schedule.angle", angle, kAngle);
  }
  first.add(find_limits_fault(control));
  if (control.joints.empty()) first.add({"joints", "is empty, expected names of joints"});
  first.add(find_joints_fault(control.joints, model));
  return first.found();
}

Fault find_fault(const OuterControl& control, const Model& model) {
  const FirstFault first;
  const auto look = [&](keys::Rows rows) {
    keys::visit_numbers<void>(rows, control, first);
    keys::visit_options(
        rows, control,
        [&](std::string_view key, const std::optional<double>& value, const Quantity& quantity) {
          if (value) first(key, *value, quantity);
        });
  };
  look(keys::kOuterControlRows);
  if (control.is_library()) look(keys::kLibraryRows);
  find_sign_fault("sign", control.sign, first);
  find_sign_fault("direction", control.direction, first);
  first.add(find_joints_fault(control.joints, model));
  if (const std::string fault = find_yaw_fault(control.yaw_joint, model); !fault.empty())
    first.add({"yaw_joint", fault});
  if (control.has_controller && model.hub.support == HubSupport::free && !model.support)
    first.add({"", "is of a hub that is free, expected one on an axle"});
  if (control.sets_torque() && prescribes_motion(model.hub.drive))
    first.add({"", "sets the torque of a drive, but hub.drive.kind is \"" +
                       std::string(name_of(model.hub.drive)) + "\", expected \"torque\""});
  if (control.gear_ratio && model.support && axle_of(model, 0).train)
    first.add(
        {"gear_ratio", "given along with that of the drive train, expected only one of them"});
  const std::size_t blades =
      model.blades.size() + model.subsystems.size() - (model.support ? 1 : 0);
  if (control.individual_pitch && blades > 3)
    first.add({"individual_pitch", "is true of " + std::to_string(blades) +
                                       " blades and subsystems, expected at most 3"});
  first.add(find_record_fault(control.records));
  if (control.laws) first.add(find_laws_fault(control));
  return first.found();
}

}  // namespace spoke::spatial
