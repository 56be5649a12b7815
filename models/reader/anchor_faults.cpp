// Rules for anchors.

#include "models/reader/loop_faults.h"

namespace spoke {
namespace {

constexpr const char* kNoSupport =
    "is \"axle\", which belongs to a hub on a support; expected \"mount\" or \"hub\"";

using spatial::FirstFault;

/// Whether a component of a course is 0 all the time.
bool is_zero(const spatial::VectorCourse& course, std::size_t component) {
  if (const auto* table = std::get_if<spatial::VectorTable>(&course)) {
    const std::vector<double>& values = table->components[component].values();
    return values.size() == 1 && values[0] == 0.0;
  }
  const auto& harmonic = std::get<spatial::VectorHarmonic>(course);
  const auto c = static_cast<Eigen::Index>(component);
  return harmonic.constant[c] == 0.0 && harmonic.rate[c] == 0.0 && harmonic.amplitude[c] == 0.0;
}

/// Finds vectors that leave the plane; files cannot say any.
Fault find_plane_fault(const spatial::MountMotion& motion) {
  if (!is_zero(motion.translation, 2))
    return {"motion.translation", "leaves the plane, expected z = 0"};
  if (!is_zero(motion.rotation, 0) || !is_zero(motion.rotation, 1))
    return {"motion.rotation", "leaves the plane, expected a rotation about z"};
  return {};
}

Fault find_plane_fault(const ProgramAnchorMotion& motion) {
  if (motion.translation.z() != 0.0)
    return {"motion.translation", "leaves the plane, expected z = 0"};
  if (!motion.rotation.head<2>().isZero(0.0))
    return {"motion.rotation", "leaves the plane, expected a rotation about z"};
  return {};
}

Fault find_motion_fault(const spatial::MountMotion& motion) {
  const FirstFault first;
  first.add(spatial::find_course_fault("motion.translation", motion.translation, "m"));
  first.add(spatial::find_course_fault("motion.rotation", motion.rotation, "rad"));
  return first.found();
}

Fault find_motion_fault(const ProgramAnchorMotion& motion) {
  const FirstFault first;
  first("motion.translation", motion.translation, kLength, Presence::optional);
  first("motion.rotation", motion.rotation, spatial::kAngle, Presence::optional);
  return first.found();
}

}  // namespace

std::string find_mount_fault(HubSupport support) {
  if (support == HubSupport::axle) return {};
  return "is \"mount\", which a free hub has not; expected \"hub\"";
}

std::string find_mount_fault(const spatial::Model& model) {
  if (model.support && model.support->from == spatial::SupportBase::free)
    return "is \"mount\", which a support that is free has not; expected \"hub\"";
  return find_mount_fault(model.hub.support);
}

Fault find_fault(const Anchor& anchor, const std::vector<Anchor>& before,
                 const std::string& mount_fault, bool in_plane) {
  const FirstFault first;
  first.add(spatial::find_name_fault(anchor.name));
  for (const Anchor& other : before)
    if (other.name == anchor.name)
      first.add(
          {"name", "is \"" + anchor.name + "\" as another anchor's, expected a name of its own"});
  const bool is_of_hub = anchor.frame == Anchor::Frame::hub;
  const bool is_of_body = anchor.frame == Anchor::Frame::body;
  if (in_plane && anchor.frame == Anchor::Frame::axle) first.add({"frame", kNoSupport});
  if (in_plane && is_of_body)
    first.add({"frame", "is \"" + anchor.body + "\", expected \"mount\" or \"hub\""});
  if (anchor.frame == Anchor::Frame::mount && !mount_fault.empty())
    first.add({"frame", mount_fault});
  if (is_of_hub && anchor.turns_with_hub)
    first.add({"turns_with_hub",
               "is true in the frame \"hub\", which turns with the hub itself; expected it only "
               "with frame = \"mount\" or \"axle\""});
  if (is_of_body && anchor.turns_with_hub)
    first.add({"turns_with_hub",
               "is true, but the frame is that of a body, which turns with its own; expected it "
               "only with frame = \"mount\" or \"axle\""});
  if (is_of_body && anchor.rotor != 0)
    first.add({"rotor",
               "is not the first, but the frame is that of a body; expected none, or frame = "
               "\"hub\" or \"axle\""});
  if (in_plane && anchor.rotor != 0)
    first.add({"rotor", "names a rotor in space, expected none in the plane"});
  if (anchor.frame == Anchor::Frame::mount && anchor.rotor != 0)
    first.add({"rotor",
               "is not the first, but the frame is \"mount\", which is no rotor's; expected none, "
               "or frame = \"hub\" or \"axle\""});
  std::visit(
      [&](const auto& motion) {
        first.add(find_motion_fault(motion));
        if (in_plane) first.add(find_plane_fault(motion));
      },
      anchor.motion);
  return first.found();
}

Fault find_axle_frame_fault(const spatial::Model& model) {
  for (std::size_t i = 0; i < model.anchors.size(); ++i) {
    if (model.anchors[i].frame != Anchor::Frame::axle) continue;
    const std::string key = "anchor." + std::to_string(i + 1) + ".frame";
    if (!model.support) return {key, kNoSupport};
    if (!spatial::is_hub_prescribed(model, model.anchors[i].rotor))
      return {key,
              "is \"axle\", but no drive prescribes the hub's angle, so that its forces would turn "
              "the hub; expected a drive that does, or \"hub\""};
  }
  return {};
}

}  // namespace spoke
