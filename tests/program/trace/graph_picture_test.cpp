#include "program/trace/graph_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "tests/program/trace/samples.h"

using namespace spoke;
using namespace spoke::trace;
using namespace spoke::trace::testing;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1))
    ++found;
  return found;
}

bool contains(const std::string& text, const std::string& part) { return count(text, part) > 0; }

/// Makes a trace of `subsystems` chains root -> mass -> inverse of two bodies each, all of which
/// ran in one step; every `per_cluster` nodes in one cluster, 0: no clusters.
Trace wide_trace(int subsystems, int per_cluster) {
  Trace trace = small_trace();
  StepTrace& steps = trace.steps;
  steps.graph = {{{"root"}}, {"root"}, "blade", {}, {}};
  for (int i = 0; i < subsystems; ++i)
    for (int j = 0; j < 2; ++j)
      for (const char* stage : {"mass", "inverse"}) {
        const int node = steps.graph.node_count();
        steps.graph.labels.push_back({stage, i, j});
        steps.graph.names.push_back(graph::name_of(steps.graph.labels.back(), "blade"));
        steps.graph.edges.push_back({stage == std::string("mass") ? 0 : node - 1, node});
      }
  steps.steps = {{1, 0.5, 1}};
  steps.slices.clear();
  for (int node = 0; node < steps.graph.node_count(); ++node)
    steps.slices.push_back({node, 1, 0, per_cluster > 0 ? node / per_cluster : -1, 0, 1000 * node,
                            1000 * node + 1000});
  return trace;
}

}  // namespace

TEST_CASE(
    "the picture has a box for each node and an arrow for each edge, the longest path marked") {
  const std::string dot = make_dot(small_trace());
  CHECK(dot.starts_with("digraph step {"));
  CHECK(count(dot, "fillcolor") == 3);
  CHECK(count(dot, " -> ") == 2);
  CHECK(contains(dot, "blade 1\\nbody 1 / mass\\n3 us, 50 %"));
  CHECK(contains(dot, "longest path, 4 us"));
  CHECK(contains(dot, "n0 -> n1 [color=\"#d55e00\""));
  CHECK(contains(dot, "n0 -> n2\n"));
  // The dearest node is the darkest, with light letters.
  CHECK(count(dot, "fontcolor=\"white\"") == 2);
  CHECK(count(dot, "#08306b") == 1);
}

TEST_CASE("the picture of a real trace has all its nodes and edges") {
  const Trace trace = make_trace({ExecutorKind::flow_graph, 2, 1, true});
  const std::string dot = make_dot(trace);
  CHECK(count(dot, "fillcolor") == trace.steps.graph.labels.size());
  CHECK(count(dot, " -> ") == trace.steps.graph.edges.size());
  CHECK(contains(dot, "A \\\"sample\\\" </script>"));
}

TEST_CASE("more than 1000 nodes are drawn by clusters, or by blade and stage, or by stage") {
  const std::string single = make_dot(wide_trace(249, 4));  // 997 nodes
  CHECK(contains(single, "a box for each node;"));
  CHECK(count(single, "fillcolor") == 997);
  const std::string clusters = make_dot(wide_trace(300, 10));  // 1201 nodes
  CHECK(contains(clusters, "a box for each cluster;"));
  CHECK(count(clusters, "fillcolor") == 121);
  CHECK(contains(clusters, "cluster 5\\ninverse, mass\\n10 nodes\\n10 us"));
  for (const int per_cluster : {0, 1}) {  // no plan, or one that joins nothing
    const std::string stages = make_dot(wide_trace(300, per_cluster));
    CHECK(contains(stages, "a box for each blade and stage;"));
    CHECK(count(stages, "fillcolor") == 601);
    CHECK(count(stages, " -> ") == 600);
    CHECK(contains(stages, "blade 300\\ninverse\\n2 nodes\\n2 us"));
  }
  const std::string few = make_dot(wide_trace(700, 0));
  CHECK(contains(few, "a box for each stage;"));
  CHECK(count(few, "fillcolor") == 3);
}
