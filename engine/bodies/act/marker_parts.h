#pragma once

// Parts that the nodes of actors with markers declare.

#include <vector>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Returns the parts on which the places of markers depend: on each of their subsystems the bodies
/// up to the outermost marker's own; in space the handles of those inboard are with the rotations.
/// The progress is that of the first subsystem.
template <class World>
PartList marker_inputs(const StepData<World>& data, const std::vector<int>& subsystems,
                       const std::vector<PlacedMarker<World>>& markers);

/// Returns the workspaces that placing markers uses: those of the solids that stiffen in their
/// trees, which draw what they carry inward.
PartList marker_scratch(const StepData<Plane>& data,
                        const std::vector<PlacedMarker<Plane>>& markers);
PartList marker_scratch(const StepData<Space>& data,
                        const std::vector<PlacedMarker<Space>>& markers);

}  // namespace spoke
