#include "bench/compare/configuration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "models/error.h"

using namespace spoke;
using namespace spoke::compare;

namespace {

std::vector<std::string> names_of(const std::vector<Configuration>& list) {
  std::vector<std::string> names;
  for (const Configuration& configuration : list) names.push_back(name_of(configuration));
  return names;
}

bool holds(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

/// The ways of waiting of an executor on two threads, all but its name and threads.
std::vector<std::string> ways_of_waiting(ExecutorKind kind, Axes axes) {
  axes.formulations = {Formulation::structured};
  axes.executors = {kind};
  axes.threads = {2};
  const std::string plain = std::string(name_of(kind)) + " 2";
  std::vector<std::string> ways;
  for (const std::string& name : names_of(make_configurations(axes, 3, 2)))
    if (name.starts_with(plain)) ways.push_back(name.substr(plain.size()));
  return ways;
}

}  // namespace

TEST_CASE("the matrix has serial first in each formulation, once") {
  Axes axes;
  axes.executors = {ExecutorKind::flow_graph, ExecutorKind::serial};
  axes.threads = {1, 2};
  const auto list = make_configurations(axes, 3, 4);
  const std::vector<std::string> each{"serial", "flow_graph 1", "flow_graph 2"};
  std::vector<std::string> expected = each;
  expected.insert(expected.end(), each.begin(), each.end());
  CHECK(names_of(list) == expected);
  CHECK(list.front().formulation == Formulation::structured);
  CHECK(list.back().formulation == Formulation::subsystem);
}

TEST_CASE("threads are powers of two up to the processors available unless given") {
  Axes axes;
  axes.formulations = {Formulation::structured};
  axes.executors = {ExecutorKind::flow_graph};
  CHECK(names_of(make_configurations(axes, 3, 6)) ==
        std::vector<std::string>{"serial", "flow_graph 1", "flow_graph 2", "flow_graph 4",
                                 "flow_graph 6"});
  CHECK(names_of(make_configurations(axes, 3, 1)) ==
        std::vector<std::string>{"serial", "flow_graph 1"});
}

TEST_CASE("nested threads that no executor can use are refused") {
  Axes axes;
  axes.executors = {ExecutorKind::flow_graph};
  axes.threads = {2, graph::Threads(3, 2)};
  CHECK_THROWS_AS(make_configurations(axes, 3, 2), InputError);
}

TEST_CASE("waiting and binding vary for OpenMP on several threads only") {
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (kind == ExecutorKind::serial) continue;
    CAPTURE(name_of(kind));
    Axes axes;
    axes.formulations = {Formulation::structured};
    axes.executors = {kind};
    axes.threads = {1, 2};
    axes.binds = {false, true};
    CHECK(make_configurations(axes, 3, 2).size() ==
          (graph::is_openmp(kind) ? 1 + 1 + 6 : 1 + 1 + 1));
  }
}

TEST_CASE("spin counts vary for OpenMP only, with the policies asked for, the same once") {
  using Ways = std::vector<std::string>;
  const Spin by_policy, thousand{1000}, none{0}, infinite{Spin::kInfinite};
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (kind == ExecutorKind::serial) continue;
    CAPTURE(name_of(kind));
    if (!graph::is_openmp(kind)) {
      CHECK(ways_of_waiting(kind, {.spins = {by_policy, thousand, none}}) == Ways{""});
      continue;
    }
    CHECK(ways_of_waiting(kind, {.spins = {by_policy, thousand, infinite}}) ==
          Ways{"", " passive", " active", " spin 1000", " spin infinite"});
    CHECK(ways_of_waiting(kind, {.waits = {Wait::passive, Wait::active}, .spins = {thousand}}) ==
          Ways{" passive spin 1000", " active spin 1000"});
    CHECK(ways_of_waiting(kind, {.waits = {Wait::passive, Wait::active},
                                 .spins = {by_policy, none, infinite}}) ==
          Ways{" passive", " active", " active spin 0", " passive spin infinite"});
    CHECK(ways_of_waiting(kind, {.spins = {thousand}, .binds = {false, true}}) ==
          Ways{" spin 1000", " spin 1000 bound"});
  }
}

TEST_CASE("spin counts are told in the words of each runtime") {
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (!graph::is_openmp(kind)) continue;
    const auto is_told = [&](Wait wait, Spin spin, const std::string& looks,
                             const std::string& milliseconds) {
      CAPTURE(name_of(wait));
      CAPTURE(name_of(spin));
      const auto variables = environment_of({.executor = kind, .wait = wait, .spin = spin});
      CHECK(holds(variables, "GOMP_SPINCOUNT=" + looks));
      CHECK(holds(variables, "KMP_BLOCKTIME=" + milliseconds));
    };
    is_told(Wait::passive, {}, "0", "0");
    is_told(Wait::active, {}, "infinity", "infinite");
    is_told(Wait::runtime_default, {0}, "0", "0");
    is_told(Wait::runtime_default, {1}, "1", "1");
    is_told(Wait::passive, {100'000}, "100000", "1");
    is_told(Wait::active, {100'001}, "100001", "2");
    is_told(Wait::runtime_default, {Spin::kMost}, "100000000000", "1000000");
    is_told(Wait::runtime_default, {Spin::kInfinite}, "infinity", "infinite");
    for (const std::string& variable : environment_of({.executor = kind})) {
      CHECK_FALSE(variable.starts_with("GOMP_"));
      CHECK_FALSE(variable.starts_with("KMP_"));
    }
  }
}

TEST_CASE("the environment is this one without variables of OpenMP") {
  setenv("OMP_NUM_THREADS", "7", 1);
  setenv("SPOKE_TEST_VARIABLE", "kept", 1);
  const auto variables = environment_of({});
  CHECK(holds(variables, "SPOKE_TEST_VARIABLE=kept"));
  CHECK(std::none_of(variables.begin(), variables.end(),
                     [](const std::string& v) { return v.starts_with("OMP_"); }));
  for (const ExecutorKind kind : graph::executor_kinds()) {
    if (!graph::is_openmp(kind)) continue;
    const auto passive = environment_of({.executor = kind, .wait = Wait::passive, .bind = true});
    CHECK(holds(passive, "OMP_WAIT_POLICY=passive"));
    CHECK(holds(passive, "OMP_PROC_BIND=true"));
    CHECK_FALSE(holds(passive, "OMP_NUM_THREADS=7"));
  }
}
