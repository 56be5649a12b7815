// Allocates table and formulation for a system.

#include "engine/step/step_context.h"

#include "engine/kernels/hub_motion.h"

namespace spoke {
namespace {

/// Shares of Mff and K in the constant block of an implicit step: Mhat = Mff + beta' h^2 K +
/// gamma' h D, with Rayleigh damping D.
ElasticShares implicit_shares(const Method& method, const Damping& damping) {
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  if (!alpha) return {};
  return {1.0 + alpha->velocity_gain * damping.mass_factor,
          alpha->position_gain + alpha->velocity_gain * damping.stiffness_factor};
}

}  // namespace

template <class World>
void allocate(SystemContext<World>& context, int window_steps) {
  const Method& method = context.integrator.method;
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  const int history = alpha ? int{GeneralizedAlpha::count} : int{Rk4::count};
  StepData<World>& data = context.data;
  const bool is_coupled = context.formulation == Formulation::augmented ||
                          !is_prescribed(context.system) || context.loads_tie_blades;
  allocate(context.system, {history, is_coupled, window_steps, context.linear_range}, data);
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      CoordinateBlock& block = body.coordinates;
      body.q_elastic = alpha ? block.history[GeneralizedAlpha::predicted_q] : block.q;
      body.v_elastic = alpha ? block.history[GeneralizedAlpha::predicted_v] : block.v;
      if (!alpha) body.a_found = block.a;
    }
  allocate(context.system, context.formulation, implicit_shares(method, context.system.damping),
           data, context.work);
  data.hub_coordinates.v[World::kAxial] = calc_initial_speed(context.system.hub.drive);
  impose_hub_motion(context.system, 0.0, data.hub_coordinates);
}

template void allocate(SystemContext<Plane>&, int);

}  // namespace spoke
