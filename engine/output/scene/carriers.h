#pragma once

// What carries ends of loops and is no body: the mount and anchors.

#include <vector>

#include "engine/output/scene/scene.h"
#include "models/tree/mass_properties.h"

namespace spoke::scene {

/// Adds the groups of the mount and the anchors, behind that of the hub, if any loop closes on
/// them.
void add_carriers(const std::vector<Anchor>& anchors, const std::vector<const Loop*>& loops,
                  Scene& scene);

/// Whether the closure gives, by springs.
bool is_sprung(const Loop& loop);

/// Returns the group that a place without a body is fixed to.
int find_group(const Scene& scene, LoopPlace::Carrier carrier, int anchor);

/// Returns the group of the hub of the rotor that a carrier is beside.
int group_of_hub(const Scene& scene, const Carrier& carrier);

/// Adds a plate for each anchor, through the places of the scene's loops on it.
void add_plates(const std::vector<Anchor>& anchors, Scene& scene);

/// Returns where an anchor is at t = 0, in the frame in which it moves.
spatial::Placement calc_first_place(const Anchor& anchor);
/// Returns where it comes to rest. `axis`: null, or the unit vector along which alone its motion
/// counts, as that of a swashplate on a hub that turns (docs/modes.md).
spatial::Placement calc_last_place(const Anchor& anchor, const Vector* axis);

}  // namespace spoke::scene
