// Looks for a support, and for bearings.

#include "engine/small_motions/vibration/choose_frame.h"

#include <algorithm>

namespace spoke {
namespace {

/// Whether springs of loops are held by the mount, or by an anchor beside the hub.
bool has_bearings(const spatial::Model& space) {
  const auto stands = [&](const LoopPlace& place) {
    if (place.carrier == LoopPlace::Carrier::mount) return true;
    return place.carrier == LoopPlace::Carrier::anchor &&
           std::any_of(space.anchors.begin(), space.anchors.end(), [&](const Anchor& anchor) {
             return anchor.name == place.name && anchor.frame == Anchor::Frame::mount &&
                    !anchor.turns_with_hub;
           });
  };
  const auto has = [&](const auto& parts) {
    for (const auto& part : parts)
      for (const Loop& loop : part.loops)
        if ((!loop.stiffness.empty() || loop.matrices) && stands(loop.to)) return true;
    return false;
  };
  return has(space.blades) || has(space.subsystems);
}

}  // namespace

ModeFrame vibration::choose_frame(const Scenario& scenario, std::optional<ModeFrame> asked) {
  if (asked) return *asked;
  const bool sees_standing =
      scenario.space && (scenario.space->support || has_bearings(*scenario.space));
  return sees_standing ? ModeFrame::fixed : ModeFrame::turning;
}

}  // namespace spoke
