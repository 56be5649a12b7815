// What nodes change is memory of a part: else the check of declarations does not see it. And all
// are of stages that have a role.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "engine/step/assembly.h"
#include "engine/step/formulation/work.h"
#include "engine/step/step_graph_builder.h"
#include "models/system/spatial_system.h"
#include "tests/engine/laws/watched_memory.h"
#include "tests/engine/laws/zoo.h"
#include "tests/engine/step/damaged_graph.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Runs the nodes of some passes. Returns what they change that is memory of no part.
template <class World>
std::vector<std::string> find_uncovered(SystemContext<World>& context,
                                        const std::string& left_out) {
  const bool is_implicit = std::holds_alternative<GeneralizedAlpha>(context.integrator.method);
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context);
  for (const graph::Node& node : graph.nodes())
    CHECK(role_of(node.label.stage, context.data) <= StageRole::system);
  const std::vector<Range> covered = covered_by(graph, [&left_out](const graph::Part& part) {
    return left_out.empty() || !part.name.ends_with(left_out);
  });
  std::vector<std::string> found;
  for (const int stage : {0, 1, PassControl::kEvaluateOnly}) {
    set_progress({0.1, stage, is_implicit && stage >= 0}, context);
    const std::vector<Watched> watched = watch(context);
    std::vector<std::vector<std::byte>> before;
    for (const Watched& at : watched) before.emplace_back(at.memory.begin(), at.memory.end());
    for (const graph::NodeId node : graph.serial_order()) {
      graph.run_node(node);
      for (std::size_t k = 0; k < watched.size(); ++k) {
        const Range now = watched[k].memory;
        if (std::equal(now.begin(), now.end(), before[k].begin())) continue;
        if (find_outside(now, before[k], covered))
          found.push_back(graph.name_of(node) + " changes " + watched[k].name);
        std::copy(now.begin(), now.end(), before[k].begin());
      }
    }
  }
  return found;
}

template <class World>
std::vector<std::string> find_uncovered(const System<World>& system, Formulation formulation,
                                        const Method& method, const std::string& left_out = {}) {
  SystemContext<World> context;
  context.system = system;
  context.formulation = formulation;
  context.integrator = {method, {1e-10, 0, 50}};
  return find_uncovered(context, left_out);
}

template <class World>
void check_covered(const System<World>& system) {
  for (const Formulation formulation : quick_formulations(system.deformation_count()))
    for (const Method& method : {Method(make_generalized_alpha(0.8, 0.01)), Method(Rk4{1e-4})}) {
      CAPTURE(name_of(formulation));
      CAPTURE(method.index());
      CHECK(find_uncovered(system, formulation, method) == std::vector<std::string>{});
    }
}

}  // namespace

TEST_CASE("nodes of every model change no memory but that of parts") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    on_system(model.read(1), [](const auto& system, double) { check_covered(system); });
  }
}

TEST_CASE("memory that nodes change and no part covers is found") {
  const System<Space> system = make_system(*read_shipped("articulated_rotor").space);
  for (const char* part : {"report", "accelerations found", "power", "terms"}) {
    CAPTURE(part);
    CHECK(find_uncovered(system, Formulation::structured, make_generalized_alpha(0.8, 0.01), part)
              .size() >= 1);
  }
}
