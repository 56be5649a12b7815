// Finds anchors by name, and refuses motions of those that the program does not move.

#include "engine/simulation/anchors.h"

#include <algorithm>
#include <cassert>
#include <sstream>

#include "engine/bodies/kernels/loops/anchor_motion.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

space::Twist join(const space::Position& translation, const space::Position& rotation) {
  return space::make_twist(translation, space::Angular(rotation));
}

bool are_near(const space::Twist& one, const space::Twist& other) {
  constexpr double slack = 1e-9;
  return ((one - other).cwiseAbs().array() <= slack).all();
}

/// Returns "[1, 2, 3] m and [0, 0, 0] rad".
std::string describe(const space::Twist& vectors, const char* per_time) {
  std::ostringstream text;
  const auto write = [&](int first, const char* unit) {
    text << '[' << vectors[first] << ", " << vectors[first + 1] << ", " << vectors[first + 2]
         << "] " << unit << per_time;
  };
  write(0, "m");
  text << " and ";
  write(space::kRotation, "rad");
  return text.str();
}

/// Whether a motion leaves the plane: a translation along z, or a rotation about x or y.
bool leaves_plane(const SaidAnchorMotion& motion) {
  for (const space::Twist* vectors : {&motion.value, &motion.rate, &motion.acceleration})
    for (const int c : {2, 3, 4})
      if ((*vectors)[c] != 0.0) return true;
  return false;
}

}  // namespace

std::string describe_anchor(std::string_view name) {
  return "the anchor \"" + std::string(name) + "\"";
}

std::size_t Anchors::find(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const AnchorModel& anchor : models_) names.push_back(anchor.name);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  const auto nearest = nearest_name(name, names);
  throw InputError("no anchor is named \"" + std::string(name) + "\"" +
                   (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?" : ""));
}

SaidAnchorMotion Anchors::motion(std::string_view name, double t) const {
  return motion_of(models_[find(name)], t);
}

SaidAnchorMotion motion_of(const AnchorModel& anchor, double t) {
  const AnchorVectors course = follow(anchor, t);
  return {t, join(course.translation.value, course.rotation.value),
          join(course.translation.rate, course.rotation.rate),
          join(course.translation.acceleration, course.rotation.acceleration)};
}

AnchorModel& Anchors::said(std::string_view name) const {
  const std::size_t number = find(name);
  assert(number < described().size());
  if (!std::holds_alternative<ProgramAnchorMotion>(described()[number].motion))
    throw InputError(describe_anchor(name) +
                     " follows the scenario, expected motion = { by = \"program\" }");
  return models_[number];
}

std::vector<const AnchorModel*> Anchors::said() const {
  std::vector<const AnchorModel*> found;
  for (std::size_t k = 0; k < models_.size(); ++k)
    if (std::holds_alternative<ProgramAnchorMotion>(described()[k].motion))
      found.push_back(&models_[k]);
  return found;
}

void Anchors::check_continuation(std::string_view name, const SaidAnchorMotion& begin,
                                 double t) const {
  if (!scenario_.space && leaves_plane(begin))
    throw InputError("the motion of " + describe_anchor(name) +
                     " leaves the plane, expected translations along x and y and a rotation "
                     "about z");
  const SaidAnchorMotion old = motion(name, t);
  if (are_near(old.value, begin.value) && are_near(old.rate, begin.rate) &&
      begin.acceleration.allFinite())
    return;
  std::ostringstream text;
  text << "the motion of " << describe_anchor(name)
       << " does not go on from where it is at t = " << t << " s: it begins at "
       << describe(begin.value, "") << " with the rates " << describe(begin.rate, "/s")
       << " and accelerations " << describe(begin.acceleration, "/s^2") << ", expected "
       << describe(old.value, "") << " with " << describe(old.rate, "/s");
  throw InputError(text.str());
}

}  // namespace spoke
