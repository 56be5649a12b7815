// Looks for motions of a mount that do not end.

#include "engine/small_motions/steady/steady_mount.h"

#include <algorithm>
#include <string>
#include <variant>

#include "models/error.h"
#include "models/space/mount.h"

namespace spoke::steady {
namespace {

using spatial::VectorHarmonic;
using spatial::VectorTable;

/// Returns the time at which a course has come to its end [s].
double end_of(const spatial::VectorCourse& course) {
  double end = 0.0;
  if (const auto* table = std::get_if<VectorTable>(&course))
    for (const Curve& component : table->components) end = std::max(end, component.times().back());
  return end;
}

[[noreturn]] void refuse(const std::string& key, const std::string& what) {
  throw InputError("hub.mount." + key + ": the mount " + what +
                   " without end, expected one that comes to rest, or translates at constant "
                   "velocity, to find an equilibrium");
}

void require_rest(const std::string& key, const spatial::VectorCourse& course, bool may_go_on) {
  const auto* harmonic = std::get_if<VectorHarmonic>(&course);
  if (!harmonic) return;
  if (!harmonic->amplitude.isZero(0.0) && harmonic->frequency != 0.0) refuse(key, "oscillates");
  if (!may_go_on && !harmonic->rate.isZero(0.0)) refuse(key, "turns");
}

}  // namespace

void hold_mount(space::Hub& hub, Instant instant) {
  if (!hub.mount) return;
  double when = 0.0;
  if (instant == Instant::end) {
    require_rest("translation", hub.mount->translation, true);
    require_rest("rotation", hub.mount->rotation, false);
    when = end_of(hub.mount->rotation);
  }
  hub.orientation = space::make_quaternion(calc_axle_motion(hub, when).R);
  hub.mount.reset();
}

}  // namespace spoke::steady
