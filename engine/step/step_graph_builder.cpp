// The order of a pass, and those of its nodes between motion_nodes.h and solution_nodes.h, the
// terms of the bodies: the parts that each reads and writes, and the kernel that it calls.

#include "engine/step/step_graph_builder.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/bodies/kernels/modal_damping.h"
#include "engine/bodies/kernels/plane/table_terms.h"
#include "engine/bodies/kernels/space/fetch_ahead.h"
#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/step/closing_nodes.h"
#include "engine/step/loops/loop_nodes.h"
#include "engine/step/motion_nodes.h"
#include "engine/step/solution_nodes.h"
#include "engine/step/tile_nodes.h"

// One pass of one subsystem of two bodies (structured and subsystem formulations), where the whole
// motion of the hub is prescribed:
//
//   hub motion -----------------+
//                               v
//   coordinates -> position -> velocity -+-> mass 1 -> inverse 1 -+-> effective -> multipliers
//                                        +-> mass 2 -> inverse 2 -+                 |
//   next pass's coordinates <- sensors <- finish <-+- recovery 1 <------------------+
//                                  |               +- recovery 2 <------------------+
//                                  +-> hub solve, once, behind all passes of all subsystems
//
// Closed loops add "loop motion" behind "velocity", a node "loop columns" for each loop and "loop
// factor" behind "effective", and "loop forces" before "multipliers". The hub does not see them,
// unless they are between subsystems: these have "shared loop motion" behind "loop motion" of all
// subsystems, and "hub solve" solves for their forces. The passes of all subsystems are one then.
//
// Actors (engine/bodies/table/actor.h) add nodes in two places. Controllers of a subsystem are a
// node "control" before all of these, which changes nothing but in the first pass of a step;
// "velocity" follows it. A load of the user's is a node between "velocity" and the "mass" of its
// bodies, and so is "air"; "finish" keeps the states that they have reached. A load between
// subsystems is a node of no subsystem, and makes the passes of all subsystems one, as below.
//
// Nothing that a subsystem's next pass reads comes from another subsystem: the passes of a graph,
// and with them the steps of a window, are one chain for each subsystem, with its own progress. The
// hub solve only yields the reaction.
//
// Where the hub has a free coordinate, the multipliers of all subsystems wait for its acceleration,
// "hub solve" stands between "effective" and "multipliers", and "hub motion" and "finish" are nodes
// of the system. The same declarations then leave one pass after the other. The augmented
// formulation has one node, "solve", in place of those from "inverse" to "hub solve".
//
// Of a solid in slices (engine/step/tile_nodes.h) "mass" waits for a node "mass tile" for each
// slice, "inverse" for its nodes "forward", and behind "recovery" come its nodes "backward" and one
// "completion".
//
// The bodies of a subsystem meet in its position and velocity analysis, its effective inertia, its
// multipliers and its finish: the two layers of parallelism, and the window as the third, are what
// the declarations leave unordered.

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::StepGraphBuilder;
using graph::updates;
using graph::writes;

// Calculate the terms of a body and of all that acts on it, by world.

void calc_mass_terms(const SystemContext<Plane>& c, int i, int j,
                     SubsystemData<Plane>& data) noexcept {
  const PassControl& control = data.progress->control;
  BodyData<Plane>& body = data.bodies[j];
  if (body.strain && control.begins_iteration())
    follow_strain(*body.model->body, body.coordinates.q, *body.strain);
  calc_terms(c.system, c.system.subsystems[i], control.time, j, data);
  if (!body.strain || !control.is_implicit) return;
  const plane::FrameShare share =
      add_implicit_strain(*body.strain, body.coordinates.a, body.alpha, body.c_theta, body.Q_f);
  body.terms.rotary_inertia += share.inertia;
  angular(body.terms.Q) += share.moment;
}

/// Returns the share of its secant that friction's slope is at least in a pass: 0 in the first two
/// of a step, and where velocities change by little against those over which it sets in; then 1,
/// from the twelfth on ever less, since secants lead there slowly.
double choose_secant(const GeneralizedAlpha& alpha, const StepProgress& progress,
                     const space::Joint& joint) {
  constexpr double kNear = 0.1;
  constexpr int kTangents = 2, kSecants = 12;
  const int pass = progress.control.stage;
  if (pass < kTangents) return 0.0;
  double speed = std::numeric_limits<double>::infinity();
  for (const space::JointPrimitive& primitive : joint.sequence())
    if (primitive.friction.acts()) speed = std::min(speed, primitive.friction.speed);
  if (progress.change * alpha.velocity_gain < kNear * speed * alpha.position_gain) return 0.0;
  return pass < kSecants ? 1.0 : 1.0 / (1.0 + 0.5 * (pass - kSecants + 1));
}

