#include "engine/step_graph_builder.h"

#include "engine/body_terms.h"
#include "engine/hub.h"
#include "engine/kinematics.h"
#include "engine/pass_ends.h"
#include "engine/step_parts.h"

// One pass, drawn for one blade of two bodies (structured and subsystem formulations):
//
//   hub motion ----------------+
//                              v
//   coordinates -> position -> velocity -+-> mass 1 -> inverse 1 -+-> effective -+-> hub solve
//                                        +-> mass 2 -> inverse 2 -+              |       |
//                                                           other blades --------+       |
//   finish <-+- recovery 1 <-+- multipliers <--------------------------------------------+
//            +- recovery 2 <-+
//
// Blades meet at the hub only, and the bodies of a blade only in its position and velocity
// analysis, its effective inertia and its multipliers: the two layers of parallelism are what the
// declarations leave unordered. The augmented formulation has one node, "solve", in place of those
// from "inverse" to "hub solve".

namespace spoke {
namespace {

using graph::PartId;
using graph::reads;
using graph::StepGraphBuilder;
using graph::writes;
using PartList = std::vector<PartId>;

void add_hub_motion(StepContext& c, const StepParts& parts, StepGraphBuilder& builder) {
  builder.add_node({"hub motion"}, reads(parts.hub_coordinates, parts.hub_history),
                   writes(parts.hub_coordinates, parts.hub_history, parts.hub_state),
                   [&c]() noexcept { begin_hub(c.system, c.method, c.data); });
}

void add_coordinates(StepContext& c, const SubsystemParts& blade, int i,
                     StepGraphBuilder& builder) {
  const PartList coordinates = blade.all(&BodyParts::coordinates);
  const PartList history = blade.all(&BodyParts::history);
  builder.add_node({"coordinates", i},
                   reads(coordinates, history, blade.all(&BodyParts::accelerations)),
                   writes(coordinates, history), [&c, i]() noexcept {
                     for (BodyData& body : c.data.subsystems[i].bodies)
                       begin_block(c.method, c.data.control, body.coordinates);
                   });
}

/// Coordinates that the kinematics of a chain read: of the tip body those of its inboard handle
/// only, which a clamped frame has none of.
PartList chain_coordinates(const StepContext& c, const SubsystemParts& blade, int i) {
  PartList list = blade.all(&BodyParts::coordinates);
  const FlexibleBody& tip = *c.system.subsystems[i].bodies.back().body;
  if (tip.inboard.coordinate[kRotation] < 0) list.pop_back();
  return list;
}

void add_position(StepContext& c, const SubsystemParts& blade, int i, StepGraphBuilder& builder) {
  builder.add_node(
      {"position", i}, reads(chain_coordinates(c, blade, i)), writes(blade.rotations),
      [&c, i]() noexcept { calc_rotations(c.system.subsystems[i], c.data.subsystems[i]); });
}

void add_velocity(StepContext& c, const StepParts& parts, const SubsystemParts& blade, int i,
                  StepGraphBuilder& builder) {
  builder.add_node({"velocity", i},
                   reads(chain_coordinates(c, blade, i), blade.rotations, parts.hub_state),
                   writes(blade.twists), [&c, i]() noexcept {
                     calc_velocities(c.system.subsystems[i], c.data.hub, c.data.subsystems[i]);
                   });
}

/// What a body's terms read: only what its options make them depend on.
PartList terms_inputs(const StepContext& c, const StepParts& parts, int i, int j) {
  const SubsystemParts& blade = parts.subsystems[i];
  const ChainBody& member = c.system.subsystems[i].bodies[j];
  PartList inputs{blade.bodies[j].coordinates, blade.twists};
  if (std::holds_alternative<GeneralizedAlpha>(c.method))
    inputs.push_back(blade.bodies[j].history);  // q_elastic, v_elastic
  bool needs_rotations = false;
  bool needs_hub = member.centrifugal_stiffness != nullptr;
  for (const NodeLoad& load : member.loads) {
    needs_rotations |= load.frame != LoadFrame::section;
    needs_hub |= load.frame == LoadFrame::inertial;
  }
  if (needs_rotations) inputs.push_back(blade.rotations);
  if (needs_hub) inputs.push_back(parts.hub_state);
  return inputs;
}

void add_mass(StepContext& c, const StepParts& parts, int i, int j, StepGraphBuilder& builder) {
  SubsystemData& blade = c.data.subsystems[i];
  const Twist& twist = blade.twists[j];
  BodyData& body = blade.bodies[j];
  builder.add_node(
      {"mass", i, j}, reads(terms_inputs(c, parts, i, j)),
      writes(parts.subsystems[i].bodies[j].terms), [&c, &blade, j, &twist, &body]() noexcept {
        calc_body_terms({twist[kRotation], c.data.hub.twist[kRotation]}, c.system.damping, body);
        if (!body.model->loads.empty())
          add_loads(c.data.control.time, calc_rotation_to_hub(blade, j), twist, c.data.hub.R, body);
      });
}

void add_inverse(StepContext& c, const SubsystemParts& blade, int i, int j,
                 StepGraphBuilder& builder) {
  const BodyParts& parts = blade.bodies[j];
  const auto inputs = reads(parts.coordinates, blade.twists, parts.terms);
  const PassControl& control = c.data.control;
  const Twist& twist = c.data.subsystems[i].twists[j];
  const BodyData& body = c.data.subsystems[i].bodies[j];
  if (c.formulation == Formulation::structured)
    builder.add_node({"inverse", i, j}, inputs, writes(parts.inverse),
                     [&control, &twist, &body, &work = c.work.structured[i].bodies[j]]() noexcept {
                       structured::condense_body(body, twist[kRotation], control, work);
                     });
  else
    builder.add_node({"inverse", i, j}, inputs, writes(parts.inverse),
                     [&control, &twist, &body, &work = c.work.subsystem[i].bodies[j]]() noexcept {
                       subsystem::invert_body(body, twist[kRotation], control, work);
                     });
}

void add_effective(StepContext& c, const StepParts& parts, const SubsystemParts& blade, int i,
                   StepGraphBuilder& builder) {
  const auto inputs = reads(blade.all(&BodyParts::inverse), blade.all(&BodyParts::terms),
                            blade.rotations, parts.hub_state);
  if (c.formulation == Formulation::structured)
    builder.add_node({"effective", i}, inputs, writes(blade.effective, blade.joints()),
                     [&c, i]() noexcept {
                       structured::condense_subsystem(c.system.subsystems[i], c.data.hub,
                                                      c.data.subsystems[i], c.work.structured[i]);
                     });
  else
    builder.add_node({"effective", i}, inputs, writes(blade.effective), [&c, i]() noexcept {
      subsystem::condense_subsystem(c.system.subsystems[i], c.data.hub, c.data.subsystems[i],
                                    c.work.subsystem[i]);
    });
}

/// What handing the hub's acceleration to the integrator reads.
PartList hub_inputs(const StepContext& c, const StepParts& parts) {
  PartList inputs{parts.hub_state, parts.hub_coordinates};
  if (std::holds_alternative<GeneralizedAlpha>(c.method)) inputs.push_back(parts.hub_history);
  return inputs;
}

void add_hub_solve(StepContext& c, const StepParts& parts, StepGraphBuilder& builder) {
  builder.add_node({"hub solve"},
                   reads(parts.all(&SubsystemParts::effective), hub_inputs(c, parts)),
                   writes(parts.hub_solution, parts.hub_coordinates), [&c]() noexcept {
                     solve_hub(c.system, c.data);
                     complete_hub(c.system, c.method, c.data);
                   });
}

void add_augmented_solve(StepContext& c, const StepParts& parts, StepGraphBuilder& builder) {
  PartList
      outboard_joints;  // their Jacobians depend on the deformation; inboard, nodes stand fixed
  for (const SubsystemParts& blade : parts.subsystems)
    for (std::size_t j = 0; j + 1 < blade.bodies.size(); ++j)
      outboard_joints.push_back(blade.bodies[j].coordinates);
  builder.add_node(
      {"solve"},
      reads(parts.all(&BodyParts::terms), outboard_joints, parts.all(&SubsystemParts::rotations),
            parts.all(&SubsystemParts::twists), hub_inputs(c, parts)),
      writes(parts.augmented_solution, parts.hub_solution, parts.hub_coordinates), [&c]() noexcept {
        augmented::solve(c.system, c.data, c.work.augmented);
        complete_hub(c.system, c.method, c.data);
      });
}

void add_multipliers(StepContext& c, const StepParts& parts, int i, StepGraphBuilder& builder) {
  const SubsystemParts& blade = parts.subsystems[i];
  switch (c.formulation) {
    case Formulation::structured: {
      PartList ports = blade.all(&BodyParts::inverse);
      ports.pop_back();  // the tip's two-port is in the effective inertia already
      builder.add_node({"multipliers", i},
                       reads(blade.effective, blade.joints(), ports, blade.rotations,
                             parts.hub_state, parts.hub_solution),
                       writes(blade.wrenches), [&c, i]() noexcept {
                         structured::recover_wrenches(c.system.subsystems[i], c.data.hub,
                                                      c.data.hub_solution, c.work.structured[i],
                                                      c.data.subsystems[i]);
                       });
      break;
    }
    case Formulation::subsystem:
      builder.add_node({"multipliers", i},
                       reads(blade.effective, blade.rotations, parts.hub_solution),
                       writes(blade.wrenches), [&c, i]() noexcept {
                         subsystem::recover_wrenches(c.system.subsystems[i], c.data.hub_solution,
                                                     c.work.subsystem[i], c.data.subsystems[i]);
                       });
      break;
    case Formulation::augmented:
      builder.add_node({"multipliers", i}, reads(parts.augmented_solution, blade.rotations),
                       writes(blade.wrenches), [&c, i]() noexcept {
                         augmented::recover_wrenches(i, c.work.augmented, c.data.subsystems[i]);
                       });
  }
}

/// What a recovery reads and writes.
struct RecoveryAccess {
  PartList inputs;
  PartList outputs;
};
RecoveryAccess recovery_access(const StepContext& c, const StepParts& parts, int i, int j) {
  const SubsystemParts& blade = parts.subsystems[i];
  const BodyParts& body = blade.bodies[j];
  PartList inputs{body.coordinates};  // checked, and by generalized_alpha corrected
  PartList outputs{body.accelerations, body.report};
  if (c.formulation == Formulation::augmented) {
    inputs.push_back(parts.augmented_solution);
  } else {
    inputs.push_back(blade.wrenches);
    inputs.push_back(body.inverse);
  }
  if (std::holds_alternative<GeneralizedAlpha>(c.method)) {
    inputs.push_back(body.history);
    inputs.push_back(body.accelerations);
    outputs.push_back(body.coordinates);
  }
  return {inputs, outputs};
}

/// Adds a recovery node; `recover` finds the accelerations by the chosen formulation.
template <class Recover>
void add_recovery(StepContext& c, const StepParts& parts, int i, int j, Recover recover,
                  StepGraphBuilder& builder) {
  const auto [inputs, outputs] = recovery_access(c, parts, i, j);
  builder.add_node({"recovery", i, j}, reads(inputs), writes(outputs),
                   [&c, &body = c.data.subsystems[i].bodies[j], recover]() noexcept {
                     recover(body);
                     complete_body(c.method, c.data.control, body);
                   });
}

void add_recovery(StepContext& c, const StepParts& parts, int i, int j, StepGraphBuilder& builder) {
  const HandleWrenches& wrenches = c.data.subsystems[i].wrenches[j];
  switch (c.formulation) {
    case Formulation::structured:
      return add_recovery(
          c, parts, i, j,
          [&wrenches, &control = c.data.control,
           &work = c.work.structured[i].bodies[j]](BodyData& body) noexcept {
            structured::recover_body(wrenches, work, control, body, body.a_found);
          },
          builder);
    case Formulation::subsystem:
      return add_recovery(
          c, parts, i, j,
          [&wrenches, &work = c.work.subsystem[i].bodies[j]](BodyData& body) noexcept {
            subsystem::recover_body(wrenches, work, body, body.a_found);
          },
          builder);
    case Formulation::augmented:
      return add_recovery(
          c, parts, i, j,
          [&work = c.work.augmented, i, j](BodyData& body) noexcept {
            augmented::recover_body(i, j, work, body, body.a_found);
          },
          builder);
  }
}

void add_finish(StepContext& c, const StepParts& parts, StepGraphBuilder& builder) {
  builder.add_node({"finish"},
                   reads(parts.all(&BodyParts::report), parts.all(&BodyParts::terms),
                         parts.hub_solution, parts.hub_state),
                   writes(parts.report), [&c]() noexcept { c.data.report = sum_reports(c.data); });
}

}  // namespace

graph::StepGraph build_step_graph(StepContext& c) {
  StepGraphBuilder builder("blade");
  const StepParts parts = add_parts(c, builder);
  const int blades = static_cast<int>(parts.subsystems.size());
  const auto bodies = [&](int i) { return static_cast<int>(parts.subsystems[i].bodies.size()); };
  const bool is_augmented = c.formulation == Formulation::augmented;

  add_hub_motion(c, parts, builder);
  for (int i = 0; i < blades; ++i) {
    const SubsystemParts& blade = parts.subsystems[i];
    add_coordinates(c, blade, i, builder);
    add_position(c, blade, i, builder);
    add_velocity(c, parts, blade, i, builder);
    for (int j = 0; j < bodies(i); ++j) add_mass(c, parts, i, j, builder);
    if (is_augmented) continue;
    for (int j = 0; j < bodies(i); ++j) add_inverse(c, blade, i, j, builder);
    add_effective(c, parts, blade, i, builder);
  }
  if (is_augmented)
    add_augmented_solve(c, parts, builder);
  else
    add_hub_solve(c, parts, builder);
  for (int i = 0; i < blades; ++i) {
    add_multipliers(c, parts, i, builder);
    for (int j = 0; j < bodies(i); ++j) add_recovery(c, parts, i, j, builder);
  }
  add_finish(c, parts, builder);
  return builder.build();
}

}  // namespace spoke
