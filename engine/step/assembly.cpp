// What several nodes ask of a pass.

#include "engine/step/assembly.h"

#include "engine/bodies/kernels/hub_motion.h"

namespace spoke {

template <class World>
bool corrects_hub(const Assembly<World>& g) {
  return std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method) &&
         !is_prescribed(g.c.system);
}

template bool corrects_hub(const Assembly<Plane>&);
template bool corrects_hub(const Assembly<Space>&);

}  // namespace spoke
