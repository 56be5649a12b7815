#include "graph/declaration_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "graph/executor.h"
#include "tests/graph/arithmetic_graph.h"

using namespace spoke::graph;
using spoke::graph::testing::build_graph;
using spoke::graph::testing::GraphPlan;
using spoke::graph::testing::make_random_plan;

namespace {

// Three parts of two values, for one node to be checked.
struct Bench {
  std::array<double, 2> a{1.0, 2.0};
  std::array<double, 2> b{3.0, 4.0};
  std::array<double, 2> c{5.0, 6.0};
  StepGraphBuilder builder{"blade"};
  PartId part_a = builder.add_part("a", {bytes_of(a)});
  PartId part_b = builder.add_part("b", {bytes_of(b)});
  PartId part_c = builder.add_part("c", {bytes_of(c)});

  template <class Body>
  std::vector<DeclarationFault> check(Reads r, Writes w, Body body) {
    builder.add_node({"sum", 1}, std::move(r), std::move(w), body);
    return check_declarations(builder.build());
  }
};

bool same_bits(const GraphPlan& x, const GraphPlan& y) {
  return std::equal(x.memory.begin(), x.memory.end(), y.memory.begin(),
                    [](const std::vector<double>& p, const std::vector<double>& q) {
                      return std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0;
                    });
}

void erase(std::vector<PartId>& parts, PartId part) {
  parts.erase(std::find(parts.begin(), parts.end(), part));
}

}  // namespace

TEST_CASE("honest declarations show no fault, and the parts hold what a serial run leaves") {
  GraphPlan checked = make_random_plan(7, 60, 20, 5);
  GraphPlan plain = checked;
  const StepGraph checked_graph = build_graph(checked);
  const StepGraph plain_graph = build_graph(plain);
  CHECK(check_declarations(checked_graph).empty());
  make_executor(plain_graph, ExecutorKind::serial)->run();
  CHECK(same_bits(checked, plain));
}

TEST_CASE("an undeclared read is named") {
  Bench bench;
  const auto faults = bench.check(reads(bench.part_a), writes(bench.part_c), [&bench]() noexcept {
    for (std::size_t i = 0; i < 2; ++i) bench.c[i] = bench.a[i] + bench.b[i];
  });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::undeclared_read);
  CHECK(faults[0].node == NodeId{0});
  CHECK(faults[0].part == bench.part_b);
  CHECK(faults[0].message == "node \"blade 2 / sum\" reads part \"b\" without declaring it.");
  CHECK(bench.c == std::array{4.0, 6.0});
  CHECK(bench.b == std::array{3.0, 4.0});
}

TEST_CASE("an undeclared read that only decides a branch is named") {
  for (const double deciding : {-3.0, 3.0}) {
    CAPTURE(deciding);
    Bench bench;
    bench.b[0] = deciding;
    const auto faults = bench.check({}, writes(bench.part_c), [&bench]() noexcept {
      bench.c.fill(bench.b[0] > 0.0 ? 1.0 : -1.0);
    });
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == FaultKind::undeclared_read);
    CHECK(faults[0].part_name == "b");
  }
}

TEST_CASE("a part declared as only written must not be updated in place") {
  Bench bench;
  const auto faults = bench.check(reads(bench.part_a), writes(bench.part_c), [&bench]() noexcept {
    for (std::size_t i = 0; i < 2; ++i) bench.c[i] += bench.a[i];
  });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::undeclared_read);
  CHECK(faults[0].part_name == "c");
  CHECK(bench.c == std::array{6.0, 8.0});
}

TEST_CASE("undeclared writes are named, whether of an undeclared or of a read part") {
  Bench bench;
  const auto faults = bench.check(reads(bench.part_a), writes(bench.part_c), [&bench]() noexcept {
    bench.c = bench.a;
    bench.a[1] = 7.0;
    bench.b[0] = 3.0;  // the value it has already
  });
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].kind == FaultKind::undeclared_write);
  CHECK(faults[0].part_name == "a");
  CHECK(faults[1].kind == FaultKind::undeclared_write);
  CHECK(faults[1].part_name == "b");
  CHECK(bench.a == std::array{1.0, 7.0});
}

TEST_CASE("an undeclared sum in place is an undeclared write, though poison hides it") {
  Bench bench;
  const auto faults = bench.check({}, {}, [&bench]() noexcept { bench.b[0] += 1.0; });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::undeclared_write);
  CHECK(bench.b[0] == 4.0);
}

TEST_CASE("an undeclared write that only the real data provoke is named") {
  Bench bench;
  const auto faults = bench.check({}, {}, [&bench]() noexcept {
    if (bench.b[0] == 3.0) bench.b[0] = 8.0;
  });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::undeclared_write);
  CHECK(faults[0].part_name == "b");
}

TEST_CASE("an output left unwritten in part is a fault, and is kept as found") {
  Bench bench;
  const auto faults = bench.check(reads(bench.part_a), writes(bench.part_c),
                                  [&bench]() noexcept { bench.c[1] = bench.a[0]; });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::unwritten_output);
  CHECK(faults[0].part_name == "c");
  CHECK(faults[0].message.find("8 of its 16 bytes") != std::string::npos);
  CHECK(bench.c == std::array{5.0, 1.0});
}

