// Writes a blade of a scenario as BeamDyn's two files.

#include "program/cli/export_command.h"

#include <filesystem>

#include "engine/output_file.h"
#include "models/scenario.h"
#include "program/cli/file_guard.h"
#include "program/cli/report.h"
#include "program/foreign/export_beamdyn.h"

namespace spoke::cli {

int export_blade(const Arguments& arguments, const ExportArguments& own) {
  namespace fs = std::filesystem;
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  const fs::path primary = arguments.out;
  const fs::path blade =
      primary.parent_path() / (primary.stem().string() + "_blade" + primary.extension().string());
  for (const fs::path& file : {primary, blade}) require_place(file, kBeamDynFile);
  const foreign::BeamDynFiles files = foreign::export_beamdyn(
      scenario, static_cast<std::size_t>(own.blade), blade.filename().string());
  replace_files({{blade.string(), files.blade}, {primary.string(), files.primary}});
  print_title(scenario.title);
  for (std::size_t i = 0; i < files.left_out.size(); ++i)
    print_line(i == 0 ? "left out" : "", files.left_out[i]);
  print_line("written", primary.string() + ", " + blade.filename().string());
  return 0;
}

}  // namespace spoke::cli
