// Declares what these nodes read and write, and adds them.

#include "engine/step/closing_nodes.h"

#include <algorithm>

#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/joint_values.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/step/formulation/loops/loops.h"
#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::updates;

/// Adds the states of actors that the end of a step keeps: those reached, and those kept.
template <class World>
void list_states(const SubsystemData<World>& data, PartList& reached, PartList& kept) {
  for (const auto& pair : data.delayed) {
    reached.push_back(pair->reached_part);
    kept.push_back(pair->kept_part);
  }
}

/// Whether a loop of subsystem `i` closes on an anchor beside the axle.
template <class World>
bool closes_beside_axle(const System<World>& system, std::size_t i) {
  const std::vector<LoopModel>& loops = system.subsystems[i].loops;
  return std::any_of(loops.begin(), loops.end(), [&system](const LoopModel& loop) {
    return stands_beside_axle(system, loop.to);
  });
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
  if (own.reading_count > 0) keep_own_values(i, step, t, table);
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
    graph::add_to(outputs, parts.rotors[r].hub, parts.rotors[r].records, support.rotations,
                  support.twists);
    supports.push_back(support.wrenches);
    // Joints of the support may follow controllers, see update_rotors().
    graph::add_to(supports,
                  courses_of(static_cast<std::size_t>(c.system.rotors[r].subsystem), c.data));
    for (const auto member : {&BodyParts::coordinates, &BodyParts::accelerations})
      for (const PartId part : support.all(member)) supports.push_back(part);
  }
  PartList reports;
  for (std::size_t i = 0; i < c.data.subsystems.size(); ++i) {
    const SubsystemParts& own = c.data.subsystems[i].parts;
    if (!own.loops.is_empty()) reports.push_back(own.loops.report);
    if (closes_beside_axle(c.system, i))  // see record_rotors()
      graph::add_to(reports, own.loops.motion, own.loops.factor, own.rotations, own.twists);
    list_states(c.data.subsystems[i], reports, outputs);
  }
  if (is_corrected) outputs.push_back(parts.hub_state);
  for (const int i : c.data.shared_loops.visited) {  // see update_shared_loops()
    const SubsystemParts& own = g.subsystem(i);
    graph::add_to(outputs, own.loops.motion, own.rotations, own.twists);
    graph::add_to(reports, own.all(&BodyParts::coordinates));
  }
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
        record_rotors(c.system, t, progress.completed, c.data);
        update_shared_loops(c.system, t, c.data);
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
  // Places elsewhere, see calc_readings().
  if (const std::vector<int>& visited = table.shared_loops.visited;
      std::find(visited.begin(), visited.end(), i) != visited.end())
    for (const int other : visited)
      if (const SubsystemParts& there = g.subsystem(other); other != i)
        graph::add_to(shown, there.loops.motion, there.rotations, there.twists,
                      there.all(&BodyParts::coordinates));
  for (const auto& actor : table.actors) actor->list_shown(i, shown);
  const PartList inputs{own.rotations, own.twists};
  if (is_corrected) graph::add_to(outputs, inputs);
  g.builder.add_node(g.label(stages::kSensors, i),
                     reads(own.progress, own.all(&BodyParts::coordinates), own.hub_state, inputs,
                           parts_of_joint_loads(data), parts_of_loop_loads(data),
                           parts_of_readings(static_cast<std::size_t>(i), table), shown),
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
