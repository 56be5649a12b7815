// Tests many simulations in one process, one after the other and side by side.

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

#include "engine/simulation.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

Scenario small_scenario(int bodies, double duration) {
  Scenario scenario = spin_up_scenario(wu_haug_blade(bodies, 2), 0.01);
  scenario.integration.duration = duration;
  return scenario;
}

}  // namespace

#ifndef SPOKE_SANITIZED  // sanitizers hold freed memory back
namespace {

/// Returns the memory that the process has in use: pages in main memory [bytes].
double resident_memory() {
  double total = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void make_one(int number) {
  const ExecutorKind kind = number % 4 == 0 ? ExecutorKind::flow_graph : ExecutorKind::serial;
  Simulation simulation(small_scenario(1 + number % 3, 0.1),
                        {Formulation::structured, kind, 2, 1 + number % 5});
  const SavedState start = simulation.save();
  simulation.run_until(0.1, [](double, std::span<const double>) {});
  simulation.restore(start);
  simulation.run_until(0.1);
}

}  // namespace

TEST_CASE("1000 simulations made, run and destroyed leave no memory behind") {
  for (int number = 0; number < 200; ++number) make_one(number);
  const double before = resident_memory();
  CHECK(before > 1e6);
  for (int number = 0; number < 1000; ++number) make_one(number);
  const double grown = resident_memory() - before;
  CAPTURE(grown);
  // The limit is 500 bytes each: a leak of any table, graph or executor is far more.
  CHECK(grown < 5e5);
}
#endif

namespace {

/// Returns the hashes that a simulation passes through.
std::vector<std::uint64_t> run_alone(int number) {
  const bool is_parallel = number % 2 == 1;
  Simulation simulation(
      small_scenario(1 + number % 4, 2.0),
      {number % 3 == 0 ? Formulation::subsystem : Formulation::structured,
       is_parallel ? ExecutorKind::flow_graph : ExecutorKind::serial, 2, is_parallel ? 5 : 1});
  std::vector<std::uint64_t> hashes;
  while (!simulation.done()) {
    simulation.run_until(simulation.time() + 0.25);
    hashes.push_back(simulation.state_hash());
  }
  return hashes;
}

}  // namespace

TEST_CASE("8 simulations at once, each in a thread, have the states that they have alone") {
  constexpr int count = 8;
  std::vector<std::vector<std::uint64_t>> alone, together(count);
  for (int number = 0; number < count; ++number) alone.push_back(run_alone(number));
  std::vector<std::thread> threads;
  for (int number = 0; number < count; ++number)
    threads.emplace_back([number, &together] { together[number] = run_alone(number); });
  for (std::thread& thread : threads) thread.join();
  for (int number = 0; number < count; ++number) {
    CAPTURE(number);
    CHECK(alone[number].size() == 8);
    CHECK(alone[number] == together[number]);
  }
}
