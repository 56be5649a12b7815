// Embeds Spoke as an engineer would, and compares numbers with what is known of them.
#include <spoke/spoke.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "outside: failed: %s\n", what);
  ++failures;
}

// The tip lags most by 0.534111 m (exact Euler-Bernoulli beam), at about 6.76 s.
void check_spin_up(const char* file) {
  const spoke::Scenario scenario = spoke::read_scenario(file, {"integration.duration=8"});
  spoke::Simulation simulation(scenario, {.executor = spoke::ExecutorKind::flow_graph});
  double lowest = 0.0, when = 0.0;
  while (!simulation.done()) {
    simulation.step();
    const double tip = simulation.sensor("blade1.tip.y");
    if (tip < lowest) {
      lowest = tip;
      when = simulation.time();
    }
  }
  check(std::abs(lowest + 0.534111) < 5e-5, "largest lag of the tip");
  check(std::abs(when - 6.765) < 0.02, "time of the largest lag");
  check(std::abs(simulation.time() - 8.0) < 1e-9, "the end of the run");
}

// A state that was saved gives the same bits again, on another executor.
void check_restore(const char* file) {
  const spoke::Scenario scenario = spoke::read_scenario(file);
  spoke::Simulation simulation(scenario, {.executor = spoke::ExecutorKind::serial});
  simulation.run_until(0.5);
  const spoke::SavedState state = simulation.save();
  simulation.run_until(1.0);
  spoke::Simulation other(scenario, {.executor = spoke::ExecutorKind::automatic});
  other.restore(state);
  other.run_until(1.0);
  check(other.state_hash() == simulation.state_hash(), "bits after a restored state");
}

// For the comparison with another compiler's program.
void print_state(const char* file) {
  const spoke::Scenario scenario = spoke::read_scenario(file, {"integration.duration=4"});
  spoke::Simulation simulation(scenario, {.executor = spoke::ExecutorKind::serial});
  while (!simulation.done()) simulation.step();
  std::printf("outside: state_hash %#018llx\n",
              static_cast<unsigned long long>(simulation.state_hash()));
}

// Exceptions and the checks of types cross the border of the library.
void check_errors() {
  bool caught = false;
  try {
    spoke::parse_scenario("[blade]\nlength = -1.0\n", "from_code");
  } catch (const spoke::InputError& error) {
    caught = error.what()[0] != '\0';
  }
  check(caught, "a wrong scenario throws InputError with a message");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    check_spin_up(argv[1]);
    check_restore(argv[1]);
    check_errors();
    print_state(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "outside: %s\n", error.what());
    return 1;
  }
  if (failures == 0) std::puts("outside: all numbers are right");
  return failures == 0 ? 0 : 1;
}
