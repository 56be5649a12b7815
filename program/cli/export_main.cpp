// The program "spoke-export", which `spoke export` starts.

#include <CLI/CLI.hpp>

#include "program/cli/export_command.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::ExportArguments;

const char* const kExportText =
    R"(Writes a blade of a model in space. As beamdyn: its primary file, the FILE of --out, and its blade file
beside it, with "_blade" added to the name; every station becomes a key point and a section. As elastodyn:
the blade file, and that of the tower with "_tower". As aerodyn: the primary file, that of the blade, and
one of each aerofoil with its name added. spoke import reads the same numbers back. What the other program
does not know is said. See docs/files.md.

Examples:
  spoke export beamdyn models/nrel_5mw_rotor.toml --out nrel_5mw_BeamDyn.dat
  spoke export elastodyn models/nrel_5mw_turbine.toml --out nrel_5mw_ElastoDyn_blade.dat
  spoke export aerodyn models/nrel_5mw_in_wind.toml --out nrel_5mw_AeroDyn15.dat
)";

const char* const kExportStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or scenario, or output that cannot be written;
     the message on stderr says file:line:column, key, what is wrong and what is expected
)";

void add_options(CLI::App& command, Arguments& arguments, ExportArguments& own) {
  command.add_option("FORMAT", own.format, "Kind of the files")
      ->required()
      ->check(CLI::IsMember({"beamdyn", "elastodyn", "aerodyn"}))
      ->type_name("");
  cli::add_common(command, arguments);
  cli::add_path(command, "--out", arguments.out, "The first file to write", "FILE");
  command.get_option("--out")->required();
  cli::add_force(command, arguments);
  command.add_option("--blade", own.blade, "Number of the blade [1]")
      ->check(CLI::Range(1, 100000))
      ->type_name("N");
  command.footer(std::string(kExportText) + '\n' + kExportStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  ExportArguments own;
  return cli::run_program(
      {.name = "export",
       .summary = cli::kExportSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::export_blade(arguments, own); }},
      argc, argv);
}
