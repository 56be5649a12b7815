// Changes between steps of a simulation: the drive, the motion of a joint or an anchor.

#include <string>
#include <string_view>
#include <utility>

#include "engine/simulation/jumps.h"
#include "engine/simulation/simulation_core.h"
#include "models/error.h"
#include "models/system/single_rotor.h"

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
  all.check_continuation(place, begin, now());
  replace(in_force, course);
  replace_jumps_of(place, course);
  log_jumps();
}

void SimulationCore::set_anchor_motion(std::string_view name, const SaidAnchorMotion& begin,
                                       const decltype(AnchorModel::motion)& course) {
  const Anchors anchors = model->anchors();
  AnchorModel& anchor = anchors.said(name);
  require_state("go on from with another motion of an anchor");
  anchors.check_continuation(name, begin, now());
  replace(anchor.motion, course);
  replace_jumps_of(name, course);
  log_jumps();
}

int SimulationCore::find_rotor(std::string_view name) const {
  if (name.empty()) return 0;
  return spoke::find_rotor(scenario.space ? *scenario.space : spatial::Model{}, std::string(name),
                           "the rotor of a drive");
}

void SimulationCore::set_drive(const Drive& next, int rotor) {
  const bool is_acted_on = events && rotor == 0;
  replace(model->drive(rotor), is_acted_on ? events->act_on(next) : next);
  if (is_acted_on) events->set_own_drive(next);
  replace_jumps_of(next, rotor);
  log_jumps();
}

void SimulationCore::put_joint_motion(const JointPlace& place, const space::DrivenMotion& course) {
  joints("the motion of a joint").said_motion(place) = course;
  replace_jumps_of(place, course);
}

void SimulationCore::put_anchor_motion(std::string_view name,
                                       const decltype(AnchorModel::motion)& course) {
  model->anchors().said(name).motion = course;
  replace_jumps_of(name, course);
}

void SimulationCore::put_drive(const Drive& next, int rotor) {
  const bool is_acted_on = events && rotor == 0;
  model->drive(rotor) = is_acted_on ? events->act_on(next) : next;
  if (is_acted_on) events->set_own_drive(next);
  replace_jumps_of(next, rotor);
}

void SimulationCore::replace_jumps_of(const JointPlace& place, const space::DrivenMotion& course) {
  const SpatialJoints& all = joints("the motion of a joint");
  const std::string name = all.describe(place);
  std::vector<Jump> next;
  if (const auto* table = std::get_if<spatial::MotionTable>(&course)) {
    const double end = scenario.integration.duration;
    next = find_course_jumps(table->value, name, all.unit(place), now(), end, step_size);
  }
  replace_jumps(name, now(), std::move(next), jumps);
}

void SimulationCore::replace_jumps_of(std::string_view anchor,
                                      const decltype(AnchorModel::motion)& course) {
  std::vector<Jump> next;
  if (const auto* motion = std::get_if<spatial::MountMotion>(&course))
    next = find_anchor_jumps(anchor, *motion, now(), scenario.integration.duration, step_size);
  replace_jumps(describe_anchor(anchor), now(), std::move(next), jumps);
}

void SimulationCore::replace_jumps_of(const Drive& drive, int rotor) {
  const double end = scenario.integration.duration;
  const std::string source = describe_drive(scenario, rotor);
  replace_jumps(source, now(), find_drive_jumps(drive, source, now(), end, step_size), jumps);
}

void SimulationCore::log_jumps() {
  if (!jumps.empty()) log.log_warnings(scenario, seen, make_warnings());
}

SystemContext<Plane>& SimulationCore::plane(const char* what) const {
  SystemContext<Plane>* context = model->plane();
  if (!context)
    throw InputError(std::string(what) + ": the model is in space, expected a rotor in the plane");
  return *context;
}

}  // namespace spoke
