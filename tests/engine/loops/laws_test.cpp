// What holds of any closed loops: formulations, executors, momentum, energy, declared accesses.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"
#include "tests/engine/step/damaged_graph.h"
#include "tests/engine/step/step_declarations.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

/// On each of two sides of a hub two elastic booms, tied by a rod on the first one, and a link from
/// the second one to the hub, sprung on one side.
spatial::Model make_tied_booms(HubSupport support) {
  spatial::Model model;
  model.hub.support = support;
  model.hub.mass = 3.0;
  model.hub.inertia = Vector(0.4, 0.5, 0.6).asDiagonal();
  if (support == HubSupport::free) {
    model.hub.velocity = Vector(0.3, -0.2, 0.5);
    model.hub.angular_velocity = Vector(0.5, -0.4, 2.0);
  } else {
    model.hub.drive = FreeDrive{2.0};
  }
  for (int side = 0; side < 2; ++side) {
    spatial::Subsystem s{"side" + std::to_string(side + 1), {}, {}, {}};
    for (int k = 0; k < 2; ++k) {
      spatial::Beam beam;
      beam.length = 1.0;
      beam.bodies = 1 + k;
      beam.elements = 2;
      beam.reference_frame = k == 0 ? ReferenceFrame::clamped : ReferenceFrame::chord;
      beam.geometric_stiffening = false;
      beam.sections.station = {0.0, 1.0};
      beam.sections.mass_per_length = {0.8, 0.7};
      beam.sections.axial_stiffness = {2e4, 2e4};
      beam.sections.lag_stiffness = {30.0, 30.0};
      beam.sections.flap_stiffness = {20.0, 20.0};
      beam.sections.torsion_stiffness = {20.0, 20.0};
      beam.sections.flap_inertia = beam.sections.lag_inertia = {1e-3, 1e-3};
      s.bodies.push_back({"boom" + std::to_string(k + 1), beam});
      spatial::SubsystemJoint joint =
          make_hinge("hub", s.bodies.back().name, Vector(0.0, 0.4 * k, 0.1 * k), 0.1 * k, 0.2,
                     Vector(0.1, 0.2 + k, 1.0));
      joint.joint.orientation = Vector(0.0, 0.0, 3.0 * side);
      joint.joint.coordinates[0].stiffness = 5.0;
      s.joints.push_back(joint);
    }
    s.bodies.push_back(make_rod("rod", 0.5, 0.4));
    s.joints.push_back(make_hinge("boom1", "rod", Vector(0.0, 0.0, 0.0), 1.5, 0.0));
    s.joints.back().joint.kind = spatial::JointKind::spherical;
    for (int c = 0; c < 3; ++c)
      s.joints.back().joint.coordinates[static_cast<std::size_t>(c)] = {.initial =
                                                                            c == 2 ? 1.5 : 0.0};
    Loop tie;
    tie.name = "tie";
    tie.kind = LoopKind::spherical;
    tie.from = on_body("rod", Vector(0.4, 0.0, 0.0));
    tie.to.name = "boom2";
    tie.to.station = 1.0;
    tie.to.point = Vector(0.0, -0.02, 0.03);
    s.loops.push_back(tie);
    Loop link;
    link.name = "link";
    link.kind = LoopKind::distance;
    link.from.name = "boom2";
    link.from.station = 0.5;
    link.to.carrier = LoopPlace::Carrier::hub;
    link.to.point = Vector(0.2, 0.1, 0.6);
    if (side == 1) {
      link.stiffness = {4000.0};
      link.damping = {3.0};
    }
    s.loops.push_back(link);
    model.subsystems.push_back(s);
  }
  return model;
}

/// Returns the model without dampers in its loops.
spatial::Model without_dampers(spatial::Model model) {
  for (spatial::Subsystem& subsystem : model.subsystems)
    for (Loop& loop : subsystem.loops) loop.damping.clear();
  return model;
}

/// Fills coordinates and accelerations, as after some steps.
void disturb(StepData<Space>& data) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto fill = [&](CoordinateBlock& block) {
    block.for_parts([&](int first, int n) {
      for (int k = first; k < first + n; ++k) {
        block.q[k] += 1e-3 * unit(random);
        block.v[k] += 0.1 * unit(random);
        block.a[k] = unit(random);
        for (double* history : block.history)
          if (history) history[k] = 1e-3 * unit(random);
      }
    });
  };
  data.for_each_block(fill);
}

}  // namespace

TEST_CASE("three formulations move closed loops alike") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
      const System<Space> system = make_system(make_tied_booms(support));
      const auto structured = check_formulations(system, method, 100, 1e-10);
      CHECK(structured->context.data.subsystems[0].loops.report.opening < 1e-13);
    }
}

