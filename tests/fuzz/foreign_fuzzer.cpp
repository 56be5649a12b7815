// libFuzzer: whatever stands in files of OpenFAST and its modules and of WindIO, they make a
// scenario that is accepted, or are refused by InputError with one line. Lines "#file NAME" begin
// the files, the first of which is imported, with others whose names begin with "+".

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "models/air/airfoil_reader.h"
#include "program/foreign/export_beamdyn.h"
#include "program/foreign/import_files.h"
#include "program/foreign/input_lines.h"
#include "spoke/error.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

namespace {

/// Returns the files in order.
std::vector<foreign::SourceFile> split(const std::string& text) {
  const std::string head = "#file ";
  std::vector<foreign::SourceFile> files;
  std::size_t at = text.starts_with(head) ? 0 : text.find('\n' + head);
  while (at != std::string::npos) {
    const std::size_t name = text.find(head, at) + head.size();
    const std::size_t begin = std::min(text.find('\n', name), text.size());
    const std::size_t end = text.find('\n' + head, begin);
    const std::size_t first = std::min(begin + 1, text.size());
    files.push_back({foreign::printable(text.substr(name, begin - name)),
                     text.substr(first, end == std::string::npos ? end : end + 1 - first)});
    at = end;
  }
  return files;
}

foreign::Imported import_all(const std::vector<foreign::SourceFile>& all) {
  std::vector<foreign::SourceFile> given;
  for (const foreign::SourceFile& file : all)
    if (given.empty() || file.name.starts_with('+')) given.push_back(file);
  const auto read = [&](const std::string& name) {
    for (const foreign::SourceFile& file : all)
      if (file.name == name) return file.text;
    throw InputError(name + ": no such file, expected one");
  };
  foreign::ImportOptions options;
  options.blade_length = 20.0;
  options.tower_height = 30.0;
  options.is_there = [](const std::string&) { return true; };
  return foreign::import_files(given, read, options);
}

/// Requires that the tables of aerofoils have the polars of the scenario.
void check_tables(const foreign::Imported& imported) {
  const spatial::Model& model = *imported.scenario.space;
  const std::size_t airfoils = model.air ? model.air->airfoils.size() : 0;
  require(imported.tables.size() >= airfoils, "each aerofoil has a table");
  for (std::size_t k = airfoils; k < imported.tables.size(); ++k)
    require(k == airfoils && imported.tables[k].name == "wind.txt", "the last table is the wind");
  for (std::size_t k = 0; k < airfoils; ++k) {
    const spatial::Airfoil& airfoil = model.air->airfoils[k];
    require(imported.tables[k].name == "airfoils/" + airfoil.name + ".txt", "a table has its name");
    require(air::parse_airfoil(imported.tables[k].text, "table", airfoil.name) == airfoil,
            "a table is read as it was written");
  }
}

/// Requires what a scenario of files promises, and that its blade can be written and read again.
void check(const foreign::Imported& imported) {
  const spatial::Model& model = *imported.scenario.space;
  require(!model.blades.empty() || model.support, "there is a blade or a tower");
  check_tables(imported);
  if (model.blades.empty()) return;
  const spatial::Beam& beam = model.blades[0].beam;
  require(std::isfinite(beam.length) && beam.length > 0.0, "a blade is long");
  const foreign::BeamDynFiles files = foreign::export_beamdyn(imported.scenario, 1, "b.dat");
  import_all({{"p.dat", files.primary}, {"b.dat", files.blade}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto files = split(std::string(reinterpret_cast<const char*>(data), size));
  if (files.empty()) return 0;
  try {
    check(import_all(files));
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
