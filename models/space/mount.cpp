// A mount's translation and rotation vector with their first and second derivatives.

#include "models/space/mount.h"

#include "models/space/frame_course.h"

namespace spoke::space {

AxleMotion calc_axle_motion(const Hub& hub, double t) noexcept {
  AxleMotion motion;
  motion.R = make_rotation(hub.orientation);
  if (!hub.mount) return motion;
  const FrameCourse course =
      make_frame_course(follow(hub.mount->translation, t), follow(hub.mount->rotation, t));
  motion.p = course.p;
  motion.v = course.v;
  motion.a = course.a;
  motion.R = course.R * motion.R;
  const Rotation back = motion.R.inverse();
  motion.w = back * course.w;
  motion.alpha = back * course.alpha;
  return motion;
}

}  // namespace spoke::space
