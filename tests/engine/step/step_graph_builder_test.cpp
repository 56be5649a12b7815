#include "engine/step/step_graph_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/bodies/columns/sensor_columns.h"
#include "engine/step/pass_integration.h"
#include "graph/declaration_check.h"
#include "tests/engine/load_rotors.h"
#include "tests/engine/rotors.h"
#include "tests/engine/step/damaged_graph.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A rotor whose nodes depend on all they can: roots off the axis, stiffening, loads in every
/// frame, damping, gravity, two blades that differ, and a hub that is free or driven.
Rotor demanding_rotor(bool is_free, BeamStrain strain) {
  Blade blade = wu_haug_blade(2, 3);
  blade.strain = strain;
  Rotor rotor = make_rotor(blade, 2);
  rotor.blades[1].reference_frame = ReferenceFrame::chord;
  rotor.blades[1].bodies = 3;
  rotor.hub.mass = 3.0;
  rotor.hub.inertia = 2.0;
  rotor.hub.radius = 0.2;
  rotor.hub.drive = SpinUp{4.0, 1.0};
  if (is_free) {
    rotor.hub.support = HubSupport::free;
    rotor.hub.drive = TorqueBySpeed{Curve({-4.0, 4.0}, {2.0, -1.0}), 1.0, 0.3};
  }
  rotor.gravity = Position{0.5, -9.0};
  rotor.damping = {0.1, 1e-4};
  add_all_loads(rotor);
  return rotor;
}

/// Ties between blades: none, a load of the user's, or that and the hub.
enum class Tie { none, load, hub };

struct Case {
  Tie tie;
  Formulation formulation;
  Method method;
  std::vector<PassControl> controls;
  BeamStrain strain = BeamStrain::linear;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Formulation formulation : formulations())
    for (const Tie tie : {Tie::none, Tie::load, Tie::hub}) {
      cases.push_back(
          {tie, formulation, Rk4{1e-5}, {{0.1, 1, false}, {0.1, 2, false}, {0.1, 0, false}}});
      cases.push_back({tie,
                       formulation,
                       make_generalized_alpha(0.8, 0.005),
                       {{0.1, 0, true}, {0.1, 1, true}, {0.1, -1, false}}});
      if (tie == Tie::load) continue;
      Case second_order = cases.back();
      second_order.strain = BeamStrain::nonlinear;
      cases.push_back(second_order);
    }
  return cases;
}

/// Sets all progress to a pass within step 20, after work was done, as wide as one step.
void set_progress(const PassControl& control, SystemContext<Plane>& context) {
  start_progress(control, context.data);
  for (StepProgress& progress : context.data.progress) {
    progress.step = control.stage == PassControl::kEvaluateOnly ? 0 : 20;
    const bool is_fixed = context.integrator.limits.fixed > 0;
    progress.passes = is_fixed ? std::max(0, control.stage) : 1;
    progress.power = {3.0, 2.0};
    progress.work = 0.3;
    progress.dissipated = 0.2;
    progress.control.order = 3;
  }
  context.data.window = {20, 20, true};
  // The second iteration completes its step.
  context.integrator.limits.tolerance = control.stage == 1 ? 1e9 : 0.0;
}

/// Sensors that read all that sensors may.
std::vector<Sensor> demanding_sensors() {
  std::vector<Sensor> sensors(3);
  sensors[0].quantity = SensorQuantity::acceleration;
  sensors[0].frame = SensorFrame::inertial;
  sensors[1].quantity = SensorQuantity::section_force;
  sensors[1].position = 0.5;
  sensors[2].quantity = SensorQuantity::blade_momentum;
  return sensors;
}

void prepare(const Case& which, SystemContext<Plane>& context) {
  // Loads of the user's that depend on all they may.
  Loads loads{demanding_load(0), demanding_load(1)};
  if (which.tie != Tie::none) loads.push_back(demanding_load_between());
  const std::vector<AskedLoad> asked = ask_loads(loads);
  context.loads_tie_subsystems = ties_subsystems(asked);
  const Rotor rotor = demanding_rotor(which.tie == Tie::hub, which.strain);
  make_context(rotor, which.formulation, which.method, context);
  // An iteration to a tolerance would go on, however often.
  if (which.strain == BeamStrain::nonlinear) context.integrator.limits.fixed = 2;
  place_loads(asked, context.system, context.data);
  place_sensors(demanding_sensors(), rotor, context.data);
  std::mt19937 random(4);
  randomize_state(random, context);
  // Histories and accelerations as after some steps, so that every term of the integrator counts.
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (SubsystemData<Plane>& subsystem : context.data.subsystems)
    for (BodyData<Plane>& body : subsystem.bodies)
      for (int part : {body.layout.u(), body.layout.v()})
        for (int k = 0; k < (part == body.layout.u() ? body.layout.axial : body.layout.bending);
             ++k) {
          body.coordinates.a[part + k] = 1e-2 * unit(random);
          for (double* history : body.coordinates.history)
            if (history) history[part + k] = 1e-3 * unit(random);
        }
  for (double* history : context.data.hub_coordinates.history)
    if (history)
      for (int c = 0; c < kTwist; ++c) history[c] = unit(random);
}

}  // namespace

