// The order of a pass, and its nodes between motion_nodes.h and closing_nodes.h: what each reads,
// writes and calls.

#include "engine/step/step_graph_builder.h"

#include <algorithm>

#include "engine/formulation/tree_joints.h"
#include "engine/kernels/applied_forces.h"
#include "engine/kernels/blade_loads.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/hub_solve.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/load_terms.h"
#include "engine/kernels/planar_terms.h"
#include "engine/kernels/spatial_terms.h"
#include "engine/step/closing_nodes.h"
#include "engine/step/motion_nodes.h"
#include "engine/step/pass_integration.h"

// One pass of one blade of two bodies (structured and subsystem formulations), where the whole
// motion of the hub is prescribed:
//
//   hub motion -----------------+
//                               v
//   coordinates -> position -> velocity -+-> mass 1 -> inverse 1 -+-> effective -> multipliers
//                                        +-> mass 2 -> inverse 2 -+                 |
//   next pass's coordinates <- sensors <- finish <-+- recovery 1 <------------------+
//                                  |               +- recovery 2 <------------------+
//                                  +-> hub solve, once, behind all passes of all blades
//
// A load of the user's on the blade is a node between "velocity" and the "mass" of its bodies. One
// between blades is a node of no blade, and makes the passes of all blades one, as below.
//
// Nothing that a blade's next pass reads comes from another blade: the passes of a graph, and with
// them the steps of a window, are one chain for each blade, with its own progress. The hub solve
// only yields the reaction.
//
// Where the hub has a free coordinate, its acceleration is what the multipliers of all blades wait
// for, "hub solve" stands between "effective" and "multipliers", and "hub motion" and "finish" are
// nodes of the system. The same declarations then leave one pass after the other. The augmented
// formulation has one node, "solve", in place of those from "inverse" to "hub solve".
//
// The bodies of a blade meet in its position and velocity analysis, its effective inertia, its
// multipliers and its finish: the two layers of parallelism, and the window as the third, are what
// the declarations leave unordered.

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::StepGraphBuilder;
using graph::writes;

/// Whether a body's joint has coordinates, whose accelerations then are among those of the body.
template <class World>
bool has_coordinates(const TreeBody<World>& body) {
  return joint_coordinates(body) > 0;
}

/// Whether condensing a body clears rows of its terms: those of coordinates that a chord frame
/// fixes.
bool clears_rows(const TreeBody<Space>& body) {
  const space::FlexibleBody* flexible = body.body->flexible();
  return flexible && flexible->reference_frame == ReferenceFrame::chord;
}

/// What a body's terms read: only what its options make them depend on.
template <class World>
PartList terms_inputs(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& blade = g.blade(i);
  const TreeBody<World>& member = g.c.system.subsystems[i].bodies[j];
  PartList inputs{blade.progress, blade.bodies[j].coordinates, blade.twists};
  if (std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method)) {
    inputs.push_back(blade.bodies[j].history);  // q_elastic, v_elastic
    if (has_coordinates(member) || !blade.bodies[j].tension.empty())
      inputs.push_back(blade.bodies[j].accelerations);
  }
  const PartList loads = loads_on(g, i, j);
  inputs.insert(inputs.end(), loads.begin(), loads.end());
  const SubsystemData<World>& data = g.c.data.subsystems[i];
  const bool flies = data.flight_acceleration && member.stiffening;
  const bool has_rising_gravity = g.c.system.gravity_ramp > 0.0;
  bool needs_rotations = has_rising_gravity;
  if (member.stiffening) {
    const BodyData<World>& body = data.bodies[j];
    if (body.forces.carried && !has_slide(member)) inputs.push_back(blade.applied_forces);
    needs_rotations |= body.forces.applied;
  }
  // The tension, on either side of the equations.
  bool needs_hub = has_rising_gravity || static_cast<bool>(member.stiffening);
  if (has_slide(member)) inputs.push_back(blade.applied_forces);
  if (flies) inputs.push_back(g.parts.flight_acceleration);
  for (const BodyLoad<World>& load : member.loads) {
    using Frame = decltype(load.frame);
    needs_rotations |= load.frame == Frame::hub || load.frame == Frame::inertial;
    needs_hub |= load.frame == Frame::inertial;
  }
  if (std::any_of(member.drags.begin(), member.drags.end(),
                  [](const BodyDrag<World>& drag) { return drag.relative_to == DragFrame::hub; })) {
    needs_hub = true;
    inputs.push_back(blade.drag_poses);
  }
  if (needs_rotations) inputs.push_back(blade.rotations);
  if (needs_hub) inputs.push_back(blade.hub_state);
  return inputs;
}

