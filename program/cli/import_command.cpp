// Makes a scenario of files of other programs, writes it, and says what was left out.

#include "program/cli/import_command.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>

#include "engine/output_file.h"
#include "models/error.h"
#include "models/text_file.h"
#include "program/cli/file_guard.h"
#include "program/cli/report.h"
#include "program/foreign/import_files.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKind =
    "a file of OpenFAST or of one of its modules, or an ontology of WindIO (YAML)";

void print_lines(const char* label, const std::vector<std::string>& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) print_line(i == 0 ? label : "", texts[i]);
}

std::string describe_beam(const spatial::Beam& beam) {
  return fmt::format("{:.6g} m, {} stations", beam.length, beam.sections.station.size());
}

void print_model(const spatial::Model& model) {
  if (!model.blades.empty())
    print_line("blades", fmt::format("{}, each of {}", model.blades.size(),
                                     describe_beam(model.blades.front().beam)));
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (const spatial::Body& body : subsystem.bodies)
      if (const auto* beam = std::get_if<spatial::Beam>(&body.shape))
        print_line(body.name, describe_beam(*beam));
  if (!model.blades.empty() && model.blades.front().aerodynamics)
    print_line("aerodynamics", fmt::format("{} stations, {} aerofoils",
                                           model.blades.front().aerodynamics->station.size(),
                                           model.air->airfoils.size()));
}

/// A folder that is made if it is not there, and removed again unless it is kept.
class NewFolder {
 public:
  explicit NewFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    is_new_ = fs::create_directory(folder_, error);
    if (is_new_) unfinished_.emplace(folder_.string());
    if (!fs::is_directory(folder_))
      throw InputError(folder_.string() +
                       ": cannot be made, expected a folder for the tables of the aerofoils");
  }
  ~NewFolder() {
    std::error_code ignored;
    if (is_new_) fs::remove(folder_, ignored);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  void keep() { is_new_ = false; }

 private:
  fs::path folder_;
  bool is_new_ = false;
  std::optional<UnfinishedFile> unfinished_;  ///< the folder, for signals
};

/// Whether a table lies in the folder of the aerofoils, not beside the scenario.
bool is_in_folder(const foreign::SourceFile& table) {
  return fs::path(table.name).has_parent_path();
}

/// Writes the scenario and its tables; all of them lie beside their places before the first takes
/// its own.
void write_files(const std::string& out, const foreign::Imported& imported,
                 const std::string& tables) {
  const fs::path folder = fs::path(out).parent_path();
  require_place(out, kImportedScenario);
  for (const foreign::SourceFile& table : imported.tables)
    require_place(folder / table.name, is_in_folder(table) ? kImportedPolar : kImportedWind);
  std::optional<NewFolder> made;
  if (std::any_of(imported.tables.begin(), imported.tables.end(), is_in_folder))
    made.emplace(folder / tables);
  std::vector<FileText> files;
  for (const foreign::SourceFile& table : imported.tables)
    files.push_back({(folder / table.name).string(), table.text});
  files.push_back({out, imported.text});
  replace_files(files, Outlives::process);
  if (made) made->keep();
}

}  // namespace

int import_scenario(const Arguments& arguments, const ImportArguments& own) {
  std::vector<foreign::SourceFile> files;
  for (const std::string& file : own.files) files.push_back({file, read_text(file, kKind)});
  const std::string name = fs::path(arguments.out).stem().string(), tables = name + "_airfoils";
  foreign::ImportOptions options;
  options.blade_length = own.length;
  options.tower_height = own.height;
  options.airfoil_folder = tables;
  options.wind_table = name + "_wind.txt";
  options.folder = fs::path(arguments.out).parent_path().string();
  const foreign::Imported imported = foreign::import_files(
      files, [](const std::string& file) { return read_text(file, kKind); }, options);
  write_files(arguments.out, imported, tables);
  print_title(imported.scenario.title);
  print_lines("read", imported.sources);
  print_model(*imported.scenario.space);
  print_lines("left out", imported.left_out);
  warn_of_oddities(arguments.out, imported.scenario);
  std::string written = arguments.out;
  const auto in_folder =
      std::count_if(imported.tables.begin(), imported.tables.end(), is_in_folder);
  if (in_folder > 0)
    written += fmt::format(", {} tables in {}", in_folder,
                           (fs::path(arguments.out).parent_path() / tables).string());
  if (in_folder < std::ssize(imported.tables)) written += ", " + options.wind_table;
  print_line("written", written);
  return 0;
}

}  // namespace spoke::cli
