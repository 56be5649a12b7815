// Lists of parts that several nodes declare.

#include "engine/step/assembly.h"

#include "engine/bodies/kernels/hub_motion.h"

namespace spoke {

using graph::PartId;

template <class World>
PartList loads_on(const Assembly<World>& g, int i, int j) {
  PartList list;
  if (g.c.data.subsystems[i].bodies[j].applied.empty())
    return list;  // spares a look at all markers
  for (const auto& actor : g.c.data.actors) actor->list_parts_on(i, j, list);
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
