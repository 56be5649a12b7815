// Declares what these nodes read and write, by formulation, and adds them.

#include "engine/step/solution_nodes.h"

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/space/fetch_ahead.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/step/formulation/loops/shared_loops.h"
#include "engine/step/formulation/tree_joints.h"
#include "engine/step/pass_integration.h"
#include "engine/step/recovery_end.h"
#include "engine/step/tile_nodes.h"

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::updates;
using graph::writes;

/// Return the parts that condensing or inverting a body writes.
PartList inverse_outputs(const Assembly<Plane>& g, int i, int j) {
  const BodyParts& parts = g.subsystem(i).bodies[j];
  return {parts.inverse, parts.workspace};
}
PartList inverse_outputs(const Assembly<Space>& g, int i, int j) {
  const BodyParts& parts = g.subsystem(i).bodies[j];
  if (g.c.formulation != Formulation::structured) return {parts.inverse, parts.workspace};
  PartList outputs{parts.inverse, parts.port};
  const space::Body& body = *g.c.system.subsystems[i].bodies[j].body;
  if (kind_of(body).clears_rows(body)) outputs.push_back(parts.terms);
  return outputs;
}

/// Returns the parts that solving for the hub's acceleration writes.
template <class World>
PartList hub_outputs(const Assembly<World>& g) {
  PartList outputs{g.parts().hub_solution};
  if (!is_prescribed(g.c.system)) outputs.push_back(g.parts().hub_coordinates);
  return outputs;
}

/// Returns the accelerations of joints, which rk4 finds in their place at once.
template <class World>
PartList found_with_multipliers(const Assembly<World>& g, int i) {
  PartList list;
  if (!std::holds_alternative<Rk4>(g.c.integrator.method)) return list;
  const std::vector<TreeBody<World>>& bodies = g.c.system.subsystems[i].bodies;
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (has_coordinates(bodies[j])) list.push_back(g.subsystem(i).bodies[j].accelerations);
  return list;
}

/// Adds the node of the frame's acceleration of a body in slices, and of its accelerations between
/// these.
template <class World>
void add_recovery_between(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& own = g.subsystem(i);
  const BodyParts& body = own.bodies[j];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  auto& work = g.c.work.structured[i].bodies[j];
  g.builder.add_node(
      g.label(stages::kRecovery, i, j),
      reads(own.progress, own.wrenches, own.rotations, body.inverse), updates(body.accelerations),
      writes(body.solution.back()), unless_halted(*data.progress, [&data, j, &work]() noexcept {
        BodyData<World>& member = data.bodies[j];
        structured::recover_body(data, static_cast<std::size_t>(j), work,
                                 data.progress->control.is_implicit, member, member.a_found);
      }));
}

}  // namespace

template <class World>
void add_inverse(const Assembly<World>& g, int i, int j) {
  const SubsystemParts& own = g.subsystem(i);
  const BodyParts& parts = own.bodies[j];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const auto index = static_cast<std::size_t>(j);
  PartList outputs = inverse_outputs(g, i, j);
  // Of a solid in one slice all is done here.
  if (!slices_of(data.bodies[j])) graph::add_to(outputs, parts.halves);
  const auto add = [&](const PartList& inputs, auto invert, auto& work) {
    g.builder.add_node(
        g.label(stages::kInverse, i, j), reads(own.progress, inputs), writes(outputs),
        unless_halted(*data.progress, [&data, j, invert, &work]() noexcept {
          invert(data.bodies[j], data.twists[j], data.progress->control.is_implicit, work);
        }));
  };
  if (g.c.formulation == Formulation::structured)
    return add(
        structured::parts_of_condensed(index, data),
        [](BodyData<World>& body, const TwistOf<World>& twist, bool implicit,
           structured::BodyWork<World>& work) noexcept {
          structured::condense_body(body, twist, implicit, work);
        },
        g.c.work.structured[i].bodies[j]);
  add(subsystem::parts_of_inverted(index, data), subsystem::invert_body<World>,
      g.c.work.subsystem[i].bodies[j]);
}

