#include "graph/simulate/data_traffic.h"

#include <doctest/doctest.h>

#include <array>
#include <span>

#include "tests/approx.h"

using namespace spoke::graph;
using spoke::testing::approx;

namespace {

constexpr Transfer kPerByte{0.0, 1e-9};
constexpr double kLine = 64e-9;   // s, of a cache line at that
constexpr double kShort = 10e-9;  // s, that a node takes

// "write" makes 10 doubles, which lie on two cache lines, "read" needs them and something without
// memory.
struct Pair {
  alignas(64) std::array<double, 10> memory{};
  StepGraph graph = build();

  StepGraph build() {
    StepGraphBuilder builder;
    const PartId data = builder.add_part("data", {bytes_of(std::span(memory))});
    const PartId nothing = builder.add_part("nothing", {});
    builder.add_node({"write"}, {}, writes(data, nothing), []() noexcept {});
    builder.add_node({"read"}, reads(data, nothing), {}, []() noexcept {});
    return builder.build();
  }
};

}  // namespace

TEST_CASE("data traffic: what another processor wrote is waited for once, by cache lines") {
  const Pair pair;
  DataTraffic traffic(pair.graph, kPerByte);
  CHECK(traffic.run({0}, 3, kShort) == 0.0);  // nobody's yet
  CHECK(traffic.run({1}, 3, kShort) == 0.0);
  CHECK(traffic.run({1}, 0, kShort) == approx(2 * kLine));
  CHECK(traffic.run({1}, 0, kShort) == 0.0);
  CHECK(traffic.run({1}, 3, kShort) == 0.0);  // reading takes nothing from others
  CHECK(traffic.run({1}, 0, kShort) == 0.0);
  CHECK(traffic.run({0}, 3, kShort) == 0.0);  // who writes has the only copy
  CHECK(traffic.run({1}, 0, kShort) == approx(2 * kLine));
  CHECK(traffic.run({0}, 1, kShort) == approx(2 * kLine));
}

TEST_CASE("data traffic: who writes waits until others have given up their copies") {
  const Pair pair;
  DataTraffic traffic(pair.graph, {100e-9, 1e-9});
  traffic.run({0}, 0, kShort);
  CHECK(traffic.run({0}, 0, kShort) == 0.0);
  traffic.run({1}, 1, kShort);
  CHECK(traffic.run({0}, 0, kShort) == approx(100e-9));  // holds the data itself
  CHECK(traffic.run({0}, 0, kShort) == 0.0);
  traffic.run({1}, 0, kShort);
  CHECK(traffic.run({0}, 0, kShort) == 0.0);  // its own copy
  CHECK(traffic.wait_at_barrier(0) == 0.0);
}

TEST_CASE("data traffic: or it waits at its next barrier, once for all") {
  const Pair pair;
  DataTraffic traffic(pair.graph, {100e-9, 1e-9}, Writing::at_barriers);
  traffic.run({0}, 0, kShort);
  CHECK(traffic.wait_at_barrier(0) == 0.0);
  for (int k = 0; k < 2; ++k) {
    traffic.run({1}, 1, kShort);
    CHECK(traffic.run({0}, 0, kShort) == 0.0);
  }
  CHECK(traffic.wait_at_barrier(1) == 0.0);
  CHECK(traffic.wait_at_barrier(0) == approx(100e-9));
  CHECK(traffic.wait_at_barrier(0) == 0.0);
}

TEST_CASE("data traffic: what the runtime keeps of a cluster comes from who changed it last") {
  const Pair pair;
  DataTraffic traffic(pair.graph, {100e-9, 1e-9});
  for (const auto change : {&DataTraffic::start_cluster, &DataTraffic::notify}) {
    CHECK((traffic.*change)(1, 0) == 0.0);
    CHECK((traffic.*change)(1, 0) == 0.0);
    CHECK((traffic.*change)(1, 1) == approx(164e-9));  // a cache line
    CHECK((traffic.*change)(1, 1) == 0.0);
    CHECK((traffic.*change)(0, 1) == 0.0);
  }
  CHECK(traffic.notify(1, 0) == approx(164e-9));
  CHECK(traffic.start_cluster(1, 0) == 0.0);  // lies beside what it has told
  CHECK(traffic.start_cluster(1, 1) == approx(164e-9));
}

TEST_CASE("data traffic: a short node's waits overlap, a long one's do not") {
  alignas(64) std::array<double, 8> one{}, other{};
  StepGraphBuilder builder;
  const PartId a = builder.add_part("a", {bytes_of(std::span(one))});
  const PartId b = builder.add_part("b", {bytes_of(std::span(other))});
  const PartId nothing = builder.add_part("nothing", {});
  builder.add_node({"both"}, {}, writes(a, b, nothing), []() noexcept {});
  builder.add_node({"nothing"}, reads(nothing), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, {100e-9, 1e-9});
  CHECK(traffic.run({0}, 0, kShort) == 0.0);
  CHECK(traffic.run({0}, 1, kShort) == approx(100e-9 + 2 * kLine));
  CHECK(traffic.run({0}, 0, 1e-6) == approx(2 * 100e-9 + 2 * kLine));
  CHECK(traffic.run({0}, 1, kShort) > 0.0);
  CHECK(traffic.run({0}, 1, kShort) == 0.0);
  CHECK(traffic.run({1}, 0, kShort) == 0.0);
}

TEST_CASE("data traffic: of a part of many records a node brings one") {
  alignas(64) std::array<double, 100> memory{};
  StepGraphBuilder builder;
  const PartId ring = builder.add_part("ring", {bytes_of(std::span(memory))}, 5 * sizeof(double));
  builder.add_node({"write"}, {}, writes(ring), []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, kPerByte);
  CHECK(traffic.run({0}, 0, kShort) == 0.0);
  CHECK(traffic.run({0}, 1, kShort) == approx(kLine));
}

TEST_CASE("data traffic: ranges on the same cache line come as one") {
  alignas(64) std::array<double, 24> memory{};
  const std::span<double> all = memory;
  StepGraphBuilder builder;
  const PartId part = builder.add_part(
      "part", {bytes_of(all.subspan(12, 2)), bytes_of(all.first(2)), bytes_of(all.subspan(4, 6))});
  builder.add_node({"write"}, {}, writes(part), []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, kPerByte);
  CHECK(traffic.run({0}, 0, kShort) == 0.0);
  CHECK(traffic.run({0}, 1, kShort) == approx(2 * kLine));
}
