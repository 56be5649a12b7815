// The program "spoke-reproduce", which `spoke reproduce` starts.

#include <CLI/CLI.hpp>

#include "bench/programs/measure_child.h"
#include "bench/programs/reproduce_command.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::ReproduceArguments;

const char* const kReproduceText =
    R"(Tables and figures of Han, Song and Kim (2017), computed and measured on this machine, beside the
paper's own numbers: operation counts, drive, deflection, two schemes of nested threads, methods.
The model is built in. Takes one to three minutes; --quick less than 20 s, with rough times.

Output files, in the folder of --out:
  reproduce.html  tables with the paper's numbers and whether each holds, and charts
  reproduce.json  all of it, samples included

Example:
  spoke reproduce --out results/paper
)";

void add_options(CLI::App& reproduce, Arguments& arguments, ReproduceArguments& own) {
  cli::add_out(reproduce, arguments, "results/reproduce");
  reproduce.add_flag("--quick", own.quick, "Few rounds, of rough times");
  reproduce.footer(std::string(kReproduceText) + '\n' + cli::kMeasuringStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  if (cli::is_child(argc, argv)) return cli::measure_child(argc, argv);
  ReproduceArguments own;
  return cli::run_program(
      {.name = "reproduce",
       .summary = cli::kReproduceSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::reproduce(arguments, own); }},
      argc, argv);
}
