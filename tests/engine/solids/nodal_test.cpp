// Solids in nodal coordinates in runs: as reduced ones with all modes, in slices and in one piece,
// on all executors.

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/engine/step/damaged_graph.h"
#include "tests/engine/step/step_declarations.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

spatial::Model make_nodal_trees(HubSupport support) {
  return make_solid_trees(support, spatial::SolidCoordinates::nodal);
}

/// Modes of make_bar(slender_grid()) besides those of its interface: it has 195 coordinates.
constexpr int kAllModes = 189;

/// A bar on a hinge of a turning hub, with gravity and a load at its tip; it carries a mass.
spatial::Model make_loaded_bar(spatial::SolidCoordinates coordinates) {
  spatial::Model model = make_nodal_trees(HubSupport::axle);
  model.hub.drive = ConstantSpeed{3.0};
  model.gravity = Vector(0.5, -1.0, -9.81);
  spatial::SolidBody bar = make_bar(slender_grid(), rubber());
  bar.coordinates = coordinates;
  if (coordinates == spatial::SolidCoordinates::reduced) bar.modes = kAllModes;
  model.subsystems.resize(1);
  spatial::Subsystem& tree = model.subsystems[0];
  spatial::SubsystemJoint carry = tree.joints[3];
  carry.parent = "arm";
  carry.interface = "tip";
  tree.bodies = {{"arm", bar}, tree.bodies[3]};
  tree.joints = {tree.joints[0], carry};
  spatial::PointLoad load;
  load.place.subsystem = "tree";
  load.place.body = "arm";
  load.interface = "tip";
  load.force = Vector(3.0, 8.0, -6.0);
  model.loads = {load};
  return model;
}

Eigen::VectorXd displacements(const Run<Space>& run, std::size_t i, std::size_t j) {
  const BodyData<Space>& body = run.context.data.subsystems[i].bodies[j];
  return calc_displacements(*body.model->body->solid()->constants, body.coordinates.q);
}

const Method kImplicit = make_generalized_alpha(0.8, 5e-4);

}  // namespace

TEST_CASE("nodal coordinates move a solid as all its modes do") {
  const System<Space> nodal = make_system(make_loaded_bar(spatial::SolidCoordinates::nodal));
  const System<Space> modal = make_system(make_loaded_bar(spatial::SolidCoordinates::reduced));
  REQUIRE(nodal.subsystems[0].bodies[0].body->coordinates() ==
          modal.subsystems[0].bodies[0].body->coordinates());
  Run<Space> a(nodal, {kImplicit}), b(modal, {kImplicit});
  a.advance(100);
  b.advance(100);
  const Eigen::VectorXd u = displacements(a, 0, 0);
  CHECK(u.cwiseAbs().maxCoeff() > 1e-3);
  CHECK((u - displacements(b, 0, 0)).cwiseAbs().maxCoeff() < 1e-8 * u.cwiseAbs().maxCoeff());
  CHECK(calc_energy(a) == doctest::Approx(calc_energy(b)).epsilon(1e-8));
  CHECK(a.work == doctest::Approx(b.work).epsilon(1e-8));
}

TEST_CASE("three formulations move solids in nodal coordinates alike, in slices too") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    const System<Space> whole = make_system(make_nodal_trees(support));
    const auto run = [&](const System<Space>& system, Formulation formulation) {
      auto made = std::make_unique<Run<Space>>(
          system, RunSetup{.method = kImplicit, .formulation = formulation});
      made->advance(20);
      return made;
    };
    const auto structured = run(whole, Formulation::structured);
    const Eigen::VectorXd u = displacements(*structured, 0, 0);
    const auto check = [&](const System<Space>& system, Formulation formulation) {
      const auto other = run(system, formulation);
      CHECK((displacements(*other, 0, 0) - u).cwiseAbs().maxCoeff() < 1e-9);
      CHECK((displacements(*other, 0, 1) - displacements(*structured, 0, 1)).cwiseAbs().maxCoeff() <
            1e-9);
    };
    CHECK(u.cwiseAbs().maxCoeff() > 1e-5);
    check(whole, Formulation::subsystem);
    const System<Space> cut = cut_solids(whole, 2);
    for (const Formulation formulation : formulations()) check(cut, formulation);
  }
}