// The terms of a body and of what acts on it, by world.

void calc_mass_terms(const SystemContext<Plane>& c, int i, int j,
                     SubsystemData<Plane>& blade) noexcept {
  calc_terms(c.system, c.system.subsystems[i], blade.progress->control.time, j, blade);
}

void calc_mass_terms(const SystemContext<Space>& c, int i, int j,
                     SubsystemData<Space>& blade) noexcept {
  const PassControl& control = blade.progress->control;
  space::ImplicitShares shares;
  if (control.is_implicit) {
    const auto& alpha = std::get<GeneralizedAlpha>(c.integrator.method);
    shares = {alpha.position_gain, alpha.velocity_gain};
    if (control.begins_iteration()) follow_hub_speed(*blade.hub, blade.bodies[j]);
  }
  calc_terms(c.system, c.system.subsystems[i], control.time, shares, j, blade);
}

template <class World>
void add_mass(const Assembly<World>& g, int i, int j) {
  const SystemContext<World>& c = g.c;
  SubsystemData<World>& blade = g.c.data.subsystems[i];
  const BodyParts& parts = g.blade(i).bodies[j];
  PartList outputs{parts.terms};
  PartList inputs = terms_inputs(g, i, j);
  for (const PartId tension : parts.tension) {
    inputs.push_back(tension);  // it stays while the speed does
    outputs.push_back(tension);
    inputs.push_back(g.blade(i).rotations);  // with the frames' angular accelerations
  }
  if constexpr (tree::kHasJointCoordinates<World>) {
    inputs.push_back(parts.scratch);  // not all of it is overwritten
    outputs.push_back(parts.scratch);
  }
  g.builder.add_node(g.label("mass", i, j), reads(inputs), writes(outputs),
                     unless_halted(*blade.progress, [&c, &blade, i, j]() noexcept {
                       calc_mass_terms(c, i, j, blade);
                     }));
}

/// What condensing or inverting a body writes.
PartList inverse_outputs(const Assembly<Plane>& g, int i, int j) {
  const BodyParts& parts = g.blade(i).bodies[j];
  return {parts.inverse, parts.workspace};
}
PartList inverse_outputs(const Assembly<Space>& g, int i, int j) {
  const BodyParts& parts = g.blade(i).bodies[j];
  if (g.c.formulation != Formulation::structured) return {parts.inverse, parts.workspace};
  PartList outputs{parts.inverse, parts.port};
  if (clears_rows(g.c.system.subsystems[i].bodies[j])) outputs.push_back(parts.terms);
  return outputs;
}

template <class World>
void add_inverse(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& blade = g.blade(i);
  const BodyParts& parts = blade.bodies[j];
  PartList inputs{blade.progress, parts.coordinates, blade.twists, parts.terms};
  PartList outputs = inverse_outputs(g, i, j);
  if constexpr (tree::kHasJointCoordinates<World>) inputs.push_back(blade.rotations);  // handles
  inputs.insert(inputs.end(), parts.tension.begin(), parts.tension.end());
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const auto add = [&](auto invert, auto& work) {
    g.builder.add_node(g.label("inverse", i, j), reads(inputs), writes(outputs),
                       unless_halted(*data.progress, [&data, j, invert, &work]() noexcept {
                         invert(data.bodies[j], data.twists[j], data.progress->control.is_implicit,
                                work);
                       }));
  };
  if (g.c.formulation == Formulation::structured)
    return add(
        [](BodyData<World>& body, const TwistOf<World>& twist, bool implicit,
           structured::BodyWork<World>& work) noexcept {
          structured::condense_body(body, twist, implicit, work);
        },
        g.c.work.structured[i].bodies[j]);
  add(subsystem::invert_body<World>, g.c.work.subsystem[i].bodies[j]);
}

