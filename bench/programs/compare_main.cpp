// The program "spoke-compare", which `spoke compare` starts.

#include <CLI/CLI.hpp>

#include "bench/programs/compare_arguments.h"
#include "bench/programs/compare_command.h"
#include "bench/programs/measure_child.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::CompareArguments;

const char* const kCompareText =
    R"(Measures all combinations in interleaved rounds, each in a process of its own, and compares times
per step and bits with those of the executor serial. Takes about a second for a combination as fast
as serial and up to seven for a slow one: some minutes with the defaults, less with shorter lists.

Output files, in the folder of --out:
  compare.html  conclusion, charts and tables
  compare.csv   a row of figures per combination
  compare.json  everything, all samples included

Example:
  spoke compare models/wu_haug_rotor.toml --threads 1,2 --formulations subsystem
)";

void add_options(CLI::App& compare, Arguments& arguments, CompareArguments& own) {
  cli::add_common(compare, arguments);
  cli::add_out(compare, arguments, "results/<name of the scenario>/compare");
  cli::add_compare_options(compare, own);
  cli::add_integrator(compare, arguments);
  compare.footer(std::string(kCompareText) + '\n' + cli::kMeasuringStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  if (cli::is_child(argc, argv)) return cli::measure_child(argc, argv);
  CompareArguments own;
  return cli::run_program(
      {.name = "compare",
       .summary = cli::kCompareSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::compare(arguments, own); }},
      argc, argv);
}