TEST_CASE("every node of every step graph declares what it reads and writes") {
  for (const Case& which : all_cases())
    for (const PassControl& control : which.controls) {
      SystemContext<Plane> context;
      prepare(which, context);
      const graph::StepGraph graph = build_step_graph(context);
      set_progress(control, context);
      for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
        FAIL_CHECK(fault.message);
      CHECK(graph::conflicts_are_ordered(graph));
    }
}

TEST_CASE("a step graph with any one declaration removed is caught") {
  for (const Case& which : all_cases()) {
    SystemContext<Plane> context;
    prepare(which, context);
    const graph::StepGraph graph = build_step_graph(context);
    const Snapshot snapshot(graph);
    int missed = 0, tried = 0;
    for (int n = 0; n < graph.node_count(); ++n) {
      const graph::Node& node = graph.node({n});
      const auto is_caught = [&](graph::PartId part, bool is_read) {
        const graph::StepGraph damaged = rebuild_without(graph, n, part, is_read);
        return std::any_of(which.controls.begin(), which.controls.end(),
                           [&](const PassControl& control) {
                             snapshot.restore();
                             set_progress(control, context);
                             return !graph::check_declaration(damaged, {n}).empty();
                           });
      };
      const auto check = [&](const std::vector<graph::PartId>& parts, bool is_read) {
        for (const graph::PartId part : parts) {
          ++tried;
          if (is_caught(part, is_read)) continue;
          ++missed;
          const std::string verb = is_read ? " does not need to read " : " does not need to write ";
          MESSAGE(name_of(which.formulation)
                  << ": " << graph.name_of({n}) << verb << graph.part(part).name);
        }
      };
      check(node.reads, true);
      check(node.writes, false);
    }
    CHECK(tried > 100);
    CHECK(missed == 0);
  }
}

TEST_CASE("a pass has its nodes by blade and body") {
  SystemContext<Plane> context;
  make_context(make_rotor(wu_haug_blade(), 3), Formulation::structured,
               make_generalized_alpha(0.8, 0.005), context);
  const graph::StepGraph graph = build_step_graph(context);
  CHECK(graph.node_count() == 1 + 3 * (8 + 3 * 4));
  std::map<std::string, int> count;
  for (const graph::Node& node : graph.nodes()) ++count[node.label.stage];
  CHECK(count["inverse"] == 12);
  CHECK(count["mass"] == 12);
  CHECK(count["effective"] == 3);
  CHECK(count["hub solve"] == 1);
}

namespace {

/// Edges from a node of one blade to a node of another, or of the system, but for the last node.
int count_edges_between_blades(const Rotor& rotor, Formulation formulation, int passes) {
  SystemContext<Plane> context;
  make_context(rotor, formulation, make_generalized_alpha(0.8, 0.005), context);
  const graph::StepGraph graph = build_step_graph(context, passes);
  CHECK(graph::conflicts_are_ordered(graph));
  int count = 0;
  for (int n = 0; n < graph.node_count(); ++n)
    for (const graph::NodeId next : graph.successors({n}))
      if (next.index + 1 < graph.node_count())
        count += graph.node({n}).label.subsystem != graph.node(next).label.subsystem ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("where the hub is prescribed, blades meet at the end of the window only") {
  const Rotor rotor = make_rotor(wu_haug_blade(2, 2), 3);
  for (const int passes : {1, 2, 7}) {
    CHECK(count_edges_between_blades(rotor, Formulation::structured, passes) == 0);
    CHECK(count_edges_between_blades(rotor, Formulation::subsystem, passes) == 0);
    CHECK(count_edges_between_blades(rotor, Formulation::augmented, passes) > 5 * passes);
  }
  SystemContext<Plane> context;
  make_context(rotor, Formulation::structured, make_generalized_alpha(0.8, 0.005), context);
  const graph::StepGraph graph = build_step_graph(context, 7);
  const graph::NodeId last{graph.node_count() - 1};
  CHECK(graph.name_of(last) == "hub solve");
  CHECK(graph.predecessors(last).size() == 3);
  CHECK(graph.name_of({5}).find("(pass 1)") != std::string::npos);
}

TEST_CASE("where the hub is not prescribed, the edges through it appear in every pass") {
  Rotor rotor = make_rotor(wu_haug_blade(2, 2), 3);
  rotor.hub.drive = FreeDrive{1.0};
  for (const int passes : {1, 2, 7})
    CHECK(count_edges_between_blades(rotor, Formulation::structured, passes) > 5 * passes);
}
