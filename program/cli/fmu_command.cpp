// Makes an FMU of a scenario, writes it, and says what importers see.

#include "program/cli/fmu_command.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

#include "engine/output_file.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/text_file.h"
#include "program/cli/build_simulation.h"
#include "program/cli/file_guard.h"
#include "program/cli/report.h"
#include "program/fmu/make_fmu.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

/// Returns the name of the FMU: that of its file without the ending. Throws InputError.
std::string name_of(const fs::path& out) {
  std::string name = out.stem().string();
  if (out.extension() != ".fmu" || name.empty())
    throw InputError("--out " + out.string() + ": expected a file NAME.fmu");
  return name;
}

/// Prints signals, by their first words: all of a model may be hundreds.
void print_signals(const char* label, const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 8;
  if (names.empty()) return print_line(label, "none");
  for (std::size_t k = 0; k < names.size() && k < kShown; ++k)
    print_line(k == 0 ? label : "", names[k]);
  if (names.size() > kShown) print_line("", fmt::format("and {} more", names.size() - kShown));
}

void print(const fmu::Fmu& made, const Simulation& simulation, const std::string& out) {
  print_title(simulation.scenario().title);
  std::vector<std::string> inputs, outputs;
  for (const auto& input : made.inputs)
    inputs.push_back(
        fmt::format("{} [{}], {} at the start", input->name, input->unit, input->start));
  for (const std::string& output : made.outputs) {
    const std::string& unit = simulation.sensor_units()[simulation.sensor_index(output)];
    outputs.push_back(unit.empty() ? output : fmt::format("{} [{}]", output, unit));
  }
  print_signals("inputs", inputs);
  print_signals("outputs", outputs);
  print_line("step",
             fmt::format("{} s; communication steps are multiples of it", simulation.step_size()));
  print_line("written", out);
}

}  // namespace

namespace {

/// Returns the names that an option gives; none for "all", which is what no names mean.
std::vector<std::string> names_of(const std::vector<std::string>& given) {
  return given == std::vector<std::string>{"all"} ? std::vector<std::string>() : given;
}

}  // namespace

int make_fmu(const Arguments& arguments, const FmuArguments& own) {
  const fmu::FmuRequest request{.scenario = arguments.scenario,
                                .overrides = arguments.overrides,
                                .name = name_of(arguments.out),
                                .binary = fmu::find_library(),
                                .inputs = names_of(own.inputs),
                                .outputs = names_of(own.outputs),
                                .version = fmu::FmiVersion{own.version},
                                .text = read_text(arguments.scenario)};
  const Scenario scenario = parse_scenario(request.text, arguments.scenario, arguments.overrides);
  require_place(arguments.out, kFmuFile);
  warn_of_oddities(arguments.scenario, scenario);
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  const Simulation simulation = build_simulation(arguments.scenario, scenario, options);
  const fmu::Fmu made = fmu::make_fmu(request, simulation);
  replace_file(arguments.out, made.bytes);
  print(made, simulation, arguments.out);
  return 0;
}

}  // namespace spoke::cli
