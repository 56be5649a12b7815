// Declares what the node reads and writes, and adds it.

#include "engine/step/control_nodes.h"

#include "engine/kernels/pitch_control.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::writes;

/// Returns the part in which the speed of a hub is that a drive does not prescribe.
template <class World>
PartList speed_inputs(const Assembly<World>& g, int i) {
  const System<World>& system = g.c.system;
  const int r = system.subsystems[static_cast<std::size_t>(i)].rotor;
  if (prescribes_motion(drive_of(system))) return {};
  if (r < 0) return {g.parts().hub_coordinates};
  const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(r)];
  return {g.subsystem(rotor.subsystem).bodies[static_cast<std::size_t>(rotor.body)].coordinates};
}

/// Returns the speed of the hub about its axle at the end of a step, at time t [s], before the
/// nodes of the next step: against what carries the axle [rad/s].
template <class World>
double hub_speed(const SystemContext<World>& c, std::size_t i, double t) {
  const System<World>& system = c.system;
  const int r = system.subsystems[i].rotor;
  const Drive& drive = drive_of(system);
  if (prescribes_motion(drive)) return calc_motion(drive, t).speed;
  if constexpr (tree::kHasJointCoordinates<World>)
    if (r >= 0) {
      const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(r)];
      return c.data.subsystems[static_cast<std::size_t>(rotor.subsystem)]
          .bodies[static_cast<std::size_t>(rotor.body)]
          .joint.coordinates.v[0];
    }
  return c.data.hub_coordinates.v[World::kAxial];
}

/// Lets the controllers of a subsystem take their samples, if it is time for any.
template <class World>
void control_subsystem(const SystemContext<World>& c, std::size_t i,
                       SubsystemData<World>& data) noexcept {
  const StepProgress& progress = *data.progress;
  if (progress.control.is_between_steps() || progress.passes > 0) return;
  const std::int64_t before = progress.step - 1;
  const double h = step_size(c.integrator);
  const double t = static_cast<double>(before) * h;
  for (std::size_t k = 0; k < data.controls.size(); ++k) {
    const PitchControl& control = c.system.subsystems[i].controls[k];
    const std::int64_t steps = count_sample_steps(control, h);
    if (before % steps == 0)
      take_sample(control, hub_speed(c, i, t), t, static_cast<double>(steps) * h, before == 0,
                  data.controls[k]);
  }
}

}  // namespace

template <class World>
PartList controls_of(const Assembly<World>& g, int i) {
  if (g.c.data.subsystems[static_cast<std::size_t>(i)].controls.empty()) return {};
  return {g.subsystem(i).controls};
}

template <class World>
void add_control(const Assembly<World>& g, int i) {
  const auto index = static_cast<std::size_t>(i);
  SubsystemData<World>& data = g.c.data.subsystems[index];
  if (data.controls.empty()) return;
  const SystemContext<World>& c = g.c;
  g.builder.add_node(g.label(stages::kControl, i),
                     reads(g.subsystem(i).progress, speed_inputs(g, i), controls_of(g, i)),
                     writes(controls_of(g, i)),
                     unless_halted(*data.progress, [&c, &data, index]() noexcept {
                       control_subsystem(c, index, data);
                     }));
}

template PartList controls_of(const Assembly<Plane>&, int);
template void add_control(const Assembly<Plane>&, int);
template PartList controls_of(const Assembly<Space>&, int);
template void add_control(const Assembly<Space>&, int);

}  // namespace spoke
