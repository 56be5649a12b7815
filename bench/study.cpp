// How many runs a second does a study make? One process on two threads, and two ranks where there
// is an mpirun, against two processes at once that make half of the runs each on one thread; and
// one process on one thread against the steps of its simulations, built beforehand: reading,
// building and writing are what a study costs beside them. All within one round.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/results_folder.h"
#include "bench/whole_processes.h"
#include "engine/simulation.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

namespace fs = std::filesystem;

const std::string kModel = SPOKE_MODELS_DIR "/wu_haug_rotor.toml";

/// A study of so many values of the blades' length.
std::string write_study(const fs::path& folder, const std::string& name, int runs, double low,
                        double high) {
  const fs::path file = folder / (name + ".toml");
  std::ofstream(file) << "scenario = \"" << kModel << "\"\ndesign = { kind = \"grid\" }\n"
                      << "[[parameter]]\nkey = \"blade.length\"\nrange = [" << low << ", " << high
                      << ", " << runs << "]\n"
                      << "[[response]]\nsensor = \"blade1.tip.y\"\nkind = \"min\"\n";
  return file.string();
}

std::vector<std::string> study(const std::string& file, const fs::path& out, int threads) {
  return {"study", file, "--out", out.string(), "--quiet", "--threads", std::to_string(threads)};
}

/// A simulation of a study before its first step.
struct Built {
  explicit Built(double length)
      : simulation(read_scenario(kModel, {"blade.length=" + std::to_string(length)}), options()),
        start(simulation.save()) {}

  static SimulationOptions options() {
    SimulationOptions serial;
    serial.executor = ExecutorKind::serial;
    serial.threads = {1, 1};
    return serial;
  }

  Simulation simulation;
  SavedState start;
};

std::vector<Built> build_all(int runs, double low, double high) {
  std::vector<Built> all;
  for (int k = 0; k < runs; ++k) all.emplace_back(low + (high - low) * k / (runs - 1));
  return all;
}

/// The steps of a study and nothing else.
void step_all(std::vector<Built>& all) {
  for (Built& built : all) {
    double least = 0.0;
    const std::size_t sensor = built.simulation.sensor_index("blade1.tip.y");
    built.simulation.restore(built.start);
    built.simulation.run_until(
        std::numeric_limits<double>::infinity(),
        [&](double, std::span<const double> values) { least = std::min(least, values[sensor]); });
  }
}

bool has_mpirun() { return std::system("command -v mpirun >/dev/null 2>&1") == 0; }

/// Through a shell: the program's command line behind mpirun's.
void run_on_two_ranks(const std::vector<std::string>& words) {
  std::string command =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n 2 "
      "\"" SPOKE_PROGRAM_FILE "\"";
  for (const std::string& word : words) command += " \"" + word + '"';
  if (std::system(command.c_str()) != 0) throw std::runtime_error("mpirun fails");
}

}  // namespace

void measure_study(const QuestionOptions& options, Report& report) {
  const ResultsFolder folder;
  const fs::path& here = folder.path();
  const int runs = options.quick ? 20 : 200;
  constexpr double low = 6.0, middle = 7.0, high = 8.0;
  const std::string whole = write_study(here, "whole", runs, low, high);
  const std::string first = write_study(here, "first", runs / 2, low, middle);
  const std::string second = write_study(here, "second", runs / 2, middle, high);
  const auto run = [&](const std::string& file, int threads) {
    seconds_of_process(study(file, here / fs::path(file).stem(), threads));
  };
  std::vector<Built> built = build_all(runs, low, high);
  std::vector<Alternative> alternatives = {
      {"two processes, half of the runs each",
       [&] {
         std::thread other([&] { run(second, 1); });
         run(first, 1);
         other.join();
       },
       {}},
      {"a study on two threads", [&] { run(whole, 2); }, {}},
      {"the steps of the simulations alone", [&] { step_all(built); }, {}},
      {"a study on one thread", [&] { run(whole, 1); }, {}}};
  alternatives[2].reference = 2;
  alternatives[3].reference = 2;
  if (has_mpirun())
    alternatives.push_back(
        {"a study on two ranks", [&] { run_on_two_ranks(study(whole, here / "ranks", 1)); }, {}});
  show_progress("study");
  const std::vector<Timing> timings =
      measure(alternatives, {.rounds = options.quick ? 3 : 7, .most_seconds = 120.0});
  Table table{"A study of " + std::to_string(runs) + " runs of the shipped rotor",
              {"what", "time", "runs a second", "time by its reference"},
              {}};
  for (const Timing& timing : timings) {
    table.rows.push_back({timing.name, graph::duration_text(timing.median),
                          figure(runs / timing.median), figure(timing.ratio)});
    report.add_timing("wu_haug_rotor", timing);
  }
  report.add_table(table);
  report.add_target(at_least("runs a second on two threads, by those of two processes",
                             1.0 / timings[1].ratio, 0.93));
  report.add_target(
      at_most("time of a study on one thread by that of its steps", timings[3].ratio, 1.03));
  if (timings.size() > 4)
    report.add_target(at_least("runs a second on two ranks, by those of two processes",
                               1.0 / timings[4].ratio, 0.93));
}

}  // namespace spoke::bench