template <class World>
void add_effective(const Assembly<World>& g, int i) {
  const SubsystemParts& blade = g.blade(i);
  const auto inputs =
      reads(blade.progress, blade.all(&BodyParts::inverse), blade.all(&BodyParts::terms),
            blade.rotations, blade.hub_state, blade.ports);
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const auto add = [&](auto condense, auto& work, const graph::Writes& outputs) {
    g.builder.add_node(
        g.label("effective", i), inputs, outputs,
        unless_halted(*data.progress, [&subsystem, &data, condense, &work]() noexcept {
          condense(subsystem, data, work);
        }));
  };
  if (g.c.formulation == Formulation::structured)
    return add(structured::calc_effective_inertia<World>, g.c.work.structured[i],
               writes(blade.effective, blade.workspace, blade.joints(), blade.ports));
  add(subsystem::calc_effective_inertia<World>, g.c.work.subsystem[i],
      writes(blade.effective, blade.workspace));
}

/// What handing the hub's acceleration to the integrator reads.
template <class World>
PartList hub_inputs(const Assembly<World>& g) {
  PartList inputs{g.parts.progress, g.parts.hub_state, g.parts.hub_coordinates};
  if (corrects_hub(g)) inputs.push_back(g.parts.hub_history);
  return inputs;
}
/// What solving for the hub's acceleration writes.
template <class World>
PartList hub_outputs(const Assembly<World>& g) {
  PartList outputs{g.parts.hub_solution};
  if (!is_prescribed(g.c.system)) outputs.push_back(g.parts.hub_coordinates);
  return outputs;
}

template <class World>
void add_hub_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  g.builder.add_node(g.label("hub solve"),
                     reads(g.parts.all(&SubsystemParts::effective), hub_inputs(g)),
                     writes(hub_outputs(g)), unless_halted(c.data.progress[0], [&c]() noexcept {
                       solve_hub(c.system, c.data);
                       complete_hub(c.system, c.integrator.method, c.data);
                     }));
}

/// (P 9) where it only yields the reaction: once for all steps that are complete.
template <class World>
void add_prescribed_hub_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const StepParts& parts = g.parts;
  g.builder.add_node(
      {"hub solve"},
      reads(parts.all(&SubsystemParts::progress), parts.all(&SubsystemParts::records),
            parts.records, parts.hub_coordinates),
      writes(parts.records, parts.hub_coordinates),
      [&c]() noexcept { record_reactions(c.system, c.integrator, c.data); });
}

/// Where subsystems are shared out: lets all processes know what the subsystems of each have found
/// in these parts. Those of others are read as well, for not all of a part is told. `behind`: what
/// puts it behind another exchange, as all processes must make theirs in one order.
template <class World>
void add_share(const Assembly<World>& g, const char* stage, const PartList& parts,
               SharedPlaces& places, const PartList& behind = {}) {
  g.builder.add_node(g.label(stage), reads(g.parts.progress, parts, behind), writes(parts),
                     unless_halted(g.c.data.progress[0], [&places]() noexcept { places.share(); }));
}

