#pragma once

// Scenes as the data of a page.

#include <vector>

#include "engine/scene/scene.h"
#include "models/support/json.h"
#include "models/tree/mass_properties.h"

namespace spoke::run_report {

/// Describes a scene for program/report/scene.js.
Json describe_scene(const scene::Scene& scene);

/// Adds x, y, z [m] and a quaternion (w, x, y, z).
void append_pose(const spatial::Placement& pose, std::vector<float>& numbers);

}  // namespace spoke::run_report
