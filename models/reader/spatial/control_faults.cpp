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

Fault find_joints_fault(const PitchControl& control, const Model& model) {
  if (control.joints.empty()) return {"joints", "is empty, expected names of joints"};
  for (std::size_t i = 0; i < control.joints.size(); ++i) {
    const std::string path = "joints." + std::to_string(i + 1);
    const auto end = control.joints.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(control.joints.begin(), end, control.joints[i]) != end)
      return {path, "is \"" + control.joints[i] + "\" as another one, expected each name once"};
    if (std::string fault = find_joint_name_fault(control.joints[i], model); !fault.empty())
      return {path, fault};
  }
  return {};
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
  if (control.sign != 1.0 && control.sign != -1.0)
    first.add({"sign", "is " + describe(control.sign) + ", expected 1 or -1"});
  if (control.schedule && control.half_gain_angle)
    first.add({"schedule", "given along with half_gain_angle, expected only one of them"});
  if (control.schedule) {
    for (const double factor : control.schedule->values())
      first("schedule.factor", factor, Quantity::positive(""));
    for (const double angle : control.schedule->times()) first("schedule.angle", angle, kAngle);
  }
  first.add(find_limits_fault(control));
  first.add(find_joints_fault(control, model));
  return first.found();
}

}  // namespace spoke::spatial
