// Lists the parts by the bodies that lie between the hub and a marker.

#include "engine/bodies/act/marker_parts.h"

#include <algorithm>
#include <utility>

namespace spoke {

template <class World>
PartList marker_inputs(const StepData<World>& data, const std::vector<int>& subsystems,
                       const std::vector<PlacedMarker<World>>& markers) {
  const SubsystemParts& first = data.subsystems[static_cast<std::size_t>(subsystems.front())].parts;
  PartList inputs{first.progress, first.hub_state};
  for (const int i : subsystems) {
    const SubsystemParts& own = data.subsystems[static_cast<std::size_t>(i)].parts;
    int last = 0;
    for (const PlacedMarker<World>& marker : markers)
      if (marker.subsystem == i) last = std::max(last, marker.body);
    inputs.push_back(own.rotations);
    inputs.push_back(own.twists);
    for (int j = 0; j <= last; ++j)
      inputs.push_back(own.bodies[static_cast<std::size_t>(j)].coordinates);
  }
  return inputs;
}

PartList marker_scratch(const StepData<Plane>&, const std::vector<PlacedMarker<Plane>>&) {
  return {};
}

PartList marker_scratch(const StepData<Space>& data,
                        const std::vector<PlacedMarker<Space>>& markers) {
  PartList scratch;
  for (const PlacedMarker<Space>& marker : markers) {
    const SubsystemData<Space>& own = data.subsystems[static_cast<std::size_t>(marker.subsystem)];
    for (std::size_t j = 0; std::cmp_less_equal(j, marker.body); ++j)
      if (own.bodies[j].solid_tension && own.bodies[j].model->stiffening)
        scratch.push_back(own.parts.bodies[j].scratch);
  }
  return scratch;
}

template PartList marker_inputs(const StepData<Plane>&, const std::vector<int>&,
                                const std::vector<PlacedMarker<Plane>>&);
template PartList marker_inputs(const StepData<Space>&, const std::vector<int>&,
                                const std::vector<PlacedMarker<Space>>&);

}  // namespace spoke