void calc_mass_terms(const SystemContext<Space>& c, int i, int j,
                     SubsystemData<Space>& data) noexcept {
  const PassControl& control = data.progress->control;
  space::ImplicitShares shares;
  if (control.is_implicit) {
    const auto& alpha = std::get<GeneralizedAlpha>(c.integrator.method);
    BodyData<Space>& body = data.bodies[j];
    shares = {alpha.position_gain, alpha.velocity_gain,
              choose_secant(alpha, *data.progress, body.model->joint.joint)};
    if (control.begins_iteration()) body.kind->follow_state(*data.hub, body);
  }
  calc_terms(c.system, c.system.subsystems[i], control.time, shares, j, data);
}

/// Returns the parts that they and the damping by modes depend on.
template <class World>
PartList parts_of_mass(const SystemContext<World>& c, std::size_t i, std::size_t j) {
  const SubsystemData<World>& data = c.data.subsystems[i];
  const bool has_implicit = std::holds_alternative<GeneralizedAlpha>(c.integrator.method);
  PartList list{data.parts.progress};
  graph::add_to(list, parts_of_terms(c.system, i, j, has_implicit, c.data),
                parts_of_modal_damping(j, data));
  const BodyParts& own = data.parts.bodies[j];
  if (own.tension.index >= 0)  // for the frame's angular acceleration; for implicit strain
    list.push_back(tree::kHasJointCoordinates<World> ? data.parts.rotations : own.accelerations);
  return list;
}

template <class World>
void add_mass(const Assembly<World>& g, int i, int j) {
  const SystemContext<World>& c = g.c;
  SubsystemData<World>& data = g.c.data.subsystems[i];
  const BodyParts& parts = g.subsystem(i).bodies[j];
  add_mass_tiles(g, i, j);
  // Loads add to the rows of tiles; tension stays while the speed does.
  PartList changed = parts.tiles;
  graph::add_to(changed, graph::maybe(parts.tension));
  if constexpr (tree::kHasJointCoordinates<World>)
    changed.push_back(parts.scratch);  // not all of it is overwritten
  g.builder.add_node(g.label(stages::kMass, i, j), reads(parts_of_mass(c, i, j)), updates(changed),
                     writes(parts.terms, parts.power),
                     unless_halted(*data.progress, [&c, &data, i, j]() noexcept {
                       fetch_for_terms(data, static_cast<std::size_t>(j));
                       calc_mass_terms(c, i, j, data);
                       BodyData<World>& body = data.bodies[static_cast<std::size_t>(j)];
                       if (!body.model->modal.is_empty())
                         add_modal_damping(data.modal_forces, body);
                     }));
}

/// Adds the node, where subsystems are shared out, that lets all processes know the results of the
/// subsystems of each in these parts. Those of others are read as well, for not all of a part is
/// told. `behind`: parts that put it behind another exchange, as all processes must make theirs in
/// one order.
template <class World>
void add_share(const Assembly<World>& g, const char* stage, const PartList& parts,
               SharedPlaces& places, const PartList& behind = {}) {
  g.builder.add_node(g.label(stage), reads(g.parts().progress, behind), updates(parts),
                     unless_halted(g.c.data.progress[0], [&places]() noexcept { places.share(); }));
}

template <class World>
void add_motion(const Assembly<World>& g, int i) {
  if (!g.c.data.is_coupled) add_prescribed_hub_motion(g, i);
  add_coordinates(g, i);
  add_position(g, i);
  add_velocity(g, i);
  add_loop_motion(g, i);
}

/// Adds the nodes from the masses to the inverses, or to the effective inertia where there is one.
template <class World>
void add_condensation(const Assembly<World>& g, int i) {
  const int bodies = static_cast<int>(g.subsystem(i).bodies.size());
  for (int j = 0; j < bodies; ++j) add_mass(g, i, j);
  if (g.c.formulation == Formulation::augmented) return;
  for (int j = 0; j < bodies; ++j) {
    add_forward(g, i, j);
    add_inverse(g, i, j);
  }
  add_effective(g, i);
  add_loop_factor(g, i);
}

template <class World>
void add_recoveries(const Assembly<World>& g, int i) {
  const int bodies = static_cast<int>(g.subsystem(i).bodies.size());
  add_loop_forces(g, i);
  add_multipliers(g, i);
  for (int j = 0; j < bodies; ++j) {
    add_recovery(g, i, j);
    add_backward(g, i, j);
  }
}

