// A mount's translation and rotation vector with their first and second derivatives.

#include "models/space/mount.h"

#include <cmath>

#include "models/space/rotation_vector.h"

namespace spoke::space {
namespace {

/// A vector with its derivatives.
struct Course {
  Position value, rate, acceleration;
};

Course follow(const spatial::VectorHarmonic& course, double t) {
  const double angle = course.frequency * t + course.phase;
  const double s = std::sin(angle), c = course.frequency * std::cos(angle);
  return {course.constant + t * course.rate + s * course.amplitude,
          course.rate + c * course.amplitude,
          -course.frequency * course.frequency * s * course.amplitude};
}

Course follow(const spatial::VectorTable& table, double t) {
  Course course;
  for (int c = 0; c < kPosition; ++c) {
    const Curve& component = table.components[static_cast<std::size_t>(c)];
    course.value[c] = component.value(t);
    course.rate[c] = component.derivative(t);
    course.acceleration[c] = component.second_derivative(t);
  }
  return course;
}

Course follow(const spatial::VectorCourse& course, double t) {
  if (const auto* table = std::get_if<spatial::VectorTable>(&course)) return follow(*table, t);
  return follow(std::get<spatial::VectorHarmonic>(course), t);
}

}  // namespace

AxleMotion calc_axle_motion(const Hub& hub, double t) noexcept {
  AxleMotion motion;
  motion.R = make_rotation(hub.orientation);
  if (!hub.mount) return motion;
  const Course place = follow(hub.mount->translation, t);
  const Course theta = follow(hub.mount->rotation, t);
  motion.p = place.value;
  motion.v = place.rate;
  motion.a = place.acceleration;
  const RotationVectorMotion turn = calc_rotation_vector_motion(theta.value, theta.rate);
  motion.R = turn.R * motion.R;
  const Rotation back = motion.R.inverse();
  motion.w = back * turn.velocity;
  motion.alpha = back * Angular(turn.H.lazyProduct(theta.acceleration) + turn.convective);
  return motion;
}

}  // namespace spoke::space
