// Declares what these nodes read and write, by formulation, and adds them.

#include "engine/step/loops/loop_nodes.h"

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/step/formulation/loops/shared_loops.h"

namespace spoke {
namespace {

using graph::reads;
using graph::updates;
using graph::writes;

/// Returns how much of springs and closures a pass leaves to the unknown accelerations.
ClosureGains gains_of(const Method& method, const PassControl& control) {
  const auto* alpha = std::get_if<GeneralizedAlpha>(&method);
  if (const auto* rk4 = std::get_if<Rk4>(&method)) {
    ClosureGains gains;
    if (control.stage == Rk4::kClosing) gains.opening = 1.0 / (rk4->step * rk4->step);
    if (control.stage == Rk4::kBraking) gains.rate = 1.0 / rk4->step;
    return gains;
  }
  if (!control.is_implicit) return {};
  return {alpha->position_gain, alpha->velocity_gain, control.stage == PassControl::kRestart};
}

template <class World>
void add_columns(const Assembly<World>& g, int i, std::size_t k) {
  const SubsystemParts& own = g.subsystem(i);
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  PartList outputs{own.loops.columns[k]};
  if (!own.loops.scratch.empty()) outputs.push_back(own.loops.scratch[k]);
  const auto add_node = [&](const PartList& inputs, auto calculate) {
    g.builder.add_node(g.label_item(stages::kLoopColumns, i, subsystem.loops[k].name),
                       reads(own.progress, inputs), writes(outputs),
                       unless_halted(*data.progress, calculate));
  };
  if (g.c.formulation == Formulation::structured)
    return add_node(structured::parts_of_loop_columns(subsystem, k, data),
                    [&subsystem, k, &data, &work = g.c.work.structured[i]]() noexcept {
                      structured::calc_loop_columns(subsystem, k, work, data);
                    });
  add_node(subsystem::parts_of_loop_columns(subsystem, k, data),
           [&subsystem, k, &data, &work = g.c.work.subsystem[i]]() noexcept {
             subsystem::calc_loop_columns(subsystem, k, work, data);
           });
}

}  // namespace

template <class World>
void add_loop_motion(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  if (own.loops.is_empty()) return;
  SystemContext<World>& c = g.c;
  const bool has_implicit = std::holds_alternative<GeneralizedAlpha>(c.integrator.method);
  const auto index = static_cast<std::size_t>(i);
  SubsystemData<World>& data = c.data.subsystems[i];
  g.builder.add_node(g.label(stages::kLoopMotion, i),
                     reads(own.progress, parts_of_loop_motion(index, has_implicit, c.data)),
                     updates(own.loops.motion),  // frames' accelerations are of implicit passes
                     unless_halted(*data.progress, [&c, &data, index]() noexcept {
                       const PassControl& control = data.progress->control;
                       calc_loop_motion(c.system, index, control.time,
                                        gains_of(c.integrator.method, control), c.data);
                     }));
}

template <class World>
void add_shared_loop_motion(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  if (c.system.shared_loops.empty()) return;
  const bool has_implicit = std::holds_alternative<GeneralizedAlpha>(c.integrator.method);
  const auto [inputs, outputs] = parts_of_shared_motion(has_implicit, c.data);
  g.builder.add_node(g.label(stages::kSharedLoopMotion), reads(g.parts().progress, inputs),
                     updates(outputs), unless_halted(c.data.progress[0], [&c]() noexcept {
                       const PassControl& control = c.data.progress[0].control;
                       calc_shared_motion(c.system, control.time,
                                          gains_of(c.integrator.method, control), c.data);
                     }));
}

template <class World>
void add_loop_factor(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  if (own.loops.is_empty()) return;
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) add_columns(g, i, k);
  const auto index = static_cast<std::size_t>(i);
  const PartList handed_up = parts_of_handed_up(g.c.system, index, g.c.data);
  const auto add_node = [&](const PartList& inputs, auto fill) {
    g.builder.add_node(g.label(stages::kLoopFactor, i), reads(own.progress, inputs, handed_up),
                       updates(own.loops.first_pivots),  // they stay but at the start
                       writes(own.loops.factor, own.effective),
                       unless_halted(*data.progress, [fill, index, &c = g.c, &data]() noexcept {
                         fill();
                         add_handed_up(c.system, index, c.data);
                         factorise_loops(data);
                       }));
  };
  if (g.c.formulation == Formulation::structured)
    return add_node(structured::parts_of_loop_matrix(subsystem, data),
                    [&subsystem, &data, &work = g.c.work.structured[i]]() noexcept {
                      structured::fill_loop_matrix(subsystem, work, data);
                    });
  add_node(subsystem::parts_of_loop_matrix(subsystem, data),
           [&subsystem, &data, &work = g.c.work.subsystem[i]]() noexcept {
             subsystem::fill_loop_matrix(subsystem, work, data);
           });
}

template <class World>
void add_loop_forces(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  if (own.loops.is_empty()) return;
  SystemContext<World>& c = g.c;
  const Subsystem<World>& subsystem = c.system.subsystems[i];
  SubsystemData<World>& data = c.data.subsystems[i];
  const StepData<World>& table = c.data;
  PartList outputs{own.loops.report, own.loops.factor};
  const auto add_node = [&](const PartList& inputs, auto find) {
    g.builder.add_node(g.label(stages::kLoopForces, i),
                       reads(own.progress, own.loops.motion, inputs), writes(outputs),
                       unless_halted(*data.progress, [find, &subsystem, &table, &data]() noexcept {
                         find();
                         report_loops(subsystem, table.length, data);
                       }));
  };
  if (c.formulation == Formulation::augmented)
    return add_node(augmented::parts_of_loop_forces(table),
                    [i, &data, &work = c.work.augmented]() noexcept {
                      augmented::take_loop_forces(i, work, data);
                    });
  outputs.push_back(own.effective);
  PartList inputs = parts_of_loop_forces(data);
  if (c.formulation == Formulation::structured) {
    graph::add_to(inputs, structured::parts_of_loaded_joints(data));
    graph::add_to(outputs, own.joints());
    return add_node(inputs, [&subsystem, &data, &work = c.work.structured[i]]() noexcept {
      calc_loop_forces(data);
      structured::load_joints_by_loops(subsystem, data, work);
    });
  }
  graph::add_to(inputs, subsystem::parts_of_loaded_joints(data));
  add_node(inputs, [&subsystem, &data, &work = c.work.subsystem[i]]() noexcept {
    calc_loop_forces(data);
    subsystem::load_joints_by_loops(subsystem, data, work);
  });
}

template void add_loop_motion(const Assembly<Plane>&, int);
template void add_shared_loop_motion(const Assembly<Plane>&);
template void add_loop_factor(const Assembly<Plane>&, int);
template void add_loop_forces(const Assembly<Plane>&, int);
template void add_loop_motion(const Assembly<Space>&, int);
template void add_shared_loop_motion(const Assembly<Space>&);
template void add_loop_factor(const Assembly<Space>&, int);
template void add_loop_forces(const Assembly<Space>&, int);

}  // namespace spoke