TEST_CASE("solids in slices have equal bits on executors, threads and windows") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    spatial::Model model = make_nodal_trees(support);
    if (support == HubSupport::axle) model.hub.drive = ConstantSpeed{2.0};
    const System<Space> system = cut_solids(make_system(model), 2);
    const auto hash = [&](graph::ExecutorKind executor, graph::Threads threads, int window) {
      Run<Space> run(
          system,
          {.method = kImplicit, .executor = executor, .threads = threads, .window = window});
      run.advance(12);
      return run.hash();
    };
    using graph::ExecutorKind;
    const std::uint64_t serial = hash(ExecutorKind::serial, graph::Threads{1}, 1);
    for (const ExecutorKind executor :
         {ExecutorKind::flow_graph, ExecutorKind::openmp_levels, ExecutorKind::openmp_tasks,
          ExecutorKind::openmp_scheme1, ExecutorKind::openmp_scheme2})
      for (const int threads : {1, 2, 3}) {
        CAPTURE(threads);
        CHECK(hash(executor, graph::Threads{threads}, 1) == serial);
      }
    CHECK(hash(ExecutorKind::openmp_scheme1, graph::Threads{1, 3}, 1) == serial);
    CHECK(hash(ExecutorKind::openmp_scheme2, graph::Threads{2, 2}, 1) == serial);
    CHECK(hash(ExecutorKind::flow_graph, graph::Threads{2}, 4) == serial);
    CHECK(hash(ExecutorKind::openmp_levels, graph::Threads{3}, 4) == serial);
  }
}

TEST_CASE("the slices of a solid are nodes that wait for nothing of one another") {
  SystemContext<Space> context;
  context.system = cut_solids(make_system(make_loaded_bar(spatial::SolidCoordinates::nodal)), 2);
  context.integrator = {kImplicit, {1e-10, 0, 50}};
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context, 1);
  const auto find = [&](const std::string& name) {
    for (int n = 0; n < graph.node_count(); ++n)
      if (graph.name_of({n}) == name) return graph::NodeId{n};
    FAIL(name);
    return graph::NodeId{};
  };
  const auto comes_first = [&](const std::string& from, const std::string& to) {
    const graph::NodeId end = find(to);
    const auto next = graph.successors(find(from));
    return std::find(next.begin(), next.end(), end) != next.end();
  };
  const std::string arm = "blade 1 / body 1 / ", first = arm + "slice 1 / ",
                    second = arm + "slice 2 / ";
  for (const std::string& slice : {first, second}) {
    CHECK(comes_first(slice + "mass tile", arm + "mass"));
    CHECK(comes_first(arm + "mass", slice + "forward"));
    CHECK(comes_first(slice + "forward", arm + "inverse"));
    CHECK(comes_first(arm + "recovery", slice + "backward"));
    CHECK(comes_first(slice + "backward", arm + "completion"));
  }
  for (const char* stage : {"mass tile", "forward", "backward"})
    CHECK_FALSE(comes_first(first + stage, second + stage));
}

TEST_CASE("the nodes of solids in slices declare what they read and write") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Formulation formulation : formulations())
      for (const Method& method : {kImplicit, Method(Rk4{1e-6})})
        for (const int slices : {1, 2}) {
          CAPTURE(slices);
          CAPTURE(name_of(formulation));
          spatial::Model model = support == HubSupport::axle
                                     ? make_loaded_bar(spatial::SolidCoordinates::nodal)
                                     : make_nodal_trees(support);
          check_step_declarations(cut_solids(make_system(model), slices), formulation, method);
        }
}

TEST_CASE("an access of a slice that is not declared is found") {
  SystemContext<Space> context;
  context.system = cut_solids(make_system(make_loaded_bar(spatial::SolidCoordinates::nodal)), 2);
  context.integrator = {kImplicit, {1e-10, 0, 50}};
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context, 1);
  set_progress({0.1, 0, true}, context);
  const Snapshot before(graph);
  int left_out = 0;
  for (int n = 0; n < graph.node_count(); ++n) {
    const graph::Node& node = graph.node({n});
    if (node.label.item.empty()) continue;
    for (const bool is_read : {false, true})
      for (const graph::PartId part : is_read ? node.reads : node.writes) {
        if (graph.part(part).name.find("slice") == std::string::npos) continue;
        CAPTURE(graph.name_of({n}));
        CAPTURE(graph.part(part).name);
        ++left_out;
        CHECK_FALSE(graph::check_declarations(rebuild_without(graph, n, part, is_read)).empty());
        before.restore();
      }
  }
  CHECK(left_out >= 10);
}
