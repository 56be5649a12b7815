// Messages of the library to the logger "spoke" of the program around it.

#include "engine/support/log.h"

#include <doctest/doctest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/rotors.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

/// The lines "level text" that a logger of the name "spoke" hears while this lives.
class Listener {
 public:
  explicit Listener(spdlog::level::level_enum level = spdlog::level::debug) {
    auto logger = std::make_shared<spdlog::logger>(
        "spoke", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_));
    logger->set_level(level);
    logger->set_pattern("%l %v");
    spdlog::register_logger(logger);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() { spdlog::drop("spoke"); }

  /// The lines that begin with `begin`, without it.
  std::vector<std::string> lines(const std::string& begin) const {
    std::istringstream stream(text_.str());
    std::vector<std::string> found;
    for (std::string line; std::getline(stream, line);)
      if (line.starts_with(begin)) found.push_back(line.substr(begin.size()));
    return found;
  }

 private:
  std::ostringstream text_;
};

/// A beam whose first body bends beyond the linear range.
Scenario bending_scenario() {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
  scenario.name = "bent";
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.loads.push_back(
      {.blade = BladeChoice::number(2), .position = 8.0, .force = {0.0, 6.0}});
  scenario.integration.duration = 2.0;
  return scenario;
}

/// Without geometric stiffening one body diverges at 10 s.
Scenario diverging_scenario() {
  Blade blade = wu_haug_blade(1, 4);
  blade.geometric_stiffening = false;
  return spin_up_scenario(blade, 0.005);
}

}  // namespace

TEST_CASE("the logger hears of the model, and only who listens to its level") {
  {
    const Listener listener;
    const Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
    const auto lines = listener.lines("info built: ");
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].starts_with("3 blades, 12 bodies, 144 coordinates, step graph of 61 nodes"));
    CHECK(lines[0].find("structured, generalized_alpha, 4000 steps of 0.005 s, serial") !=
          std::string::npos);
    CHECK(listener.lines("").size() == 1);
  }
  const Listener listener(spdlog::level::warn);
  const Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  CHECK(listener.lines("").empty());
}

TEST_CASE("a choice of the executor auto is told once") {
  const Listener listener;
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005),
                        {Formulation::structured, ExecutorKind::automatic, 1});
  for (int n = 0; n < 3; ++n) simulation.step();
  simulation.run_until(1.0);
  const auto lines = listener.lines("info executor auto: ");
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] == simulation.executor_description());
}

TEST_CASE("a warning is told once, with the words of warnings(), also if a state is restored") {
  const Listener listener;
  Simulation simulation(bending_scenario(), kSerial);
  const SavedState start = simulation.save();
  while (simulation.warnings().empty()) simulation.step();
  const std::string text = simulation.warnings()[0].text;
  simulation.run_until(2.0);
  simulation.restore(start);
  simulation.run_until(2.0);
  REQUIRE(simulation.warnings().size() == 1);
  const auto lines = listener.lines("warning bent: ");
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] == text);
  CHECK(listener.lines("debug bent: ") ==
        std::vector<std::string>{"restored a state: t = 0 s, step 0"});
}

TEST_CASE("growing energy is told to the logger") {
  // rk4 a little beyond its stability limit: the fastest vibration grows slowly.
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 1e-5);
  scenario.rotor.hub.drive = SpinUp{4.0, 0.5};
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.duration = 1.0;
  scenario.integration.step =
      1.02 * Simulation(scenario, kSerial).linear_properties().rk4_largest_step;
  const Listener listener;
  Simulation simulation(scenario, kSerial);
  const auto has_grown = [&] {
    const std::vector<Warning> warnings = simulation.warnings();
    return !warnings.empty() && warnings.back().kind == WarningKind::energy_growth;
  };
  while (!has_grown() && !simulation.done())
    simulation.run_until(simulation.time() + 0.001, [](double, std::span<const double>) {});
  const auto is_growth = [](const std::string& line) {
    return line.find("the energy has grown by ") != std::string::npos;
  };
  const auto lines = listener.lines("warning ");
  CHECK(std::count_if(lines.begin(), lines.end(), is_growth) == 1);
}

TEST_CASE("a divergence and the failure of a load are told as errors") {
  const Listener listener;
  Simulation simulation(diverging_scenario(), kSerial);
  CHECK_THROWS_AS(simulation.run_until(20.0), DivergenceError);
  REQUIRE(listener.lines("error ").size() == 1);
  CHECK(listener.lines("error ")[0].find("blade 1 / body 1") != std::string::npos);

  const auto broken = make_load("broken", {Marker{}}, [](double, auto, auto) { throw 1; });
  CHECK_THROWS_AS(Simulation(diverging_scenario(), kSerial, {broken}), LoadError);
  REQUIRE(listener.lines("error ").size() == 2);
  CHECK(listener.lines("error ")[1].starts_with("the load \"broken\" of blade 1 failed"));
}

TEST_CASE("checkpoints are told of as they are written and read") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "state.spoke";
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 0.005), kSerial);
  simulation.run_until(0.5);
  const Listener listener;
  save_checkpoint(file, simulation.save());
  simulation.restore(load_checkpoint(file).state);
  const auto lines = listener.lines("debug ");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].starts_with(file.string() + ": wrote a checkpoint: t = 0.5 s, step 100, "));
  CHECK(lines[1].starts_with(file.string() + ": read a checkpoint: t = 0.5 s, step 100, "));
  CHECK(lines[2] == "restored a state: t = 0.5 s, step 100");
}

TEST_CASE("simulations in several threads share the logger") {
  const Listener listener;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([] {
      Simulation simulation(bending_scenario(), kSerial);
      simulation.run_until(2.0);
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(listener.lines("info bent: built: ").size() == 4);
  CHECK(listener.lines("warning bent: blade 2 / body 1 bends by ").size() == 4);
}

TEST_CASE("without the logger nothing is written to the terminal") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "output";
  const pid_t child = fork();
  if (child == 0) {
    // NOLINTNEXTLINE: what is written to either goes to the file
    if (!std::freopen(file.c_str(), "w", stdout) || dup2(fileno(stdout), 2) < 0) _exit(3);
    int status = 1;
    try {
      Simulation simulation(bending_scenario(), kSerial);
      simulation.run_until(2.0);
      Simulation(diverging_scenario(), kSerial).run_until(20.0);
    } catch (const DivergenceError&) {
      status = 0;
    }
    std::fflush(stdout);
    _exit(status);
  }
  int status = -1;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(std::filesystem::file_size(file) == 0);
}
