// Sums the forces that are applied to the bodies of a chain, from the tip to the root.

#include "engine/bodies/kernels/applied_forces.h"

#include "engine/bodies/kernels/plane/section_loads.h"

namespace spoke {

void calc_applied_forces(const System<Plane>&, std::size_t i, double t,
                         StepData<Plane>& table) noexcept {
  SubsystemData<Plane>& data = table.subsystems[i];
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    Position& sum = data.applied_forces[j];
    sum.setZero();
    plane::visit_forces(t, static_cast<int>(j), data,
                        [&sum](const plane::Section&, const Position& force) { sum += force; });
  }
  for (std::size_t j = data.bodies.size() - 1; j > 0; --j)
    data.applied_forces[j - 1] += data.applied_forces[j];
  data.applied_forces.back() = data.applied_forces.front();
}

PartList parts_of_applied_forces(std::size_t i, const StepData<Plane>& table) {
  const SubsystemData<Plane>& data = table.subsystems[i];
  PartList list;
  for (std::size_t j = 0; j < data.bodies.size(); ++j)
    graph::add_to(list, loads_on(i, j, table), plane::parts_of_forces(j, data));
  return list;
}

}  // namespace spoke