template <class World>
void add_augmented_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const StepParts& parts = g.parts;
  PartList
      outboard_joints;  // their Jacobians depend on the deformation; inboard, nodes stand fixed
  PartList tensions;
  for (const SubsystemParts& blade : parts.subsystems) {
    for (std::size_t j = 0; j + 1 < blade.bodies.size(); ++j)
      outboard_joints.push_back(blade.bodies[j].coordinates);
    for (const BodyParts& body : blade.bodies)
      tensions.insert(tensions.end(), body.tension.begin(), body.tension.end());
  }
  g.builder.add_node(g.label("solve"),
                     reads(parts.all(&BodyParts::terms), outboard_joints, tensions,
                           parts.all(&SubsystemParts::rotations),
                           parts.all(&SubsystemParts::twists), hub_inputs(g)),
                     writes(parts.augmented_solution, hub_outputs(g)),
                     unless_halted(c.data.progress[0], [&c]() noexcept {
                       augmented::solve(c.system, c.data, c.work.augmented);
                       complete_hub(c.system, c.integrator.method, c.data);
                     }));
}

/// Multi-ports that recovery needs, and in space terms: forces of joints are among them. The tips'
/// ports are in the effective inertia already.
template <class World>
PartList inner_ports(const Assembly<World>& g, int i) {
  const SubsystemParts& blade = g.blade(i);
  if constexpr (tree::kHasJointCoordinates<World>) {
    PartList ports = blade.ports;
    for (const PartId terms : blade.all(&BodyParts::terms)) ports.push_back(terms);
    return ports;
  } else {
    PartList ports = blade.all(&BodyParts::inverse);
    ports.pop_back();
    return ports;
  }
}

/// Accelerations of joints, which rk4 finds in their place at once.
template <class World>
PartList found_with_multipliers(const Assembly<World>& g, int i) {
  PartList list;
  if (!std::holds_alternative<Rk4>(g.c.integrator.method)) return list;
  const std::vector<TreeBody<World>>& bodies = g.c.system.subsystems[i].bodies;
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (has_coordinates(bodies[j])) list.push_back(g.blade(i).bodies[j].accelerations);
  return list;
}

template <class World>
void add_multipliers(const Assembly<World>& g, int i) {
  SystemContext<World>& c = g.c;
  const SubsystemParts& blade = g.blade(i);
  const Subsystem<World>& subsystem = c.system.subsystems[i];
  SubsystemData<World>& data = c.data.subsystems[i];
  const PartList accelerations = found_with_multipliers(g, i);
  const auto add = [&](const graph::Reads& inputs, auto recover) {
    g.builder.add_node(g.label("multipliers", i), inputs, writes(blade.wrenches, accelerations),
                       unless_halted(*data.progress, recover));
  };
  switch (c.formulation) {
    case Formulation::structured:
      return add(reads(blade.progress, blade.effective, blade.joints(), inner_ports(g, i),
                       blade.rotations, blade.hub_state, blade.hub_acceleration, accelerations),
                 [&subsystem, &data, &work = c.work.structured[i]]() noexcept {
                   structured::recover_wrenches(subsystem, work, data);
                 });
    case Formulation::subsystem:
      return add(reads(blade.progress, blade.effective, blade.rotations, blade.hub_acceleration,
                       accelerations),
                 [&subsystem, &data, &work = c.work.subsystem[i]]() noexcept {
                   subsystem::recover_wrenches(subsystem, work, data);
                 });
    case Formulation::augmented:
      return add(reads(blade.progress, g.parts.augmented_solution, blade.rotations, accelerations),
                 [i, &subsystem, &data, &work = c.work.augmented]() noexcept {
                   augmented::recover_wrenches(i, subsystem, work, data);
                 });
  }
}

