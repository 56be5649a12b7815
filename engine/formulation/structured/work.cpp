// Memory of the formulation, per subsystem.

#include <utility>

#include "engine/formulation/structured.h"

namespace spoke::structured {

template <class World>
void allocate(const SubsystemData<World>& data, SubsystemWork<World>& work) {
  Arena& arena = *data.arena;
  work.bodies = ArenaVector<BodyWork<World>>(data.bodies.size(), arena);
  constexpr int kFlexVectors = 1 + BodyTypes<World>::kCouplings;  // z, W_theta
  std::size_t flex_total = BodyTypes<World>::Layout::kPad;
  std::size_t scratch_total = 0;
  for (const BodyData<World>& body : data.bodies) {
    flex_total += static_cast<std::size_t>(kFlexVectors * body.layout.stride());
    scratch_total += body.layout.scratch_size();
  }
  work.storage = ArenaVector<double>(flex_total, 0.0, arena);
  work.scratch = ArenaVector<Double2>(scratch_total, Double2{}, arena);
  double* next = work.storage.data();
  Double2* next_scratch = work.scratch.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const auto& layout = data.bodies[j].layout;
    BodyWork<World>& body = work.bodies[j];
    for (double*& W : body.W_theta) W = std::exchange(next, next + layout.stride());
    body.z = std::exchange(next, next + layout.stride());
    body.scratch = std::exchange(next_scratch, next_scratch + layout.scratch_size());
  }
}

template void allocate(const SubsystemData<Plane>&, SubsystemWork<Plane>&);

}  // namespace spoke::structured
