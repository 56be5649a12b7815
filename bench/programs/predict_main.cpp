// The program "spoke-predict", which `spoke predict` starts.

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/programs/measure_child.h"
#include "bench/programs/predict_arguments.h"
#include "bench/programs/predict_command.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::PredictArguments;

const char* const kPredictText =
    R"(Times the nodes of a step one by one on one thread and simulates what executors make of them on
other numbers of threads; measures those that this machine has processors for beside it. As in
spoke run, auto makes windows of steps, as wide as it chooses, and the others a run for each pass;
the table says for each which window was predicted. --window is for all, serial included.

Output files, in the folder of --out:
  predict.html  conclusion, charts and table
  predict.csv   a row per executor and number of threads
  predict.json  everything, the costs of all nodes included

Example:
  spoke predict models/wu_haug_rotor.toml --formulation subsystem --window 8
)";

void add_options(CLI::App& predict, Arguments& arguments, PredictArguments& own) {
  cli::add_common(predict, arguments);
  cli::add_out(predict, arguments, "results/<name of the scenario>/predict");
  cli::add_predict_options(predict, own);
  cli::add_formulation(predict, arguments);
  cli::add_integrator(predict, arguments);
  predict.footer(std::string(kPredictText) + '\n' + cli::kMeasuringStatusText);
  predict.callback([&] { std::sort(own.ranks.begin(), own.ranks.end()); });
}

}  // namespace

int main(int argc, char** argv) {
  if (cli::is_child(argc, argv)) return cli::measure_child(argc, argv);
  PredictArguments own;
  return cli::run_program(
      {.name = "predict",
       .summary = cli::kPredictSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::predict(arguments, own); }},
      argc, argv);
}
