// Memory of the formulation, per subsystem.

#include <utility>

#include "engine/formulation/structured.h"

namespace spoke::structured {

void allocate(const SubsystemData& data, SubsystemWork& work) {
  Arena& arena = *data.arena;
  work.bodies = ArenaVector<BodyWork>(data.bodies.size(), arena);
  std::size_t flex_total = FlexLayout::kPad;
  std::size_t scratch_total = 0;
  for (const BodyData& body : data.bodies) {
    flex_total += static_cast<std::size_t>(2 * body.layout.stride());
    scratch_total += body.layout.axial + body.layout.bending;
  }
  work.storage = ArenaVector<double>(flex_total, 0.0, arena);
  work.scratch = ArenaVector<Double2>(scratch_total, Double2{}, arena);
  double* next = work.storage.data();
  Double2* next_scratch = work.scratch.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const FlexLayout& layout = data.bodies[j].layout;
    work.bodies[j].W_theta = std::exchange(next, next + layout.stride());
    work.bodies[j].z = std::exchange(next, next + layout.stride());
    work.bodies[j].scratch =
        std::exchange(next_scratch, next_scratch + layout.axial + layout.bending);
  }
}

}  // namespace spoke::structured
