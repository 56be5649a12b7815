// Changes between steps of a simulation: the drive, the motion of a joint or an anchor.

#include <utility>

#include "engine/simulation/jumps.h"
#include "engine/simulation/simulation_core.h"
#include "models/error.h"

namespace spoke {

SpatialJoints& SimulationCore::joints(const char* what) const {
  SpatialJoints* joints = model->joints();
  if (!joints)
    throw InputError(std::string(what) + ": the model is in the plane, expected one in space");
  return *joints;
}

void SimulationCore::set_joint_motion(const JointPlace& place, const space::PrescribedMotion& begin,
                                      const space::DrivenMotion& course) {
  SpatialJoints& all = joints("the motion of a joint");
  require_state("go on from with another motion of a joint");
  space::DrivenMotion& in_force = all.said_motion(place);
  const double t = static_cast<double>(runner->steps()) * step_size;
  all.check_continuation(place, begin, t);
  replace(in_force, course);
  const std::string name = all.describe(place);
  std::vector<Jump> next;
  if (const auto* table = std::get_if<spatial::MotionTable>(&course)) {
    const double end = scenario.integration.duration;
    next = find_course_jumps(table->value, name, all.unit(place), t, end, step_size);
  }
  set_jumps(name, std::move(next));
}

void SimulationCore::set_anchor_motion(std::string_view name, const SaidAnchorMotion& begin,
                                       const decltype(AnchorModel::motion)& course) {
  const Anchors anchors = model->anchors();
  AnchorModel& anchor = anchors.said(name);
  require_state("go on from with another motion of an anchor");
  const double t = static_cast<double>(runner->steps()) * step_size;
  anchors.check_continuation(name, begin, t);
  replace(anchor.motion, course);
  std::vector<Jump> next;
  if (const auto* motion = std::get_if<spatial::MountMotion>(&course))
    next = find_anchor_jumps(name, *motion, t, scenario.integration.duration, step_size);
  set_jumps(describe_anchor(name), std::move(next));
}

void SimulationCore::set_drive(const Drive& next) {
  const double t = static_cast<double>(runner->steps()) * step_size;
  replace(model->drive(), next);
  set_jumps(kDriveSource, find_drive_jumps(next, t, scenario.integration.duration, step_size));
}

void SimulationCore::set_jumps(const std::string& source, std::vector<Jump> next) {
  const double t = static_cast<double>(runner->steps()) * step_size;
  replace_jumps(source, t, std::move(next), jumps);
  if (!jumps.empty()) log.log_warnings(scenario, seen, make_warnings());
}

SystemContext<Plane>& SimulationCore::plane(const char* what) const {
  SystemContext<Plane>* context = model->plane();
  if (!context)
    throw InputError(std::string(what) + ": the model is in space, expected a rotor in the plane");
  return *context;
}

}  // namespace spoke
