// Writes a blade of a scenario as files of BeamDyn, ElastoDyn or AeroDyn.

#include "program/cli/export_command.h"

#include <filesystem>

#include "engine/output_file.h"
#include "models/scenario.h"
#include "program/cli/file_guard.h"
#include "program/cli/report.h"
#include "program/foreign/export_aerodyn.h"
#include "program/foreign/export_beamdyn.h"
#include "program/foreign/export_elastodyn.h"

namespace spoke::cli {

namespace {

namespace fs = std::filesystem;

/// Returns the name of a file beside the first one: "x.dat" has "x_blade.dat".
std::string name_beside(const fs::path& first, const std::string& what) {
  return first.stem().string() + '_' + what + first.extension().string();
}

foreign::ExportedFiles export_files(const Scenario& scenario, const ExportArguments& own,
                                    const fs::path& first) {
  const std::string name = first.filename().string();
  const auto blade = static_cast<std::size_t>(own.blade);
  if (own.format == "elastodyn")
    return foreign::export_elastodyn(scenario, blade, name, name_beside(first, "tower"));
  if (own.format == "aerodyn")
    return foreign::export_aerodyn(scenario, blade, name, name_beside(first, "blade"),
                                   [&](const std::string& of) { return name_beside(first, of); });
  const std::string beside = name_beside(first, "blade");
  foreign::BeamDynFiles files = foreign::export_beamdyn(scenario, blade, beside);
  return {{{name, files.primary}, {beside, files.blade}}, files.left_out};
}

}  // namespace

int export_blade(const Arguments& arguments, const ExportArguments& own) {
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  const fs::path first = arguments.out;
  const foreign::ExportedFiles exported = export_files(scenario, own, first);
  std::vector<FileText> files;
  std::string names;
  for (const foreign::SourceFile& file : exported.files) {
    const fs::path place = first.parent_path() / file.name;
    require_place(place, kExportedFile);
    files.insert(files.begin(), {place.string(), file.text});  // the first one last
    names += names.empty() ? first.string() : ", " + file.name;
  }
  replace_files(files);
  print_title(scenario.title);
  for (std::size_t i = 0; i < exported.left_out.size(); ++i)
    print_line(i == 0 ? "left out" : "", exported.left_out[i]);
  print_line("written", names);
  return 0;
}

}  // namespace spoke::cli