TEST_CASE("closed loops have equal bits on executors, threads and windows") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
      spatial::Model model = make_tied_booms(support);
      if (support == HubSupport::axle) model.hub.drive = ConstantSpeed{2.0};
      check_equal_bits(make_system(model), method, 60);
    }
}

TEST_CASE("a free model with loops keeps momentum and energy by the method's order") {
  const System<Space> system = make_system(without_dampers(make_tied_booms(HubSupport::free)));
  check_conservation(system, 0.1, 4e-4);
}

TEST_CASE(
    "dampers in closures, a torque and an anchor that moves: energy changes by what they do") {
  spatial::Model model = make_tied_booms(HubSupport::axle);
  model.hub.drive = TorqueDrive{Curve(2.0), 1.0};
  Anchor plate;
  plate.name = "plate";
  plate.turns_with_hub = true;
  spatial::MountMotion motion;
  motion.translation = spatial::VectorHarmonic{Vector(0.0, 0.0, 0.0), Vector::Zero(),
                                               Vector(0.01, 0.0, 0.03), 9.0, 0.0};
  motion.rotation =
      spatial::VectorHarmonic{Vector::Zero(), Vector::Zero(), Vector(0.05, -0.04, 0.0), 7.0, 0.0};
  plate.motion = motion;
  model.anchors.push_back(plate);
  for (spatial::Subsystem& subsystem : model.subsystems) {
    LoopPlace& to = subsystem.loops[1].to;
    to.carrier = LoopPlace::Carrier::anchor;
    to.name = "plate";
  }
  const System<Space> system = make_system(model);
  const auto residual = [&](const Method& method) {
    Run<Space> run(system, {method});
    const double before = calc_energy(run);
    run.advance_for(0.2);
    CHECK(std::abs(run.work) > 0.01);
    CHECK(run.dissipated > 1e-4);
    return std::abs(calc_energy(run) - before - run.work + run.dissipated);
  };
  CHECK(residual(Rk4{4e-4}) / residual(Rk4{2e-4}) > 11.0);
  CHECK(residual(make_generalized_alpha(0.9, 2e-4)) / residual(make_generalized_alpha(0.9, 1e-4)) >
        3.3);
}

TEST_CASE("the nodes of closed loops declare what they read and write") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const bool is_driven : {false, true})
      for (const Formulation formulation :
           {Formulation::structured, Formulation::subsystem, Formulation::augmented})
        for (const Method& method :
             {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
          if (is_driven && support == HubSupport::free) continue;
          spatial::Model model = make_tied_booms(support);
          if (is_driven) model.hub.drive = ConstantSpeed{2.0};
          check_step_declarations(make_system(model), formulation, method);
        }
}

TEST_CASE("the graph of a model with loops with any one declaration removed is caught") {
  for (const bool is_coupled : {false, true})
    for (const Formulation formulation : formulations())
      for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
        spatial::Model model = make_tied_booms(HubSupport::axle);
        model.subsystems.pop_back();
        if (!is_coupled) model.hub.drive = ConstantSpeed{2.0};
        SystemContext<Space> context;
        context.system = make_system(model);
        context.formulation = formulation;
        context.integrator = {method, {1e-10, 0, 50}};
        allocate(context);
        disturb(context.data);
        const graph::StepGraph graph = build_step_graph(context, 1);
        const Snapshot snapshot(graph);
        const bool is_implicit = method.index() == 0;
        std::vector<PassControl> controls{{0.1, 0, is_implicit}, {0.1, 1, is_implicit}};
        if (is_implicit) {
          controls.push_back({0.1, PassControl::kEvaluateOnly, false});
          controls.push_back({0.1, PassControl::kRestart, true});
        } else {
          for (const int stage : {2, 3, 4, 5, 6}) controls.push_back({0.1, stage, false});
          controls.push_back({0.1, PassControl::kEvaluateOnly, false});
        }
        const auto is_caught = [&](int n, graph::PartId part, bool is_read) {
          const graph::StepGraph damaged = rebuild_without(graph, n, part, is_read);
          return std::any_of(controls.begin(), controls.end(), [&](const PassControl& control) {
            snapshot.restore();
            set_progress(control, context);
            return !graph::check_declaration(damaged, {n}).empty();
          });
        };
        for (int n = 0; n < graph.node_count(); ++n) {
          const std::string stage = graph.node({n}).label.stage;
          if (!stage.starts_with("loop")) continue;  // others are tested without loops
          for (const bool is_read : {true, false})
            for (const graph::PartId part :
                 is_read ? graph.node({n}).reads : graph.node({n}).writes)
              if (!is_caught(n, part, is_read)) {
                const std::string what =
                    std::string(name_of(formulation)) + (is_implicit ? " implicit" : " explicit") +
                    (is_coupled ? " coupled: " : ": ") + graph.name_of({n}) +
                    (is_read ? " does not need to read " : " does not need to write ") +
                    graph.part(part).name;
                FAIL_CHECK(what);
              }
        }
      }
}