TEST_CASE("a result that depends on memory outside the parts is a fault") {
  Bench bench;
  int runs = 0;
  const auto faults = bench.check({}, writes(bench.part_c), [&bench, &runs]() noexcept {
    bench.c.fill(static_cast<double>(++runs));
  });
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::hidden_state);
  CHECK(faults[0].node_name == "blade 2 / sum");
  CHECK(bench.c == std::array{1.0, 1.0});
}

TEST_CASE("an undeclared read of a whole number, of an enumeration or of a single byte is named") {
  enum class Choice { first, second };
  struct Data {
    int number = 0;
    Choice choice = Choice::second;
    std::int64_t step = 7;
    std::uint8_t flag = 0;
  } data;
  double result = 0.0;
  for (int which = 0; which < 4; ++which) {
    CAPTURE(which);
    StepGraphBuilder builder;
    const PartId read = which == 0   ? builder.add_part("read", {bytes_of(data.number)})
                        : which == 1 ? builder.add_part("read", {bytes_of(data.choice)})
                        : which == 2 ? builder.add_part("read", {bytes_of(data.step)})
                                     : builder.add_part("read", {bytes_of(data.flag)});
    const PartId written = builder.add_part("written", {bytes_of(result)});
    builder.add_node({"node"}, reads(), writes(written), [&data, &result, which]() noexcept {
      result = which == 0   ? data.number + 1.0
               : which == 1 ? (data.choice == Choice::second ? 2.0 : 3.0)
               : which == 2 ? static_cast<double>(data.step)
                            : (data.flag != 0 ? 4.0 : 5.0);
    });
    const auto faults = check_declarations(builder.build());
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == FaultKind::undeclared_read);
    CHECK(faults[0].part == read);
  }
  CHECK(result == 5.0);
  CHECK(data.step == 7);
}

TEST_CASE("a byte that is left unwritten is found, whatever the others hold") {
  std::array<std::uint8_t, 3> bytes{};
  StepGraphBuilder builder;
  const PartId part = builder.add_part("bytes", {bytes_of(bytes)});
  builder.add_node({"node"}, {}, writes(part), [&bytes]() noexcept { bytes[0] = bytes[2] = 1; });
  const auto faults = check_declarations(builder.build());
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::unwritten_output);
  CHECK(faults[0].message.find("1 of its 3 bytes") != std::string::npos);
}

TEST_CASE("a not-a-number in honest data is no fault") {
  Bench bench;
  bench.a[0] = std::numeric_limits<double>::quiet_NaN();
  const auto faults = bench.check(reads(bench.part_a), writes(bench.part_c),
                                  [&bench]() noexcept { bench.c = bench.a; });
  CHECK(faults.empty());
}

TEST_CASE("parts that share memory are reported before any node runs") {
  std::array<double, 4> memory{};
  const std::span<double> all = memory;
  StepGraphBuilder builder;
  builder.add_part("x", {bytes_of(all.first(3))});
  const PartId y = builder.add_part("y", {bytes_of(all.last(2))});
  builder.add_node({"write"}, {}, writes(y), [&memory]() noexcept { memory.fill(1.0); });
  const auto faults = check_declarations(builder.build());
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::overlapping_parts);
  CHECK(faults[0].message == "part \"y\" shares memory with part \"x\".");
  CHECK(memory[2] == 0.0);
}

TEST_CASE("random graphs: every removal of one declared read is caught and named") {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const GraphPlan honest = make_random_plan(seed, 25, 8, 3);
    for (std::size_t i = 0; i < honest.nodes.size(); ++i) {
      for (const PartId part : honest.nodes[i].reads) {
        CAPTURE(seed);
        CAPTURE(i);
        CAPTURE(part.index);
        GraphPlan plan = honest;
        erase(plan.nodes[i].declared_reads, part);
        const auto faults = check_declarations(build_graph(plan));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].kind == FaultKind::undeclared_read);
        CHECK(faults[0].node.index == static_cast<int>(i));
        CHECK(faults[0].part == part);
      }
    }
  }
}

TEST_CASE("random graphs: every removal of one declared write is caught and named") {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const GraphPlan honest = make_random_plan(seed, 25, 8, 3);
    for (std::size_t i = 0; i < honest.nodes.size(); ++i) {
      for (const PartId part : honest.nodes[i].writes) {
        CAPTURE(seed);
        CAPTURE(i);
        CAPTURE(part.index);
        GraphPlan plan = honest;
        erase(plan.nodes[i].declared_writes, part);
        const auto faults = check_declarations(build_graph(plan));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].kind == FaultKind::undeclared_write);
        CHECK(faults[0].node.index == static_cast<int>(i));
        CHECK(faults[0].part == part);
      }
    }
  }
}

TEST_CASE("the check of one node finds what the check of all finds there, and leaves the rest") {
  const GraphPlan honest = make_random_plan(2, 25, 8, 3);
  for (std::size_t i = 0; i < honest.nodes.size(); ++i) {
    if (honest.nodes[i].reads.empty()) continue;
    CAPTURE(i);
    GraphPlan plan = honest;
    erase(plan.nodes[i].declared_reads, plan.nodes[i].reads.front());
    const StepGraph graph = build_graph(plan);
    const NodeId faulty{static_cast<int>(i)};
    const NodeId other{static_cast<int>((i + 1) % honest.nodes.size())};
    CHECK(check_declaration(graph, other).empty());
    reset_memory(plan);
    REQUIRE(check_declaration(graph, faulty).size() == 1);
    reset_memory(plan);
    CHECK(check_declaration(graph, faulty)[0].kind == FaultKind::undeclared_read);
  }
}