template <class World>
void add_effective(const Assembly<World>& g, int i) {
  const SubsystemParts& own = g.subsystem(i);
  const auto inputs = reads(own.progress, own.all(&BodyParts::inverse), own.all(&BodyParts::terms),
                            own.rotations, own.hub_state, own.ports());
  const Subsystem<World>& subsystem = g.c.system.subsystems[i];
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const auto add = [&](auto condense, auto& work, const graph::Writes& outputs) {
    g.builder.add_node(
        g.label(carries_rotor(g.c.system, i) ? stages::kSupportEffective : stages::kEffective, i),
        inputs, outputs,
        unless_halted(*data.progress, [&subsystem, &data, condense, &work]() noexcept {
          condense(subsystem, data, work);
        }));
  };
  if (g.c.formulation == Formulation::structured)
    return add(structured::calc_effective_inertia<World>, g.c.work.structured[i],
               writes(own.effective, own.workspace, own.joints(), own.ports()));
  add(subsystem::calc_effective_inertia<World>, g.c.work.subsystem[i],
      writes(own.effective, own.workspace));
}

template <class World>
void add_rotor_sum(const Assembly<World>& g, int r) {
  const auto index = static_cast<std::size_t>(r);
  SystemContext<World>& c = g.c;
  const bool is_condensed = c.formulation != Formulation::augmented;
  PartList inputs = parts_of_rotor_sum(index, is_condensed, c.data), loops;
  if (is_condensed) {
    graph::add_to(inputs, parts_of_rows_on_hub(c.system, index, c.data));
    loops = parts_with_rows_on_hub(c.system, index, c.data);
  }
  g.builder.add_node(label_of_rotor(g, stages::kRotorSum, r), reads(g.parts().progress, inputs),
                     updates(g.parts().rotors[index].carried, loops),
                     unless_halted(c.data.progress[0], [&c, index, is_condensed]() noexcept {
                       sum_rotor(c.system, index, is_condensed, c.data);
                       if (is_condensed) put_rows_on_hub(c.system, index, c.data);
                     }));
}

template <class World>
void add_hub_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  g.builder.add_node(g.label(c.system.rotors.empty() ? stages::kHubSolve : stages::kSupportSolve),
                     reads(g.parts().progress, parts_of_hub_solution(c.data),
                           parts_of_completed_hub(c.system, c.integrator.method, c.data),
                           parts_of_shared_loops(c.data)),
                     updates(parts_with_shared_loops(c.data)), writes(hub_outputs(g)),
                     unless_halted(c.data.progress[0], [&c]() noexcept {
                       factorise_shared_loops(c.system, c.data);
                       solve_hub(c.system, c.data);
                       calc_shared_forces(c.system, c.data);
                       complete_hub(c.system, c.integrator.method, c.data);
                     }));
}

template <class World>
void add_prescribed_hub_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const SystemParts& parts = g.parts();
  g.builder.add_node(
      {"hub solve"},
      reads(all_of(g, &SubsystemParts::progress), all_of(g, &SubsystemParts::records),
            parts.records, parts.hub_coordinates),
      writes(parts.records, parts.hub_coordinates),
      [&c]() noexcept { record_reactions(c.system, c.integrator, c.data); });
}

template <class World>
void add_augmented_solve(const Assembly<World>& g) {
  SystemContext<World>& c = g.c;
  const SystemParts& parts = g.parts();
  g.builder.add_node(g.label(stages::kSolve),
                     reads(parts.progress, augmented::parts_of_solution(c.data),
                           parts_of_completed_hub(c.system, c.integrator.method, c.data)),
                     writes(parts.augmented_solution, hub_outputs(g)),
                     unless_halted(c.data.progress[0], [&c]() noexcept {
                       augmented::solve(c.system, c.data, c.work.augmented);
                       complete_hub(c.system, c.integrator.method, c.data);
                     }));
}

