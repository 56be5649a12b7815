// Finds coordinates of joints, and refuses those that the program does not move.

#include "engine/simulation/spatial_joints.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/simulation/require_range.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

/// Returns a name like "coordinate 0 of joint 2 ("pitch") of blade 1".
std::string name_of(const JointPlace& place, const spatial::Tree& tree) {
  std::ostringstream text;
  text << "coordinate " << place.coordinate << " of joint " << place.joint;
  const std::string& name = tree.bodies[static_cast<std::size_t>(place.joint)].joint.name;
  if (!name.empty()) text << " (\"" << name << "\")";
  text << " of " << tree.name;
  return text.str();
}

std::int64_t last_of(std::size_t count) { return static_cast<std::int64_t>(count) - 1; }

}  // namespace

const spatial::Tree& SpatialJoints::tree(int subsystem) const {
  require_range("the index of the blade or subsystem", subsystem, 0, last_of(trees_.size()));
  return trees_[static_cast<std::size_t>(subsystem)];
}

std::string SpatialJoints::describe(const JointPlace& place) const {
  return name_of(place, tree(place.subsystem));
}

std::string SpatialJoints::unit(const JointPlace& place) const {
  const spatial::JointKind kind =
      tree(place.subsystem).bodies[static_cast<std::size_t>(place.joint)].joint.kind;
  return slides(kind, place.coordinate) ? "m" : "rad";
}

int SpatialJoints::find(int subsystem, std::string_view name) const {
  const spatial::Tree& found = tree(subsystem);
  std::vector<std::string_view> names;
  for (std::size_t j = 0; j < found.bodies.size(); ++j) {
    const std::string& joint = found.bodies[j].joint.name;
    if (!joint.empty() && joint == name) return static_cast<int>(j);
    if (!joint.empty()) names.push_back(joint);
  }
  const auto nearest = nearest_name(name, names);
  throw InputError("no joint of " + found.name + " is named \"" + std::string(name) + "\"" +
                   (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?" : ""));
}

const spatial::JointCoordinate& SpatialJoints::coordinate(const JointPlace& place) const {
  const spatial::Tree& found = tree(place.subsystem);
  require_range("the index of the joint", place.joint, 0, last_of(found.bodies.size()));
  const spatial::Joint& joint = found.bodies[static_cast<std::size_t>(place.joint)].joint;
  const int count = count_coordinates(joint.kind);
  if (count == 0)
    throw InputError("joint " + std::to_string(place.joint) + " of " + found.name +
                     " is fixed, expected one with a coordinate");
  require_range("the coordinate of the joint", place.coordinate, 0, count - 1);
  return joint.coordinates[static_cast<std::size_t>(place.coordinate)];
}

std::size_t SpatialJoints::find_driven(const JointPlace& place) const {
  if (!coordinate(place).motion)
    throw InputError(name_of(place, tree(place.subsystem)) +
                     " is free, expected one whose motion is prescribed");
  std::size_t before = 0;
  for (int c = 0; c < place.coordinate; ++c)
    before += coordinate({place.subsystem, place.joint, c}).motion.has_value();
  return before;
}

std::size_t SpatialJoints::count_free_before(const JointPlace& place) const {
  std::size_t before = 0;
  for (int c = 0; c < place.coordinate; ++c)
    before += !coordinate({place.subsystem, place.joint, c}).motion.has_value();
  return before;
}

space::PrescribedMotion SpatialJoints::free_motion(const JointPlace& place) const {
  const spatial::Joint& joint =
      tree(place.subsystem).bodies[static_cast<std::size_t>(place.joint)].joint;
  if (joint.kind == spatial::JointKind::spherical)
    throw InputError(name_of(place, tree(place.subsystem)) +
                     " is one of a rotation in space, expected one about or along an axis");
  const std::size_t free = count_free_before(place);
  const CoordinateBlock& state = context_.data.subsystems[static_cast<std::size_t>(place.subsystem)]
                                     .bodies[static_cast<std::size_t>(place.joint)]
                                     .joint.coordinates;
  return {state.q[free], state.v[free], state.a[free]};
}

space::PrescribedMotion SpatialJoints::motion(const JointPlace& place, double t) {
  if (!coordinate(place).motion) return free_motion(place);
  const std::size_t driven = find_driven(place);
  const auto i = static_cast<std::size_t>(place.subsystem);
  prescribe_joints(context_.system, t, i, context_.data);
  return context_.data.subsystems[i]
      .bodies[static_cast<std::size_t>(place.joint)]
      .joint.driven[driven];
}

space::DrivenMotion& SpatialJoints::said_motion(const JointPlace& place) {
  const std::size_t driven = find_driven(place);
  if (!std::holds_alternative<spatial::ProgramMotion>(*coordinate(place).motion))
    throw InputError(name_of(place, tree(place.subsystem)) +
                     " follows the scenario, expected motion = { by = \"program\" }");
  return context_.system.subsystems[static_cast<std::size_t>(place.subsystem)]
      .bodies[static_cast<std::size_t>(place.joint)]
      .joint.course.driven[driven];
}

double& SpatialJoints::added_torque(const JointPlace& place) {
  if (coordinate(place).motion)
    throw InputError(name_of(place, tree(place.subsystem)) +
                     " has a prescribed motion, expected one that is free");
  space::JointCourse& course = context_.system.subsystems[static_cast<std::size_t>(place.subsystem)]
                                   .bodies[static_cast<std::size_t>(place.joint)]
                                   .joint.course;
  return course.added[count_free_before(place)];
}

std::vector<JointPlace> SpatialJoints::said() const {
  std::vector<JointPlace> found;
  for (std::size_t i = 0; i < trees_.size(); ++i)
    for (std::size_t j = 0; j < trees_[i].bodies.size(); ++j) {
      const spatial::Joint& joint = trees_[i].bodies[j].joint;
      for (int c = 0; c < count_coordinates(joint.kind); ++c) {
        const auto& motion = joint.coordinates[static_cast<std::size_t>(c)].motion;
        if (motion && std::holds_alternative<spatial::ProgramMotion>(*motion))
          found.push_back({static_cast<int>(i), static_cast<int>(j), c});
      }
    }
  return found;
}

void SpatialJoints::check_continuation(const JointPlace& place,
                                       const space::PrescribedMotion& begin, double t) {
  const space::PrescribedMotion old = motion(place, t);
  constexpr double slack = 1e-9;
  if (std::abs(old.value - begin.value) <= slack && std::abs(old.rate - begin.rate) <= slack &&
      std::isfinite(begin.acceleration))
    return;
  std::ostringstream text;
  text << "the motion of " << name_of(place, tree(place.subsystem))
       << " does not go on from where it is at t = " << t << " s: it begins at " << begin.value
       << " with the rate " << begin.rate << " and acceleration " << begin.acceleration
       << ", expected " << old.value << " and " << old.rate;
  throw InputError(text.str());
}

}  // namespace spoke
