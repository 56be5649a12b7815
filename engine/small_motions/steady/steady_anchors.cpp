// Takes time out of anchors, and finds loops that see the hub's rotation.

#include "engine/small_motions/steady/steady_anchors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "models/error.h"
#include "models/space/hub.h"
#include "models/space/rotation_vector.h"

namespace spoke::steady {
namespace {

using spatial::VectorCourse;
using spatial::VectorHarmonic;
using spatial::VectorTable;

/// Returns the value of a course at its end, or at t = 0.
Eigen::Vector3d value_of(const VectorCourse& course, Instant instant) {
  if (const auto* table = std::get_if<VectorTable>(&course)) {
    Eigen::Vector3d value;
    for (std::size_t c = 0; c < 3; ++c) {
      const Curve& component = table->components[c];
      value[static_cast<Eigen::Index>(c)] =
          instant == Instant::start ? component.value(0.0) : component.values().back();
    }
    return value;
  }
  const auto& harmonic = std::get<VectorHarmonic>(course);
  return harmonic.constant + std::sin(harmonic.phase) * harmonic.amplitude;
}

bool goes_on(const VectorCourse& course) {
  const auto* harmonic = std::get_if<VectorHarmonic>(&course);
  return harmonic && (!harmonic->rate.isZero(0.0) ||
                      (!harmonic->amplitude.isZero(0.0) && harmonic->frequency != 0.0));
}

/// Returns the part of a vector along the hub's axis.
Eigen::Vector3d axial_part(const AnchorModel& anchor, const Eigen::Vector3d& vector) {
  const space::Position in_hub = anchor.to_axis * space::Position(vector);
  return anchor.to_axis.inverse() * space::Position(0.0, 0.0, in_hub.z());
}

void hold(AnchorModel& anchor, bool turns, Instant instant) {
  const bool is_averaged = turns && anchor.turns_with_hub;
  const auto hold_vector = [&](const Eigen::Vector3d& vector) {
    return is_averaged ? axial_part(anchor, vector) : vector;
  };
  if (auto* said = std::get_if<SaidAnchorMotion>(&anchor.motion)) {
    space::Twist held;
    held.head<3>() = hold_vector(said->value.head<3>());
    held.tail<3>() = hold_vector(said->value.tail<3>());
    anchor.motion = SaidAnchorMotion{.value = held};
    return;
  }
  auto& motion = std::get<spatial::MountMotion>(anchor.motion);
  for (VectorCourse* course : {&motion.translation, &motion.rotation}) {
    if (instant == Instant::end && goes_on(*course))
      throw InputError("anchor \"" + anchor.name +
                       "\" moves without end, expected one that comes to rest, to find an "
                       "equilibrium");
    VectorHarmonic constant;
    constant.constant = hold_vector(value_of(*course, instant));
    *course = constant;
  }
}

/// Returns the place of an anchor that is held, in the frame in which it moves.
space::Pose pose_of(const AnchorModel& anchor) {
  Eigen::Vector3d translation, rotation;
  if (const auto* said = std::get_if<SaidAnchorMotion>(&anchor.motion)) {
    translation = said->value.head<3>();
    rotation = said->value.tail<3>();
  } else {
    const auto& motion = std::get<spatial::MountMotion>(anchor.motion);
    translation = std::get<VectorHarmonic>(motion.translation).constant;
    rotation = std::get<VectorHarmonic>(motion.rotation).constant;
  }
  return {anchor.to_axis * space::Position(translation),
          space::exponential(anchor.to_axis * space::Position(rotation))};
}

constexpr double kOff = 1e-12;  ///< sine of an angle, or share of a length, that is round-off

/// Whether rigid rows of displacement hold the same motions at every angle of the hub: those along
/// its axis, across it, or both.
bool are_places_round(const LoopModel& loop, const space::Pose& to) {
  Eigen::Matrix3d held = Eigen::Matrix3d::Zero();
  for (const LoopRow& row : loop.rows) {
    if (row.kind != LoopRow::Kind::displacement || !row.is_rigid()) continue;
    const Eigen::Vector3d axis = to.R * row.axis;
    held += axis * axis.transpose();
  }
  Eigen::Matrix3d quarter = Eigen::Matrix3d::Zero();
  quarter << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  return (quarter * held - held * quarter).cwiseAbs().maxCoeff() < kOff;
}

/// Whether the rigid rows of a loop on the hub's axis are the same at every angle of the hub: they
/// leave rotation about the axis.
bool is_round(const LoopModel& loop, const space::Pose& to) {
  if (std::none_of(loop.rows.begin(), loop.rows.end(),
                   [](const LoopRow& row) { return row.is_rigid(); }))
    return true;
  if (std::hypot(to.p.x(), to.p.y()) > kOff * (1.0 + std::abs(to.p.z()))) return false;
  const bool is_rigid = std::all_of(loop.rows.begin(), loop.rows.end(),
                                    [](const LoopRow& row) { return row.is_rigid(); });
  switch (loop.kind) {
    case LoopKind::distance:
      return true;
    case LoopKind::spherical:
      return are_places_round(loop, to);
    case LoopKind::revolute:
    case LoopKind::cylindrical:
    case LoopKind::bearing: {
      // Its last two rows hold the directions across its axis.
      const LoopRow* across = &loop.rows.back();
      const space::Position axis = to.R * cross(across[0].axis, across[-1].axis);
      return is_rigid && std::hypot(axis.x(), axis.y()) < kOff;
    }
    case LoopKind::universal: {
      const space::Position axis = to.R * loop.rows.back().axis;
      return is_rigid && std::hypot(axis.x(), axis.y()) < kOff;
    }
    case LoopKind::fixed:
    case LoopKind::prismatic:
      break;
  }
  return false;
}

/// Returns what carries the place, of those that turn against the hub; else none.
template <class World>
const char* find_turning(const System<World>& system, const LoopPlaceModel& place) {
  if (place.carrier == LoopPlace::Carrier::mount) return "the mount";
  if (place.carrier != LoopPlace::Carrier::anchor) return nullptr;
  const AnchorModel& anchor = system.anchors[static_cast<std::size_t>(place.anchor)];
  return anchor.frame == Anchor::Frame::mount ? "an anchor of the mount" : nullptr;
}

/// Refuses a loop whose rigid rows turn against the hub.
template <class World>
void require_steady(const System<World>& system, const LoopModel& loop, bool turns) {
  const char* carrier = find_turning(system, loop.to);
  if (!carrier) return;
  const auto refuse = [&](const std::string& what) {
    throw InputError("loop \"" + loop.name + "\" closes on " + carrier + what);
  };
  if (system.hub.support == HubSupport::free)
    refuse(", which a free hub does not have: expected a hub on an axle");
  if (!turns) return;
  space::Pose to = loop.to.offset;
  if (loop.to.carrier == LoopPlace::Carrier::anchor) {
    const AnchorModel& anchor = system.anchors[static_cast<std::size_t>(loop.to.anchor)];
    if (anchor.turns_with_hub) return;
    const space::Pose held = pose_of(anchor);
    to = {held.p + held.R * to.p, held.R * to.R};
  }
  if (!is_round(loop, to))
    refuse(
        ", against which the hub turns: expected a place on the hub's axis and a rigid closure "
        "that leaves rotation about it, an anchor that turns with the hub, or a hub at rest");
}

/// Returns whether springs of a loop are held by what turns against the hub.
template <class World>
bool has_standing_springs(const System<World>& system, const LoopModel& loop) {
  if (!find_turning(system, loop.to)) return false;
  if (loop.to.carrier == LoopPlace::Carrier::anchor &&
      system.anchors[static_cast<std::size_t>(loop.to.anchor)].turns_with_hub)
    return false;
  return std::any_of(loop.rows.begin(), loop.rows.end(),
                     [](const LoopRow& row) { return !row.is_rigid(); });
}

}  // namespace

template <class World>
std::string find_standing_springs(const System<World>& system, std::size_t subsystem) {
  for (const LoopModel& loop : system.subsystems[subsystem].loops)
    if (has_standing_springs(system, loop)) return loop.name;
  return {};
}

template <class World>
void hold_anchors(System<World>& system, bool turns, Instant instant) {
  for (AnchorModel& anchor : system.anchors) hold(anchor, turns, instant);
  for (const Subsystem<World>& subsystem : system.subsystems)
    for (const LoopModel& loop : subsystem.loops) require_steady(system, loop, turns);
}

template std::string find_standing_springs(const System<Plane>&, std::size_t);
template std::string find_standing_springs(const System<Space>&, std::size_t);
template void hold_anchors(System<Plane>&, bool, Instant);
template void hold_anchors(System<Space>&, bool, Instant);

}  // namespace spoke::steady
