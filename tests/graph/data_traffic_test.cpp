#include "graph/data_traffic.h"

#include <doctest/doctest.h>

#include <array>

#include "graph/schedule_simulator.h"
#include "tests/approx.h"

using namespace spoke::graph;
using spoke::testing::approx;

namespace {

constexpr Transfer kPerByte{0.0, 1e-9};

// "write" makes 10 doubles, "read" needs them and something without memory.
struct Pair {
  std::array<double, 10> memory{};
  StepGraph graph = build();

  StepGraph build() {
    StepGraphBuilder builder;
    const PartId data = builder.add_part("data", {memory});
    const PartId nothing = builder.add_part("nothing", {});
    builder.add_node({"write"}, {}, writes(data, nothing), []() noexcept {});
    builder.add_node({"read"}, reads(data, nothing), {}, []() noexcept {});
    return builder.build();
  }
};

}  // namespace

TEST_CASE("data traffic: what another processor wrote is waited for once, in proportion") {
  const Pair pair;
  DataTraffic traffic(pair.graph, kPerByte);
  CHECK(traffic.run({0}, 3) == 0.0);  // nobody's yet
  CHECK(traffic.run({1}, 3) == 0.0);
  CHECK(traffic.run({1}, 0) == approx(80e-9));
  CHECK(traffic.run({1}, 0) == 0.0);
  CHECK(traffic.run({1}, 3) == 0.0);  // reading takes nothing from others
  CHECK(traffic.run({1}, 0) == 0.0);
  CHECK(traffic.run({0}, 3) == 0.0);  // who writes has the only copy
  CHECK(traffic.run({1}, 0) == approx(80e-9));
  CHECK(traffic.run({0}, 1) == approx(80e-9));
}

TEST_CASE("data traffic: who writes may wait until others have given up their copies") {
  const Pair pair;
  const auto seconds = [&](Writing writing) {
    DataTraffic traffic(pair.graph, {100e-9, 1e-9}, writing);
    traffic.run({0}, 0);
    CHECK(traffic.run({0}, 0) == 0.0);
    traffic.run({1}, 1);
    const double copied = traffic.run({0}, 0);  // holds the data itself
    CHECK(traffic.run({0}, 0) == 0.0);
    traffic.run({1}, 0);
    CHECK(traffic.run({0}, 0) == 0.0);  // its own copy
    return copied;
  };
  CHECK(seconds(Writing::waits) == approx(100e-9));
  CHECK(seconds(Writing::goes_on) == 0.0);
}

TEST_CASE("data traffic: what the runtime keeps of a cluster comes from who started it last") {
  const Pair pair;
  DataTraffic traffic(pair.graph, {100e-9, 1e-9});
  CHECK(traffic.start_cluster(1, 0) == 0.0);
  CHECK(traffic.start_cluster(1, 0) == 0.0);
  CHECK(traffic.start_cluster(1, 1) == approx(328e-9));  // two cache lines
  CHECK(traffic.start_cluster(1, 1) == 0.0);
  CHECK(traffic.start_cluster(0, 1) == 0.0);
}

TEST_CASE("data traffic: the first of a node's data is waited for once") {
  std::array<double, 10> one{}, other{};
  StepGraphBuilder builder;
  const PartId a = builder.add_part("a", {one});
  const PartId b = builder.add_part("b", {other});
  const PartId nothing = builder.add_part("nothing", {});
  builder.add_node({"both"}, {}, writes(a, b, nothing), []() noexcept {});
  builder.add_node({"nothing"}, reads(nothing), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, {100e-9, 1e-9});
  CHECK(traffic.run({0}, 0) == 0.0);
  CHECK(traffic.run({0}, 1) == approx(260e-9));
  CHECK(traffic.run({0}, 1) == 0.0);
  CHECK(traffic.run({1}, 0) == 0.0);
}

TEST_CASE("data traffic: of a part of many records a node brings one") {
  std::array<double, 100> memory{};
  StepGraphBuilder builder;
  const PartId ring = builder.add_part("ring", {memory}, 5);
  builder.add_node({"write"}, {}, writes(ring), []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, kPerByte);
  CHECK(traffic.run({0}, 0) == 0.0);
  CHECK(traffic.run({0}, 1) == approx(40e-9));
}

TEST_CASE("data traffic: a stolen cluster waits for its data") {
  // One writer, then two readers of its data on two processors.
  std::array<double, 1000> memory{};
  StepGraphBuilder builder;
  const PartId data = builder.add_part("data", {memory});
  builder.add_node({"write"}, {}, writes(data), []() noexcept {});
  for (int k = 0; k < 2; ++k) builder.add_node({"read"}, reads(data), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  const std::array costs{1e-6, 10e-6, 10e-6};
  const Plan plan = plan_of_single_nodes(graph);
  DataTraffic traffic(graph, kPerByte);
  const auto makespan = [&](DataTraffic* data_traffic) {
    return simulate_work_stealing(plan, costs, 2, {0.0, 0.0, 0.0}, data_traffic).makespan;
  };
  CHECK(makespan(nullptr) == approx(11e-6));
  CHECK(makespan(&traffic) == approx(19e-6));
}