/// What a recovery reads and writes.
struct RecoveryAccess {
  PartList inputs;
  PartList outputs;
};
template <class World>
RecoveryAccess recovery_access(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& blade = g.blade(i);
  const BodyParts& body = blade.bodies[j];
  PartList inputs{blade.progress, body.coordinates};  // checked, and by generalized_alpha corrected
  PartList outputs{body.accelerations, body.report};
  if (g.c.formulation == Formulation::augmented) {
    inputs.push_back(g.parts.augmented_solution);
  } else {
    inputs.push_back(blade.wrenches);
    inputs.push_back(body.inverse);
  }
  if constexpr (tree::kHasJointCoordinates<World>) {
    const TreeBody<World>& model = g.c.system.subsystems[i].bodies[j];
    if (g.c.formulation == Formulation::structured) {
      for (const PartId part : {blade.rotations, body.terms, body.scratch}) inputs.push_back(part);
      inputs.insert(inputs.end(), body.tension.begin(), body.tension.end());
      outputs.push_back(body.scratch);
    }
    if (has_coordinates(model)) inputs.push_back(blade.wrenches);  // found with them
    if (model.joint.joint.driven > 0)
      for (const PartId part : {blade.rotations, blade.wrenches}) inputs.push_back(part);
    if (std::holds_alternative<Rk4>(g.c.integrator.method) && has_coordinates(model))
      inputs.push_back(body.accelerations);
  }
  if (std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method)) {
    inputs.push_back(body.history);
    inputs.push_back(body.accelerations);
    outputs.push_back(body.coordinates);
  }
  return {inputs, outputs};
}

template <class World>
void add_recovery(const Assembly<World>& g, int i, int j) {
  SystemContext<World>& c = g.c;
  SubsystemData<World>& blade = c.data.subsystems[i];
  const Method& method = c.integrator.method;
  const auto add = [&](auto recover) {
    const auto [inputs, outputs] = recovery_access(g, i, j);
    g.builder.add_node(g.label("recovery", i, j), reads(inputs), writes(outputs),
                       unless_halted(*blade.progress, [&blade, &method, j, recover]() noexcept {
                         BodyData<World>& body = blade.bodies[j];
                         recover(body);
                         report_drives(static_cast<std::size_t>(j), blade);
                         complete_body(method, blade.progress->control, body);
                       }));
  };
  switch (c.formulation) {
    case Formulation::structured:
      return add(
          [&blade, j, &work = c.work.structured[i].bodies[j]](BodyData<World>& body) noexcept {
            structured::recover_body(blade, static_cast<std::size_t>(j), work,
                                     blade.progress->control.is_implicit, body, body.a_found);
          });
    case Formulation::subsystem:
      return add(
          [&blade, j, &work = c.work.subsystem[i].bodies[j]](BodyData<World>& body) noexcept {
            subsystem::recover_body(blade, static_cast<std::size_t>(j), work, body, body.a_found);
          });
    case Formulation::augmented:
      return add([i, j, &work = c.work.augmented](BodyData<World>& body) noexcept {
        augmented::recover_body(i, j, work, body, body.a_found);
      });
  }
}
template <class World>
void add_motion(const Assembly<World>& g, int i) {
  if (!g.c.data.is_coupled) add_prescribed_hub_motion(g, i);
  add_coordinates(g, i);
  add_position(g, i);
  add_velocity(g, i);
}

/// From the masses to the inverses, or to the effective inertia where there is one.
template <class World>
void add_condensation(const Assembly<World>& g, int i) {
  const int bodies = static_cast<int>(g.blade(i).bodies.size());
  for (int j = 0; j < bodies; ++j) add_mass(g, i, j);
  if (g.c.formulation == Formulation::augmented) return;
  for (int j = 0; j < bodies; ++j) add_inverse(g, i, j);
  add_effective(g, i);
}

template <class World>
void add_recoveries(const Assembly<World>& g, int i) {
  const int bodies = static_cast<int>(g.blade(i).bodies.size());
  add_multipliers(g, i);
  for (int j = 0; j < bodies; ++j) add_recovery(g, i, j);
}

/// Subsystems whose nodes a graph has, and how they let other processes know; null: not.
struct Extent {
  int first = 0, last = 0;
  Sharing* sharing = nullptr;
};

