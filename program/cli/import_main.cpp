// The program "spoke-import", which `spoke import` starts.

#include <CLI/CLI.hpp>
#include <limits>

#include "program/cli/help_texts.h"
#include "program/cli/import_command.h"
#include "program/cli/number_option.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::ImportArguments;

const char* const kImportText =
    R"(FILE is the main file of OpenFAST (.fst), which names all others of a turbine; or of BeamDyn (primary
file with key points; the blade file that it names), of ElastoDyn (primary, blade, tower), of AeroDyn
(primary; the blade and aerofoils that it names), InflowWind or ServoDyn; or an ontology of WindIO (.yaml,
.yml), told apart by the first line or the ending. Files that another one names are read as well, unless
one of their kind is given. AeroDyn's need those of BeamDyn or ElastoDyn besides.

Stations of all lists are merged, arc lengths become stations, signs, axes and units those of Spoke,
matrices symmetric; what came from where stands behind each value, and what could not be carried over at
the head of the scenario, worst first, which is checked before it is written. Polars go to tables in a
folder beside it, a uniform wind to a table: rotor.toml has rotor_airfoils and rotor_wind.txt. Wind of
TurbSim and a controller's library are named by their paths. See docs/files.md.

Examples:
  spoke import 5MW_Land.fst --out turbine.toml
  spoke import blade_BeamDyn.dat --out blade.toml
  spoke import ElastoDyn_blade.dat --length 61.5 --out blade.toml
  spoke import turbine_ElastoDyn.dat turbine_BeamDyn.dat turbine_AeroDyn15.dat --out turbine.toml
  spoke import IEA-15-240-RWT.yaml --out rotor.toml
)";

const char* const kImportStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or file, or output that cannot be written; nothing is written then, and
     the message on stderr says file:line, what is wrong and what is expected
)";

void add_length(CLI::App& command, const std::string& option, std::optional<double>& length,
                const char* text) {
  constexpr double least = std::numeric_limits<double>::denorm_min(), most = 1e30;
  command
      .add_option_function<std::string>(
          option,
          [&length, option](const std::string& word) {
            length = cli::parse_number(option, word, least, most, "a number above 0 [m]");
          },
          text)
      ->type_name("METERS");
}

void add_options(CLI::App& command, Arguments& arguments, ImportArguments& own) {
  command.add_option("FILE", own.files, "Files of other programs")->required()->type_name("");
  cli::add_path(command, "--out", arguments.out, "The scenario to write (TOML)", "FILE");
  command.get_option("--out")->required();
  cli::add_force(command, arguments);
  add_length(command, "--length", own.length,
             "Length of an ElastoDyn blade, whose file does not say it");
  add_length(command, "--height", own.height, "Height of an ElastoDyn tower, likewise");
  command.add_flag("-v,--verbose", arguments.verbosity, "Log to stderr; -vv logs more");
  command.footer(std::string(kImportText) + '\n' + kImportStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  ImportArguments own;
  return cli::run_program(
      {.name = "import",
       .summary = cli::kImportSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::import_scenario(arguments, own); }},
      argc, argv);
}
