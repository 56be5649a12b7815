#pragma once

// Scenes as the data of a page.

#include <vector>

#include "engine/output/scene/scene.h"
#include "models/support/json.h"
#include "models/tree/mass_properties.h"

namespace spoke::run_report {

/// Describes a scene for program/report/scene.js.
Json describe_scene(const scene::Scene& scene);

/// Adds the numbers of a frame for a solid at its coordinates: themselves if it is reduced; of a
/// nodal one displacements of its drawn nodes [m], then their von Mises stresses [Pa] if it has
/// any, else zeros. Adds nothing where only the mesh is known.
void append_numbers(const scene::Surface& surface, const std::vector<double>& coordinates,
                    std::vector<float>& numbers);

/// Adds x, y, z [m] and a quaternion (w, x, y, z).
void append_pose(const spatial::Placement& pose, std::vector<float>& numbers);

}  // namespace spoke::run_report