template <class World>
void add_multipliers(const Assembly<World>& g, int i) {
  SystemContext<World>& c = g.c;
  const SubsystemParts& own = g.subsystem(i);
  const Subsystem<World>& subsystem = c.system.subsystems[i];
  SubsystemData<World>& data = c.data.subsystems[i];
  const auto add = [&](const PartList& inputs, auto recover) {
    const bool has_loops = !own.loops.is_empty();
    g.builder.add_node(
        g.label(stages::kMultipliers, i), reads(own.progress, inputs, parts_of_loop_wrenches(data)),
        updates(found_with_multipliers(g, i)), writes(own.wrenches),
        unless_halted(*data.progress, [recover, has_loops, &subsystem, &data]() noexcept {
          recover();
          if (has_loops) put_loop_wrenches(subsystem, data);
        }));
  };
  switch (c.formulation) {
    case Formulation::structured:
      return add(structured::parts_of_wrenches(data),
                 [&subsystem, &data, &work = c.work.structured[i]]() noexcept {
                   structured::recover_wrenches(subsystem, work, data);
                 });
    case Formulation::subsystem:
      return add(subsystem::parts_of_wrenches(data),
                 [&subsystem, &data, &work = c.work.subsystem[i]]() noexcept {
                   subsystem::recover_wrenches(subsystem, work, data);
                 });
    case Formulation::augmented:
      return add(augmented::parts_of_wrenches(static_cast<std::size_t>(i), c.data),
                 [i, &subsystem, &data, &work = c.work.augmented]() noexcept {
                   augmented::recover_wrenches(i, subsystem, work, data);
                 });
  }
}

template <class World>
void add_recovery(const Assembly<World>& g, int i, int j) {
  SystemContext<World>& c = g.c;
  SubsystemData<World>& data = c.data.subsystems[i];
  const Method& method = c.integrator.method;
  const auto add = [&](auto recover) {
    const auto [inputs, outputs] = recovery_access(g, i, j);
    const char* stage = carries_rotor(g.c.system, i) ? stages::kSupportRecovery : stages::kRecovery;
    g.builder.add_node(g.label(stage, i, j), reads(inputs), writes(outputs),
                       unless_halted(*data.progress, [&data, &method, j, recover]() noexcept {
                         recover(data.bodies[j]);
                         complete_recovery(method, j, data);
                       }));
  };
  switch (c.formulation) {
    case Formulation::structured:
      if (slices_of(data.bodies[j])) return add_recovery_between(g, i, j);
      return add(
          [&data, j, &work = c.work.structured[i].bodies[j]](BodyData<World>& body) noexcept {
            fetch_for_recovery(data, static_cast<std::size_t>(j));
            structured::recover_body(data, static_cast<std::size_t>(j), work,
                                     data.progress->control.is_implicit, body, body.a_found);
          });
    case Formulation::subsystem:
      return add([&data, j, &work = c.work.subsystem[i].bodies[j]](BodyData<World>& body) noexcept {
        subsystem::recover_body(data, static_cast<std::size_t>(j), work, body, body.a_found);
      });
    case Formulation::augmented:
      return add([i, j, &work = c.work.augmented](BodyData<World>& body) noexcept {
        augmented::recover_body(i, j, work, body, body.a_found);
      });
  }
}

template void add_inverse(const Assembly<Plane>&, int, int);
template void add_effective(const Assembly<Plane>&, int);
template void add_hub_solve(const Assembly<Plane>&);
template void add_rotor_sum(const Assembly<Plane>&, int);
template void add_rotor_sum(const Assembly<Space>&, int);
template void add_prescribed_hub_solve(const Assembly<Plane>&);
template void add_augmented_solve(const Assembly<Plane>&);
template void add_multipliers(const Assembly<Plane>&, int);
template void add_recovery(const Assembly<Plane>&, int, int);
template void add_inverse(const Assembly<Space>&, int, int);
template void add_effective(const Assembly<Space>&, int);
template void add_hub_solve(const Assembly<Space>&);
template void add_prescribed_hub_solve(const Assembly<Space>&);
template void add_augmented_solve(const Assembly<Space>&);
template void add_multipliers(const Assembly<Space>&, int);
template void add_recovery(const Assembly<Space>&, int, int);

}  // namespace spoke
