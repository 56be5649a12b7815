// Declares what these nodes read and write, by formulation, and adds them.

#include "engine/step/loop_nodes.h"

#include "engine/bodies/kernels/loop_motion.h"
#include "engine/step/formulation/loops.h"

namespace spoke {
namespace {

using graph::PartId;
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

/// Returns the part of the table that has a body's response to wrenches on its handles.
template <class World>
PartId response_of(const Assembly<World>& g, int i, int body) {
  const BodyParts& parts = g.subsystem(i).bodies[body];
  const bool has_port =
      tree::kHasJointCoordinates<World> && g.c.formulation == Formulation::structured;
  return has_port ? parts.port : parts.inverse;
}

/// Returns the bodies that carry places of a loop, each once.
std::vector<int> bodies_of(const LoopModel& loop) {
  std::vector<int> bodies{loop.from.body};
  const bool has_other = loop.to.carrier == LoopPlace::Carrier::body;
  if (has_other && loop.to.body != loop.from.body) bodies.push_back(loop.to.body);
  return bodies;
}

/// Returns the parts that a loop's columns read.
template <class World>
PartList column_inputs(const Assembly<World>& g, int i, std::size_t k) {
  const SubsystemParts& own = g.subsystem(i);
  const LoopModel& loop = g.c.system.subsystems[i].loops[k];
  PartList inputs{own.progress, own.loops.motion, own.rotations, own.effective};
  if (g.c.formulation != Formulation::structured) {
    inputs.push_back(own.workspace);
    for (const int body : bodies_of(loop)) inputs.push_back(response_of(g, i, body));
    return inputs;
  }
  // The bias of a planar root depends on the hub's speed.
  if (!tree::kHasJointCoordinates<World>) inputs.push_back(own.hub_state);
  const LoopPath& path = g.c.data.subsystems[i].loops.paths[k];
  for (const int body : path.bodies) inputs.push_back(response_of(g, i, body));
  for (const LoadedJoint& joint : path.joints) inputs.push_back(own.bodies[joint.child].joint);
  return inputs;
}

/// Returns the parts, besides the columns of all loops, that the matrix of all is made of.
template <class World>
PartList factor_inputs(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const std::vector<LoopModel>& loops = g.c.system.subsystems[i].loops;
  PartList inputs{own.progress, own.loops.motion, own.effective};
  std::vector<bool> is_taken(own.bodies.size(), false);
  for (const LoopModel& loop : loops)
    for (const int body : bodies_of(loop)) is_taken[body] = true;
  for (std::size_t j = 0; j < is_taken.size(); ++j)
    if (is_taken[j]) inputs.push_back(response_of(g, i, static_cast<int>(j)));
  return inputs;
}

template <class World>
void add_columns(const Assembly<World>& g, int i, std::size_t k) {
  const SubsystemParts& own = g.subsystem(i);
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  PartList outputs{own.loops.columns[k]};
  if (!own.loops.scratch.empty()) outputs.push_back(own.loops.scratch[k]);
  const auto add_node = [&](auto calculate) {
    g.builder.add_node(g.label_item(stages::kLoopColumns, i, subsystem.loops[k].name),
                       reads(column_inputs(g, i, k)), writes(outputs),
                       unless_halted(*data.progress, calculate));
  };
  if (g.c.formulation == Formulation::structured)
    return add_node([&subsystem, k, &data, &work = g.c.work.structured[i]]() noexcept {
      structured::calc_loop_columns(subsystem, k, work, data);
    });
  add_node([&subsystem, k, &data, &work = g.c.work.subsystem[i]]() noexcept {
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
void add_loop_factor(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  if (own.loops.is_empty()) return;
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) add_columns(g, i, k);
  PartList inputs = factor_inputs(g, i);
  graph::add_to(inputs, own.loops.columns);
  const auto add_node = [&](auto fill) {
    g.builder.add_node(g.label(stages::kLoopFactor, i), reads(inputs),
                       updates(own.loops.first_pivots),  // they stay but at the start
                       writes(own.loops.factor, own.effective),
                       unless_halted(*data.progress, [fill, &data]() noexcept {
                         fill();
                         factorise_loops(data);
                       }));
  };
  if (g.c.formulation == Formulation::structured)
    return add_node([&subsystem, &data, &work = g.c.work.structured[i]]() noexcept {
      structured::fill_loop_matrix(subsystem, work, data);
    });
  add_node([&subsystem, &data, &work = g.c.work.subsystem[i]]() noexcept {
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
  PartList inputs{own.progress, own.loops.motion};
  PartList outputs{own.loops.report, own.loops.factor};
  const auto add_node = [&](auto find) {
    g.builder.add_node(g.label(stages::kLoopForces, i), reads(inputs), writes(outputs),
                       unless_halted(*data.progress, [find, &subsystem, &table, &data]() noexcept {
                         find();
                         report_loops(subsystem, table.length, data);
                       }));
  };
  if (c.formulation == Formulation::augmented) {
    inputs.push_back(g.parts().augmented_solution);
    return add_node([i, &data, &work = c.work.augmented]() noexcept {
      augmented::take_loop_forces(i, work, data);
    });
  }
  inputs.push_back(own.loops.factor);
  inputs.push_back(own.loops.first_pivots);
  inputs.push_back(own.hub_acceleration);
  inputs.push_back(own.effective);
  outputs.push_back(own.effective);
  graph::add_to(inputs, own.loops.columns);
  if (c.formulation == Formulation::structured) {
    graph::add_to(inputs, own.joints());
    graph::add_to(outputs, own.joints());
    return add_node([&data, &work = c.work.structured[i]]() noexcept {
      calc_loop_forces(data);
      structured::load_joints_by_loops(data, work);
    });
  }
  add_node([&subsystem, &data, &work = c.work.subsystem[i]]() noexcept {
    calc_loop_forces(data);
    subsystem::load_joints_by_loops(subsystem, data, work);
  });
}

template void add_loop_motion(const Assembly<Plane>&, int);
template void add_loop_factor(const Assembly<Plane>&, int);
template void add_loop_forces(const Assembly<Plane>&, int);
template void add_loop_motion(const Assembly<Space>&, int);
template void add_loop_factor(const Assembly<Space>&, int);
template void add_loop_forces(const Assembly<Space>&, int);

}  // namespace spoke
