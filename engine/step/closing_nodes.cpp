// Declares what these nodes read and write, and adds them.

#include "engine/step/closing_nodes.h"

#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loop_motion.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/joint_values.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/step/formulation/loops.h"
#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::updates;

/// Returns the parts that keeping the loads of the joints reads.
template <class World>
PartList joint_load_inputs(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  PartList inputs{own.wrenches, own.rotations};
  if (!own.loops.is_empty())
    for (const PartId part : {own.loops.motion, own.loops.factor}) inputs.push_back(part);
  if (!g.c.system.subsystems[i].bodies.front().stiffening) return inputs;
  inputs.push_back(own.hub_acceleration);
  for (const PartId terms : own.all(&BodyParts::terms)) inputs.push_back(terms);
  return inputs;
}

/// Returns the parts that the scenario's sensors read beyond the places, twists and loads of joints
/// of the subsystem.
PartList reading_inputs(const Assembly<Plane>& g, int i) {
  PartList inputs;
  const std::vector<Reading<Plane>>& readings = g.c.data.subsystems[i].readings;
  const auto add = [&inputs](const PartList& list) { graph::add_to(inputs, list); };
  for (const Reading<Plane>& reading : readings) {
    const bool is_root = reading.body == 0 && reading.section.x == 0.0;
    const bool is_load = reading.quantity == SensorQuantity::section_force && !is_root;
    const bool is_accelerated = is_load || reading.quantity == SensorQuantity::acceleration;
    const bool feels_hub = is_load || reading.frame == SensorFrame::inertial;
    if (is_load) add(loads_on(static_cast<std::size_t>(i), reading.body, g.c.data));
    if (!is_accelerated) continue;
    for (int j = 0; j <= reading.body; ++j)
      inputs.push_back(g.subsystem(i).bodies[static_cast<std::size_t>(j)].accelerations);
    if (feels_hub && g.c.data.is_coupled) inputs.push_back(g.parts().hub_coordinates);
  }
  return inputs;
}

PartList reading_inputs(const Assembly<Space>& g, int i) {
  PartList inputs;
  const auto add = [&inputs](const PartList& list) { graph::add_to(inputs, list); };
  for (const Reading<Space>& reading : g.c.data.subsystems[i].readings) {
    const bool is_load = reading.quantity == SensorQuantity::section_force && !reading.is_root();
    if (is_load) add(loads_on(static_cast<std::size_t>(i), reading.body(), g.c.data));
    if (!is_load && !is_accelerated(reading)) continue;
    for (const int j : reading.path)
      inputs.push_back(g.subsystem(i).bodies[static_cast<std::size_t>(j)].accelerations);
    if (g.c.data.is_coupled && g.c.system.subsystems[i].rotor < 0)
      inputs.push_back(g.parts().hub_coordinates);
  }
  return inputs;
}

/// Adds the states of actors that the end of a step keeps: those reached, and those kept.
template <class World>
void list_states(const SubsystemData<World>& data, PartList& reached, PartList& kept) {
  for (const auto& pair : data.delayed) {
    reached.push_back(pair->reached_part);
    kept.push_back(pair->kept_part);
  }
}

/// Return the parts that calculating a sample writes besides it: spatial kernels share the
/// workspaces.
PartList sample_outputs(const Assembly<Plane>&, int) { return {}; }
PartList sample_outputs(const Assembly<Space>& g, int i) {
  return g.subsystem(i).all(&BodyParts::scratch);
}

void keep_readings(const SystemContext<Plane>& c, std::size_t i, std::int64_t step,
                   StepData<Plane>& table) {
  if (!table.subsystems[i].readings.empty())
    calc_readings(c.system, i, step, static_cast<double>(step) * step_size(c.integrator), table);
}
void keep_readings(const SystemContext<Space>& c, std::size_t i, std::int64_t step,
                   StepData<Space>& table) {
  SubsystemData<Space>& own = table.subsystems[i];
  const double t = static_cast<double>(step) * step_size(c.integrator);
  if (own.reading_count > 0) keep_own_values(step, t, own);
  if (!own.readings.empty()) calc_readings(c.system, i, step, t, table);
}

}  // namespace

