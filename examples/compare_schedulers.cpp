// All executors on one model: the time of a step, and a check that the bits are the same.

#include <spoke/spoke.h>

#include <chrono>
#include <cstdio>

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
drive = { kind = "spin_up", speed = 4.0, ramp = 15.0 }
[blade]
count = 3
length = 8.0
bodies = 4
elements = 16
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.005
duration = 2.0
)",
                                                         "compare_schedulers");
  std::uint64_t first = 0;
  bool is_equal = true;
  for (const spoke::ExecutorKind kind : spoke::graph::executor_kinds()) {
    spoke::Simulation simulation(scenario, {.executor = kind, .threads = 2, .window = 10});
    const auto begin = std::chrono::steady_clock::now();
    simulation.run_until(2.0);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const std::uint64_t hash = simulation.state_hash();
    std::printf("%-15s %8.1f us a step, state %016llx\n",
                std::string(simulation.executor_name()).c_str(),
                1e6 * took.count() / static_cast<double>(simulation.steps()),
                static_cast<unsigned long long>(hash));
    if (first == 0) first = hash;
    is_equal &= hash == first;
  }
  return is_equal ? 0 : 1;
}
