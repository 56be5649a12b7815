// Reads the scenario, and writes to the folder.

#include "program/cli/steady_task.h"

#include "engine/output_file.h"
#include "program/cli/file_guard.h"
#include "program/cli/interruption.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {

SteadyTask::SteadyTask(const Arguments& arguments, const std::string& command,
                       const std::vector<std::string>& files)
    : file_(arguments.scenario),
      scenario_(read_scenario(arguments.scenario, arguments.overrides)),
      folder_(arguments.out.empty() ? std::filesystem::path("results") / scenario_.name / command
                                    : std::filesystem::path(arguments.out)) {
  require_folder(folder_, files);
  warn_of_oddities(file_, scenario_);
}

const std::string& SteadyTask::title() const {
  return scenario_.title.empty() ? scenario_.name : scenario_.title;
}

void SteadyTask::write(const std::vector<File>& files) const {
  const ResultsFolder taken(folder_);
  for (const File& file : files) require_places(folder_, {file.name});  // as they are by now
  write_together([&] {
    for (const File& file : files) replace_file(path(file.name), file.text);
  });
}

void SteadyTask::warn(const EquilibriumResult& result) {
  for (const Warning& warning : result.warnings) print_error("warning: " + warning.text);
}

}  // namespace spoke::cli
