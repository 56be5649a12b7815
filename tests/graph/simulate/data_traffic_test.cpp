#include "graph/simulate/data_traffic.h"

#include <doctest/doctest.h>

#include <array>
#include <span>

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
    const PartId data = builder.add_part("data", {bytes_of(std::span(memory))});
    const PartId nothing = builder.add_part("nothing", {});
    builder.add_node({"write"}, {}, writes(data, nothing), []() noexcept {});
    builder.add_node({"read"}, reads(data, nothing), {}, []() noexcept {});
    return builder.build();
  }
};

}  // namespace

TEST_CASE("data traffic: what another processor wrote is waited for once") {
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

TEST_CASE("data traffic: each part takes a latency and its bytes, one without memory nothing") {
  std::array<double, 8> one{}, other{};
  StepGraphBuilder builder;
  const PartId a = builder.add_part("a", {bytes_of(std::span(one))});
  const PartId b =
      builder.add_part("b", {bytes_of(std::span(other)), bytes_of(std::span(one).first(2))});
  const PartId nothing = builder.add_part("nothing", {});
  builder.add_node({"both"}, reads(a), writes(b, nothing), []() noexcept {});
  builder.add_node({"nothing"}, reads(nothing), {}, []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, {100e-9, 1e-9});
  CHECK(traffic.run({0}, 0) == 0.0);
  CHECK(traffic.run({0}, 1) == approx(2 * 100e-9 + (8 + 10) * 8e-9));
  CHECK(traffic.run({0}, 1) == 0.0);
  CHECK(traffic.run({0}, 0) == approx(100e-9 + 10 * 8e-9));  // "a" was only read
  CHECK(traffic.run({1}, 1) == 0.0);
}

TEST_CASE("data traffic: of a part of many records a node brings one") {
  std::array<double, 100> memory{};
  StepGraphBuilder builder;
  const PartId ring = builder.add_part("ring", {bytes_of(std::span(memory))}, 5 * sizeof(double));
  builder.add_node({"write"}, {}, writes(ring), []() noexcept {});
  const StepGraph graph = builder.build();
  DataTraffic traffic(graph, kPerByte);
  CHECK(traffic.run({0}, 0) == 0.0);
  CHECK(traffic.run({0}, 1) == approx(40e-9));
}
