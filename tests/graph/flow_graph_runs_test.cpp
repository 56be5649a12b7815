#include "graph/flow_graph_runs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "graph/cost_variation.h"
#include "tests/approx.h"
#include "tests/graph/shapes.h"

using namespace spoke::graph;
using namespace spoke::graph::testing;
using spoke::testing::approx;

namespace {

constexpr double kNode = 10e-6;  // s

RuntimeCosts without_overheads() {
  RuntimeCosts runtime;
  runtime.flow_graph = {0.0, 0.0, 0.0};
  return runtime;
}

double seconds(const StepGraph& graph, int threads, const RuntimeCosts& runtime,
               double variation = 0.0) {
  return simulate_flow_graph_runs(graph, plan_of_single_nodes(graph), equal_costs(graph, kNode),
                                  threads, runtime, variation);
}

}  // namespace

TEST_CASE("simulated runs: a chain is run without a flow graph") {
  const StepGraph chain = make_fan(1, 5);
  RuntimeCosts runtime = without_overheads();
  runtime.flow_graph.per_cluster = 1e-6;
  runtime.flow_graph_run = 1e-6;
  CHECK(seconds(chain, 2, runtime) == approx(7 * kNode));
}

TEST_CASE("simulated runs: one and several threads have their own cost of a run") {
  const StepGraph fan = make_fan(2, 3);
  RuntimeCosts runtime = without_overheads();
  runtime.flow_graph_run = 1e-6;
  runtime.flow_graph_run_among_threads = 3e-6;
  CHECK(seconds(fan, 1, runtime) == approx(8 * kNode + 1e-6));
  CHECK(seconds(fan, 2, runtime) == approx(5 * kNode + 3e-6));
  CHECK(seconds(fan, 64, runtime) == approx(5 * kNode + 3e-6));  // no more than find work
}

TEST_CASE("simulated runs: data that another processor wrote in the run before are waited for") {
  // One node writes two parts, two nodes one each, a last one reads both: on two processors one of
  // the parts is always written elsewhere.
  alignas(64) std::array<double, 96> memory{};
  StepGraphBuilder builder;
  const PartId left = builder.add_part("left", {std::span(memory).first(48)});
  const PartId right = builder.add_part("right", {std::span(memory).last(48)});
  const PartId end = builder.add_part("end", {});
  builder.add_node({"swap"}, {}, writes(left, right), []() noexcept {});
  builder.add_node({"one"}, {}, writes(left), []() noexcept {});
  builder.add_node({"other"}, {}, writes(right), []() noexcept {});
  builder.add_node({"both"}, reads(left, right), writes(end), []() noexcept {});
  const StepGraph graph = builder.build();
  RuntimeCosts runtime = without_overheads();
  CHECK(seconds(graph, 2, runtime) == approx(3 * kNode));
  runtime.transfer = {1e-6, 0.01e-6};
  // The swap fetches the part that it has not, with 384 bytes; the thief fetches the other, and at
  // the end what the thief wrote is fetched by the other processor, or the other way round.
  // Besides, clusters are told and started elsewhere than in the run before.
  const double moved = 1e-6 + 384 * 0.01e-6;
  const double line = 1e-6 + 64 * 0.01e-6;
  CHECK(seconds(graph, 2, runtime) >= 3 * kNode + 2 * moved - 1e-12);
  CHECK(seconds(graph, 2, runtime) <= 3 * kNode + 3 * moved + 4 * line + 1e-12);
  CHECK(seconds(graph, 1, runtime) == approx(4 * kNode));
}

TEST_CASE("simulated runs: the same at every call, and near the exact ones") {
  const StepGraph graph = make_window(5, 3, 4);
  const double exact = seconds(graph, 2, without_overheads());
  const double varied = seconds(graph, 2, without_overheads(), 0.1);
  CHECK(varied == seconds(graph, 2, without_overheads(), 0.1));
  CHECK(varied != exact);
  CHECK(varied == approx(exact).epsilon(0.05));
}

TEST_CASE("cost variation: within its bounds, about the cost, anew each time, the same again") {
  const std::vector<double> costs(1000, kNode);
  CostVariation vary(costs, 0.2);
  const std::vector<double> first = vary();
  const std::vector<double> second = vary();
  CHECK(*std::min_element(first.begin(), first.end()) >= 0.8 * kNode);
  CHECK(*std::max_element(first.begin(), first.end()) <= 1.2 * kNode);
  CHECK(std::accumulate(first.begin(), first.end(), 0.0) == approx(1000 * kNode).epsilon(0.02));
  CHECK(first != second);
  CostVariation again(costs, 0.2);
  CHECK(again() == first);
  CHECK(again() == second);
}