template <class World>
void add_coupled_pass(const Assembly<World>& g, const Extent& own) {
  const auto for_each = [&](auto add) {
    for (int i = own.first; i < own.last; ++i) add(g, i);
  };
  add_hub_motion(g);
  for_each(add_motion<World>);
  for_each(add_loads_of_user<World>);  // which may be between blades
  for_each(add_applied_forces<World>);
  if (own.sharing && own.sharing->forces) {
    PartList forces;
    for (std::size_t i = 0; i < g.parts.subsystems.size(); ++i)
      if (!g.c.data.subsystems[i].applied_forces.empty())
        forces.push_back(g.parts.subsystems[i].applied_forces);
    add_share(g, "share forces", forces, *own.sharing->forces);
  }
  add_flight_acceleration(g);
  for_each(add_condensation<World>);
  if (own.sharing) {
    const PartList behind =
        own.sharing->forces ? PartList{g.parts.flight_acceleration} : PartList{};
    add_share(g, "share inertias", g.parts.all(&SubsystemParts::effective), own.sharing->inertias,
              behind);
  }
  if (g.c.formulation == Formulation::augmented)
    add_augmented_solve(g);
  else
    add_hub_solve(g);
  for_each(add_recoveries<World>);
  if (own.sharing) {
    PartList reports = g.parts.all(&BodyParts::report);
    for (const PartId terms : g.parts.all(&BodyParts::terms)) reports.push_back(terms);
    add_share(g, "share reports", reports, own.sharing->reports);
  }
  add_finish(g);
  for_each(add_sensors<World>);
}

template <class World>
void add_pass_of_blade(const Assembly<World>& g, int i) {
  add_motion(g, i);
  add_loads_of_user(g, i);
  add_applied_forces(g, i);
  add_condensation(g, i);
  add_recoveries(g, i);
  add_subsystem_finish(g, i);
  add_sensors(g, i);
}

template <class World>
graph::StepGraph build(SystemContext<World>& c, int passes, const Extent& own) {
  StepGraphBuilder builder("blade");
  const StepParts parts = add_parts(c, builder);
  Assembly<World> g{c, parts, builder, passes > 1 ? 0 : -1};
  if (c.data.is_coupled)
    add_coupled_pass(g, own);
  else
    for (int i = own.first; i < own.last; ++i) add_pass_of_blade(g, i);
  // The progress says what the nodes are to do: those of all passes are the same.
  const int nodes = builder.node_count();
  for (int pass = 1; pass < passes; ++pass)
    for (int n = 0; n < nodes; ++n) builder.repeat_node({n}, pass);
  // Of shared subsystems the hub's reaction is found when all are at the end of the window.
  if (!c.data.is_coupled && !own.sharing) add_prescribed_hub_solve(g);
  return builder.build();
}

template <class World>
Extent extent_of_all(const SystemContext<World>& c) {
  return {0, static_cast<int>(c.data.subsystems.size()), nullptr};
}

}  // namespace

template <class World>
graph::StepGraph build_step_graph(SystemContext<World>& c, int passes) {
  Sharing* const sharing = c.sharing.get();
  if (!sharing) return build(c, passes, extent_of_all(c));
  return build(c, passes, {sharing->own_first(), sharing->own_last(), sharing});
}

template <class World>
graph::StepGraph SystemContext<World>::build_graph(int passes) {
  return build_step_graph(*this, passes);
}

template <class World>
graph::StepGraph SystemContext<World>::build_whole_graph() {
  return build(*this, 1, extent_of_all(*this));
}

template graph::StepGraph build_step_graph(SystemContext<Plane>&, int);
template graph::StepGraph SystemContext<Plane>::build_graph(int);
template graph::StepGraph SystemContext<Plane>::build_whole_graph();
template graph::StepGraph build_step_graph(SystemContext<Space>&, int);
template graph::StepGraph SystemContext<Space>::build_graph(int);
template graph::StepGraph SystemContext<Space>::build_whole_graph();

}  // namespace spoke
