// Follows tables and harmonic motions, and makes the motion of a frame of them.

#include "models/space/frame_course.h"

#include <cmath>
#include <cstddef>

#include "models/space/rotation_vector.h"

namespace spoke::space {
namespace {

VectorMotion follow_harmonic(const spatial::VectorHarmonic& course, double t) {
  const double angle = course.frequency * t + course.phase;
  const double s = std::sin(angle), c = course.frequency * std::cos(angle);
  return {course.constant + t * course.rate + s * course.amplitude,
          course.rate + c * course.amplitude,
          -course.frequency * course.frequency * s * course.amplitude};
}

VectorMotion follow_table(const spatial::VectorTable& table, double t) {
  VectorMotion course;
  for (int c = 0; c < kPosition; ++c) {
    const Curve& component = table.components[static_cast<std::size_t>(c)];
    course.value[c] = component.value(t);
    course.rate[c] = component.derivative(t);
    course.acceleration[c] = component.second_derivative(t);
  }
  return course;
}

}  // namespace

VectorMotion follow(const spatial::VectorCourse& course, double t) {
  if (const auto* table = std::get_if<spatial::VectorTable>(&course))
    return follow_table(*table, t);
  return follow_harmonic(std::get<spatial::VectorHarmonic>(course), t);
}

FrameCourse make_frame_course(const VectorMotion& translation, const VectorMotion& rotation) {
  const RotationVectorMotion turn = calc_rotation_vector_motion(rotation.value, rotation.rate);
  return {translation.value,
          translation.rate,
          translation.acceleration,
          turn.R,
          turn.velocity,
          Angular(turn.H.lazyProduct(rotation.acceleration) + turn.convective)};
}

}  // namespace spoke::space