/// Subsystems whose nodes a graph has, and the way in which they let other processes know; null:
/// none.
struct Extent {
  int first = 0, last = 0;
  Sharing* sharing = nullptr;
};

template <class World>
void add_coupled_pass(const Assembly<World>& g, const Extent& own) {
  // Each process goes through the supports, and through its own subsystems on hubs. A support comes
  // behind the one that carries it.
  const std::vector<int> supports = find_supports(g.c.system);
  const auto for_supports = [&](auto add) {
    for (const int i : supports) add(g, i);
  };
  const auto for_others = [&](auto add) {
    for (int i = own.first; i < own.last; ++i)
      if (!carries_rotor(g.c.system, i)) add(g, i);
  };
  const auto for_each = [&](auto add) {
    for_others(add);
    for_supports(add);
  };
  for_each(
      [](const Assembly<World>& pass, int i) { add_actors(pass, PassPlace::before_motion, i); });
  add_hub_motion(g);
  for_supports([](const Assembly<World>& pass, int i) {
    add_motion(pass, i);
    for (const int r : find_rotors_on(pass.c.system, i)) add_rotor_motion(pass, r);
  });
  for_others(add_motion<World>);
  add_shared_loop_motion(g);
  for_each([](const Assembly<World>& pass, int i) { add_actors(pass, PassPlace::on_motion, i); });
  for_each(add_applied_forces<World>);
  if (own.sharing && own.sharing->forces) {
    PartList forces;
    for (std::size_t i = 0; i < g.c.data.subsystems.size(); ++i)
      if (!g.c.data.subsystems[i].applied_forces.empty())
        forces.push_back(g.c.data.subsystems[i].parts.applied_forces);
    add_share(g, stages::kShareForces, forces, *own.sharing->forces);
  }
  add_flight_acceleration(g);
  for_others(add_condensation<World>);
  if (own.sharing) {
    const PartList behind =
        own.sharing->forces ? PartList{g.parts().flight_acceleration} : PartList{};
    PartList inertias;
    for (int i = 0; std::cmp_less(i, g.c.data.subsystems.size()); ++i)
      if (!carries_rotor(g.c.system, i)) inertias.push_back(g.subsystem(i).effective);
    add_share(g, stages::kShareInertias, inertias, own.sharing->inertias, behind);
  }
  for (auto i = supports.rbegin(); i != supports.rend(); ++i) {
    for (const int r : find_rotors_on(g.c.system, *i)) add_rotor_sum(g, r);
    add_condensation(g, *i);
  }
  if (g.c.formulation == Formulation::augmented)
    add_augmented_solve(g);
  else
    add_hub_solve(g);
  for_supports(add_recoveries<World>);
  for_others(add_recoveries<World>);
  if (own.sharing) {
    PartList reports = all_of(g, &BodyParts::report);
    graph::add_to(reports, all_of(g, &BodyParts::power));
    add_share(g, stages::kShareReports, reports, own.sharing->reports);
  }
  add_finish(g);
  for_each(add_sensors<World>);
}

template <class World>
void add_pass_of_subsystem(const Assembly<World>& g, int i) {
  add_actors(g, PassPlace::before_motion, i);
  add_motion(g, i);
  add_actors(g, PassPlace::on_motion, i);
  add_applied_forces(g, i);
  add_condensation(g, i);
  add_recoveries(g, i);
  add_subsystem_finish(g, i);
  add_sensors(g, i);
}

template <class World>
graph::StepGraph build(SystemContext<World>& c, int passes, const Extent& own) {
  assert(passes >= 1 && own.first >= 0 && own.first <= own.last);
  assert(std::cmp_less_equal(own.last, c.data.subsystems.size()));
  StepGraphBuilder builder(c.data.names);
  c.data.all_parts.share_with(builder);
  const Assembly<World> g{{builder, step_size(c.integrator), passes > 1 ? 0 : -1}, c};
  if (c.data.is_coupled)
    add_coupled_pass(g, own);
  else
    for (int i = own.first; i < own.last; ++i) add_pass_of_subsystem(g, i);
  // The progress controls the nodes: those of all passes are the same.
  const int nodes = builder.node_count();
  for (int pass = 1; pass < passes; ++pass)
    for (int n = 0; n < nodes; ++n) builder.repeat_node({n}, pass);
  // The hub's reaction on shared subsystems is found when all are at the end of the window.
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
