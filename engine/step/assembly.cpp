// Lists of parts that several nodes declare.

#include "engine/step/assembly.h"

#include <algorithm>

#include "engine/kernels/hub_motion.h"

namespace spoke {

using graph::PartId;

template <class World>
PartList loads_on(const Assembly<World>& g, int i, int j) {
  PartList list;
  if (g.c.data.subsystems[i].bodies[j].applied.empty())
    return list;  // spares a look at all subsystems
  for (std::size_t first = 0; first < g.c.data.subsystems.size(); ++first) {
    const std::vector<LoadData<World>>& loads = g.c.data.subsystems[first].loads;
    for (std::size_t k = 0; k < loads.size(); ++k)
      if (std::any_of(loads[k].markers.begin(), loads[k].markers.end(),
                      [i, j](const PlacedMarker<World>& marker) {
                        return marker.subsystem == i && marker.body == j;
                      }))
        list.push_back(g.c.data.subsystems[first].parts.loads[k]);
  }
  if (g.c.data.subsystems[i].air) list.push_back(g.subsystem(i).air);
  return list;
}

template <class World>
bool corrects_hub(const Assembly<World>& g) {
  return std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method) &&
         !is_prescribed(g.c.system);
}

template PartList loads_on(const Assembly<Plane>&, int, int);
template bool corrects_hub(const Assembly<Plane>&);
template PartList loads_on(const Assembly<Space>&, int, int);
template bool corrects_hub(const Assembly<Space>&);

}  // namespace spoke
