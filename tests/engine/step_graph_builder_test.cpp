#include "engine/step_graph_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/pass_ends.h"
#include "graph/declaration_check.h"
#include "rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A rotor whose nodes depend on all they can: free hub off the axis, stiffening, loads in every
/// frame, damping, gravity, and two blades that differ.
Rotor demanding_rotor() {
  Rotor rotor = make_rotor(wu_haug_blade(2, 3), 2);
  rotor.blades[1].reference_frame = ReferenceFrame::chord;
  rotor.blades[1].bodies = 3;
  rotor.hub.support = HubSupport::free;
  rotor.hub.mass = 3.0;
  rotor.hub.radius = 0.2;
  rotor.hub.drive = TorqueDrive{Curve(2.0), 1.0};
  rotor.gravity = Position{0.5, -9.0};
  rotor.damping = {0.1, 1e-4};
  PointLoad load;
  load.position = 3.0;
  load.force = Position{1.0, 2.0};
  load.moment = 0.5;
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section}) {
    load.frame = frame;
    rotor.loads.push_back(load);
  }
  return rotor;
}

struct Case {
  Formulation formulation;
  Method method;
  std::vector<PassControl> controls;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
    cases.push_back({formulation, Rk4{1e-5}, {{0.1, 1, false}, {0.1, 2, false}, {0.1, 0, false}}});
    cases.push_back({formulation,
                     make_generalized_alpha(0.8, 0.005),
                     {{0.1, 0, true}, {0.1, 1, true}, {0.1, -1, false}}});
  }
  return cases;
}

void prepare(const Case& which, StepContext& context) {
  make_context(demanding_rotor(), which.formulation, which.method, context);
  std::mt19937 random(4);
  randomize_state(random, context);
  // Histories and accelerations as after some steps, so that every term of the integrator counts.
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (SubsystemData& subsystem : context.data.subsystems)
    for (BodyData& body : subsystem.bodies)
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

/// The memory of all parts, to set back what a check's run has changed.
class Snapshot {
 public:
  explicit Snapshot(const graph::StepGraph& graph) : graph_(graph) {
    for (const graph::Part& part : graph.parts())
      for (const std::span<double> range : part.memory)
        saved_.emplace_back(range.begin(), range.end());
  }
  void restore() const {
    auto next = saved_.begin();
    for (const graph::Part& part : graph_.parts())
      for (const std::span<double> range : part.memory)
        std::copy(next->begin(), next->end(), range.begin()), ++next;
  }

 private:
  const graph::StepGraph& graph_;
  std::vector<std::vector<double>> saved_;
};

/// The graph's nodes again, one declared access left out.
graph::StepGraph rebuild_without(const graph::StepGraph& graph, int node, graph::PartId part,
                                 bool is_read) {
  graph::StepGraphBuilder builder("blade");
  for (const graph::Part& p : graph.parts()) builder.add_part(p.name, p.memory);
  for (int n = 0; n < graph.node_count(); ++n) {
    const graph::NodeId id{n};
    std::vector<graph::PartId> reads = graph.node(id).reads, writes = graph.node(id).writes;
    if (n == node) std::erase(is_read ? reads : writes, part);
    builder.add_node(graph.node(id).label, graph::reads(reads), graph::writes(writes),
                     [&graph, id]() noexcept { graph.run_node(id); });
  }
  return builder.build();
}

}  // namespace

TEST_CASE("every node of every step graph declares what it reads and writes") {
  for (const Case& which : all_cases())
    for (const PassControl& control : which.controls) {
      StepContext context;
      prepare(which, context);
      const graph::StepGraph graph = build_step_graph(context);
      context.data.control = control;
      for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
        FAIL_CHECK(fault.message);
      CHECK(graph::conflicts_are_ordered(graph));
    }
}

TEST_CASE("a step graph with any one declaration removed is caught") {
  for (const Case& which : all_cases()) {
    StepContext context;
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
                             context.data.control = control;
                             snapshot.restore();
                             return !graph::check_declarations(damaged).empty();
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

TEST_CASE("blades meet at the hub only") {
  StepContext context;
  make_context(make_rotor(wu_haug_blade(), 3), Formulation::structured,
               make_generalized_alpha(0.8, 0.005), context);
  const graph::StepGraph graph = build_step_graph(context);
  CHECK(graph.node_count() == 3 + 3 * (5 + 3 * 4));
  std::map<std::string, int> count;
  for (int n = 0; n < graph.node_count(); ++n) {
    const graph::NodeLabel& label = graph.node({n}).label;
    ++count[label.stage];
    for (const graph::NodeId next : graph.successors({n})) {
      const int to = graph.node(next).label.subsystem;
      if (label.subsystem >= 0 && to >= 0) CHECK(label.subsystem == to);
    }
  }
  CHECK(count["inverse"] == 12);
  CHECK(count["mass"] == 12);
  CHECK(count["effective"] == 3);
  CHECK(count["hub solve"] == 1);
}

TEST_CASE("with a prescribed hub no coordinate of the next pass waits for the hub's solution") {
  // What a graph over several steps will build on: the solution yields the blades' reactions within
  // the pass, and nothing outside reads it but the report.
  StepContext context;
  make_context(make_rotor(wu_haug_blade(2, 2), 2), Formulation::structured,
               make_generalized_alpha(0.8, 0.005), context);
  const graph::StepGraph graph = build_step_graph(context);
  std::set<std::string> readers;
  for (int n = 0; n < graph.node_count(); ++n)
    for (const graph::PartId part : graph.node({n}).reads)
      if (graph.part(part).name == "hub solution") readers.insert(graph.node({n}).label.stage);
  CHECK(readers == std::set<std::string>{"multipliers", "finish"});
}
