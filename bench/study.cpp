// How many runs a second does a study make? One process on two threads, and two ranks where there
// is an mpirun, against two processes at once that make half of the runs each on one thread; and
// one process on one thread against the steps of its simulations, built beforehand: reading,
// building and writing are what a study costs beside them. That comparison runs within this
// program, where both sides have the same code: in the program `spoke`, another code layout changes
// steps by some per cent. Ranks make more runs than threads: mpirun takes a third of a second to
// start them, which is no part of a rate. Each comparison is made within one round.

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
#include "program/study/runner.h"
#include "program/study/study_reader.h"

namespace spoke::bench {
namespace {

namespace fs = std::filesystem;

const std::string kModel = SPOKE_MODELS_DIR "/wu_haug_rotor.toml";
constexpr double kLow = 6.0, kMiddle = 7.0, kHigh = 8.0;  // lengths of the blades [m]

/// Writes a study of so many values of the blades' length.
std::string write_study(const fs::path& folder, const std::string& name, int runs, double low,
                        double high) {
  const fs::path file = folder / (name + ".toml");
  std::ofstream(file) << "scenario = \"" << kModel << "\"\ndesign = { kind = \"grid\" }\n"
                      << "[[parameter]]\nkey = \"blade.length\"\nrange = [" << low << ", " << high
                      << ", " << runs << "]\n"
                      << "[[response]]\nsensor = \"blade1.tip.y\"\nkind = \"min\"\n";
  return file.string();
}

std::vector<std::string> study_words(const std::string& file, const fs::path& out, int threads) {
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

std::vector<Built> build_all(int runs) {
  std::vector<Built> all;
  for (int k = 0; k < runs; ++k) all.emplace_back(kLow + (kHigh - kLow) * k / (runs - 1));
  return all;
}

/// Makes only the steps of a study.
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

/// Runs through a shell: the program's command line behind mpirun's.
void run_on_two_ranks(const std::vector<std::string>& words) {
  std::string command =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n 2 "
      "\"" SPOKE_PROGRAM_FILE "\"";
  for (const std::string& word : words) command += " \"" + word + '"';
  if (std::system(command.c_str()) != 0) throw std::runtime_error("mpirun fails");
}

/// A study of the length of blades as a whole, and the two studies of its halves.
struct Studies {
  Studies(const fs::path& in, int of_runs)
      : folder(in),
        runs(of_runs),
        whole(write_study(in, "whole" + std::to_string(runs), runs, kLow, kHigh)),
        first(write_study(in, "first" + std::to_string(runs), runs / 2, kLow, kMiddle)),
        second(write_study(in, "second" + std::to_string(runs), runs / 2, kMiddle, kHigh)) {}

  void make(const std::string& file, int threads) const {
    seconds_of_process(study_words(file, folder / fs::path(file).stem(), threads));
  }
  void make_as_two_processes() const {
    std::thread other([&] { make(second, 1); });
    make(first, 1);
    other.join();
  }
  void make_within_this_program() const {
    study::Study read = study::read_study(whole);
    study::check_study(read);
    const study::Sampling sampling(read);
    study::Journal journal((folder / "journal").string(), read, study::Journal::Start::anew);
    study::JournalExchange exchange(journal, runs, [](std::int64_t) { return true; });
    study::make_runs(read, sampling, 1, exchange);
  }
  void make_on_two_ranks() const { run_on_two_ranks(study_words(whole, folder / "ranks", 1)); }

  fs::path folder;
  int runs;
  std::string whole, first, second;
};

const std::string kTwoProcesses = "two processes, half of the runs each";

void add_table(const Studies& studies, const std::vector<Timing>& timings, Report& report) {
  Table table{"A study of " + std::to_string(studies.runs) + " runs of the shipped rotor",
              {"what", "time", "runs a second", "time by its reference"},
              {}};
  for (const Timing& timing : timings) {
    table.rows.push_back({timing.name, graph::duration_text(timing.median),
                          figure(studies.runs / timing.median), figure(timing.ratio)});
    report.add_timing("wu_haug_rotor", timing);
  }
  report.add_table(table);
}

void measure_threads(const Studies& studies, bool quick, Report& report) {
  std::vector<Built> built = build_all(studies.runs);
  std::vector<Alternative> alternatives = {
      {kTwoProcesses, [&] { studies.make_as_two_processes(); }, {}},
      {"a study on two threads", [&] { studies.make(studies.whole, 2); }, {}},
      {"the steps of the simulations alone", [&] { step_all(built); }, {}},
      {"a study on one thread", [&] { studies.make_within_this_program(); }, {}},
      {"the same as a process", [&] { studies.make(studies.whole, 1); }, {}}};
  alternatives[2].reference = 2;
  alternatives[3].reference = 2;
  alternatives[4].reference = 2;
  const std::vector<Timing> timings =
      measure(alternatives, {.rounds = quick ? 3 : 7, .most_seconds = 120.0});
  add_table(studies, timings, report);
  report.add_target(at_least("runs a second on two threads, by those of two processes",
                             1.0 / timings[1].ratio, 0.93));
  report.add_target(
      at_most("time of a study on one thread by that of its steps", timings[3].ratio, 1.03));
}

void measure_ranks(const Studies& studies, bool quick, Report& report) {
  const std::vector<Timing> timings =
      measure({{kTwoProcesses, [&] { studies.make_as_two_processes(); }, {}},
               {"a study on two ranks", [&] { studies.make_on_two_ranks(); }, {}}},
              {.rounds = quick ? 2 : 5, .most_seconds = 120.0});
  add_table(studies, timings, report);
  report.add_target(at_least("runs a second on two ranks, by those of two processes",
                             1.0 / timings[1].ratio, 0.93));
}

}  // namespace

void measure_study(const QuestionOptions& options, Report& report) {
  const ResultsFolder folder;
  show_progress("study");
  measure_threads(Studies(folder.path(), options.quick ? 20 : 200), options.quick, report);
  if (!has_mpirun()) return;
  show_progress("study on ranks");
  measure_ranks(Studies(folder.path(), options.quick ? 60 : 600), options.quick, report);
}

}  // namespace spoke::bench
