// Makes a scenario of files of other programs, writes it, and says what was left out.

#include "program/cli/import_command.h"

#include <spdlog/fmt/fmt.h>

#include "engine/output_file.h"
#include "models/text_file.h"
#include "program/cli/report.h"
#include "program/foreign/import_files.h"

namespace spoke::cli {
namespace {

constexpr const char* kKind = "a file of BeamDyn or ElastoDyn, or an ontology of WindIO (YAML)";

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
}

}  // namespace

int import_scenario(const Arguments& arguments, const ImportArguments& own) {
  std::vector<foreign::SourceFile> files;
  for (const std::string& file : own.files) files.push_back({file, read_text(file, kKind)});
  const foreign::Imported imported =
      foreign::import_files(files, [](const std::string& name) { return read_text(name, kKind); },
                            {own.length, own.height});
  replace_file(arguments.out, imported.text);
  print_title(imported.scenario.title);
  print_lines("read", imported.sources);
  print_model(*imported.scenario.space);
  print_lines("left out", imported.left_out);
  print_line("written", arguments.out);
  return 0;
}

}  // namespace spoke::cli
