// What does the program take beyond its integration? Commands are started as processes, as a user
// starts them: the shipped rotor is run with a step so large that it integrates for some
// milliseconds, with and without report.html; `check` and `--version` integrate nothing.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/results_folder.h"
#include "bench/whole_processes.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

namespace fs = std::filesystem;

struct Command {
  std::string name;
  std::vector<std::string> words;
  bool integrates = true;
  double most = 0.0;             ///< promised time [s]; 0: none
  std::vector<double> beyond{};  ///< times of the process without its integration [s]
  std::vector<double> whole{};   ///< [s]
};

std::vector<Command> make_commands(const fs::path& folder) {
  const std::string model = SPOKE_MODELS_DIR "/wu_haug_rotor.toml";
  const std::vector<std::string> run{"run",   model,           "--set",  "integration.step=0.05",
                                     "--out", folder.string(), "--quiet"};
  std::vector<std::string> without_report = run;
  without_report.emplace_back("--no-report");
  return {{"run --no-report", without_report, true, 0.01},
          {"run", run, true, 0.01},
          {"check", {"check", model}, false},
          {"--version", {"--version"}, false}};
}

/// Returns the time of the integration that the run reports [s].
double integration_time(const fs::path& folder) {
  std::ifstream file(folder / "summary.json");
  return nlohmann::json::parse(file).at("wall_time_s").get<double>();
}

void measure_once(Command& command, const fs::path& folder) {
  const double taken = seconds_of_process(command.words);
  command.whole.push_back(taken);
  command.beyond.push_back(taken - (command.integrates ? integration_time(folder) : 0.0));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void measure_start_up(const QuestionOptions& options, Report& report) {
  const ResultsFolder folder;
  std::vector<Command> commands = make_commands(folder.path());
  const int rounds = options.quick ? 5 : 41;
  show_progress("start_up");
  for (int round = 0; round <= rounds; ++round) {
    for (Command& command : commands) {
      measure_once(command, folder.path());
      if (round > 0) continue;  // the first start reads the program from the disk
      command.whole.clear();
      command.beyond.clear();
    }
  }
  Table table{"What the program takes beyond its integration, the shipped rotor",
              {"command", "beyond", "least", "whole"},
              {}};
  for (const Command& command : commands) {
    const double beyond = median(command.beyond);
    const double least = *std::min_element(command.beyond.begin(), command.beyond.end());
    table.rows.push_back({command.name, graph::duration_text(beyond), graph::duration_text(least),
                          graph::duration_text(median(command.whole))});
    report.add_result({{"command", command.name}, {"beyond_s", beyond}, {"least_s", least}});
    if (command.most > 0.0)
      report.add_target(
          at_most("spoke " + command.name + " beyond its integration [s]", beyond, command.most));
  }
  report.add_table(table);
}

}  // namespace spoke::bench