template <class World>
void add_finish(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const SystemParts& parts = g.parts();
  const bool is_corrected = corrects_hub(g);
  PartList outputs{parts.progress, parts.records}, supports;
  for (std::size_t r = 0; r < parts.rotors.size(); ++r) {
    const SubsystemParts& support = g.subsystem(c.system.rotors[r].subsystem);
    graph::add_to(outputs, parts.rotors[r].hub, support.rotations, support.twists);
    supports.push_back(support.wrenches);
    for (const auto member : {&BodyParts::coordinates, &BodyParts::accelerations})
      for (const PartId part : support.all(member)) supports.push_back(part);
  }
  PartList reports;
  for (std::size_t i = 0; i < c.data.subsystems.size(); ++i) {
    const SubsystemParts& own = c.data.subsystems[i].parts;
    if (!own.loops.is_empty()) reports.push_back(own.loops.report);
    list_states(c.data.subsystems[i], reports, outputs);
  }
  if (is_corrected) outputs.push_back(parts.hub_state);
  g.builder.add_node(
      g.label(stages::kFinish),
      reads(supports, reports, all_of(g, &BodyParts::report), all_of(g, &BodyParts::power),
            parts.hub_solution, parts.hub_state, parts.hub_coordinates),
      updates(outputs), [&c, is_corrected]() noexcept {
        StepProgress& progress = c.data.progress[0];
        if (progress.is_halted) {
          progress.completed = StepProgress::kNone;
          return;
        }
        finish_system(c.system, c.integrator, c.data);
        if (progress.completed < 0) return;
        for (SubsystemData<World>& subsystem : c.data.subsystems) keep_states(subsystem);
        // The sensors need it: the last correction has moved the hub once more.
        if (is_corrected) c.data.hub = calc_hub_state(c.data);
        const double t = static_cast<double>(progress.completed) * step_size(c.integrator);
        update_rotors(c.system, t, c.data);
        record_rotor(c.system, t, c.data, of_step(c.data.records, progress.completed));
      });
}

template <class World>
void add_subsystem_finish(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const Integrator& integrator = g.c.integrator;
  const Window& window = g.c.data.window;
  SubsystemData<World>& data = g.c.data.subsystems[i];
  PartList reports, states;
  if (!own.loops.is_empty()) reports.push_back(own.loops.report);
  list_states(data, reports, states);
  g.builder.add_node(g.label(stages::kFinish, i),
                     reads(reports, own.all(&BodyParts::report), own.all(&BodyParts::power),
                           own.effective, own.hub_state),
                     updates(own.progress, own.records, states),
                     [&hub = g.c.system.hub, &integrator, &window, &data]() noexcept {
                       if (data.progress->is_halted)
                         data.progress->completed = StepProgress::kNone;
                       else
                         finish_subsystem<World>(hub, integrator, window, data);
                       if (data.progress->completed >= 0) keep_states(data);
                     });
}

template <class World>
void add_sensors(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const SystemContext<World>& c = g.c;
  StepData<World>& table = g.c.data;
  SubsystemData<World>& data = table.subsystems[i];
  const bool is_corrected = std::holds_alternative<GeneralizedAlpha>(c.integrator.method);
  PartList outputs{own.poses, own.samples, own.joint_loads};
  if (data.reading_count > 0) outputs.push_back(own.readings);
  for (const PartId part : sample_outputs(g, i)) outputs.push_back(part);
  if (!own.loops.is_empty()) outputs.push_back(own.loops.motion);
  PartList shown;
  for (const auto& actor : table.actors) actor->list_shown(i, shown);
  const PartList inputs{own.rotations, own.twists};
  if (is_corrected) graph::add_to(outputs, inputs);
  g.builder.add_node(g.label(stages::kSensors, i),
                     reads(own.progress, own.all(&BodyParts::coordinates), own.hub_state, inputs,
                           joint_load_inputs(g, i), reading_inputs(g, i), shown),
                     updates(outputs), [&c, &table, &data, i, is_corrected]() noexcept {
                       const std::int64_t step = data.progress->completed;
                       if (step < 0) return;
                       const auto index = static_cast<std::size_t>(i);
                       const Subsystem<World>& subsystem = c.system.subsystems[index];
                       keep_joint_loads(subsystem, data);
                       keep_loop_loads(data);
                       if (!table.window.observed) return;
                       if (is_corrected) update_kinematics(subsystem, data);
                       const double t = static_cast<double>(step) * step_size(c.integrator);
                       update_loops(c.system, index, t, table);
                       sample_subsystem(c.system, index, step, table);
                       keep_readings(c, index, step, table);
                     });
}

template void add_finish(const Assembly<Plane>&);
template void add_subsystem_finish(const Assembly<Plane>&, int);
template void add_sensors(const Assembly<Plane>&, int);
template void add_finish(const Assembly<Space>&);
template void add_subsystem_finish(const Assembly<Space>&, int);
template void add_sensors(const Assembly<Space>&, int);

}  // namespace spoke
