// What is applied to the bodies of a tree in space.

#include "engine/kernels/applied_forces.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/spatial_terms.h"

namespace spoke {

void calc_applied_forces(const System<Space>& system, std::size_t i, double t,
                         StepData<Space>& table) noexcept {
  const Subsystem<Space>& subsystem = system.subsystems[i];
  SubsystemData<Space>& data = table.subsystems[i];
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    space::Position& sum = data.applied_forces[j];
    sum.setZero();
    visit_forces(t, subsystem, data, j,
                 [&sum](const space::Section&, const space::Position& force) { sum += force; });
  }
  sum_up_forces(data);
}

}  // namespace spoke
