// The commands of the program `spoke-whole` and their options, by CLI11.

#include "program/cli/commands.h"

#include <CLI/CLI.hpp>

#include "program/cli/help_texts.h"
#include "program/cli/shared_options.h"

namespace spoke::cli {
namespace {

void add_check(CLI::App& check, Arguments& arguments) {
  add_common(check, arguments);
  add_path(check, "--html", arguments.html,
           "Draw the model in this page: bodies, sections, joints, axes, loads", "FILE");
  add_force(check, arguments);
  check.footer(std::string(kCheckText) + '\n' + kStatusText);
}

void add_reduce(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  command.add_flag("--force", arguments.anew, "Make all anew, even if it is in the cache");
  command.footer(std::string(kReduceText) + '\n' + kStatusText);
}

void add_static(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/static");
  add_speed(command, arguments.steady);
  command.footer(std::string(kStaticText) + '\n' + kStatusText);
}

void add_modes(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/modes");
  add_speed(command, arguments.steady);
  add_count(command, arguments.steady);
  add_frame(command, arguments.steady);
  command.footer(std::string(kModesText) + '\n' + kStatusText);
}

void add_campbell(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/campbell");
  add_speeds(command, arguments.steady);
  add_count(command, arguments.steady);
  add_frame(command, arguments.steady);
  command.footer(std::string(kCampbellText) + '\n' + kStatusText);
}

void add_critical(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/critical");
  add_range(command, arguments.steady);
  add_speed(command, arguments.steady);
  add_count(command, arguments.steady);
  add_constant_frame(command, arguments.steady);
  command.footer(std::string(kCriticalText) + '\n' + kStatusText);
}

void add_performance(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/performance");
  add_performance_options(command, arguments.performance);
  command.footer(std::string(kPerformanceText) + '\n' + kStatusText);
}

void add_linearize(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_out(command, arguments, "results/<name of the scenario>/linear");
  add_speed(command, arguments.steady);
  add_constant_frame(command, arguments.steady);
  command.footer(std::string(kLinearizeText) + '\n' + kStatusText);
}

void add_wind(CLI::App& command, Arguments& arguments) {
  add_common(command, arguments);
  add_path(command, "--out", arguments.out, "File to write (default: <name of the scenario>.bts)",
           "FILE");
  add_force(command, arguments);
  command.footer(std::string(kWindText) + '\n' + kStatusText);
}

void add_schema(CLI::App& command, Arguments& arguments) {
  CLI::Option* const json = command.add_flag(
      "--json", arguments.prints_json,
      "Print a JSON schema (draft 7), by which editors complete and check scenarios");
  command
      .add_flag("--markdown", arguments.prints_markdown,
                "Print tables in Markdown: key, meaning, unit, default, range")
      ->excludes(json);
  command.footer(std::string(kSchemaText) + '\n' + kStatusText);
}

void add_new(CLI::App& command, Arguments& arguments) {
  command.add_option("KIND", arguments.kind, "rotor, turbine, helicopter, mechanism or part")
      ->required()
      ->type_name("");
  command.add_option("NAME", arguments.scenario, "Name of the scenario: NAME.toml is written")
      ->required()
      ->type_name("");
  command.footer(std::string(kNewText) + '\n' + kStatusText);
}

void add_help(CLI::App& command, Arguments& arguments) {
  command
      .add_option(
          "KEY", arguments.key,
          "A key as --set has it, or the end of its path: blade.joint.stiffness, gravity, stop")
      ->required()
      ->type_name("");
  command.footer(std::string(kHelpText) + '\n' + kStatusText);
}

void add_doctor(CLI::App& command, Arguments&) {
  command.footer(std::string(kDoctorText) + '\n' + kStatusText);
}

void add_trace(CLI::App& trace, Arguments& arguments) {
  add_common(trace, arguments);
  add_out(trace, arguments, "results/<name of the scenario>/trace");
  add_trace_options(trace, arguments.trace);
  add_running(trace, arguments);
  trace.footer(std::string(kTraceText) + '\n' + kStatusText);
}

}  // namespace

std::vector<Command> make_commands() {
  return list_commands({
      make_run(),
      {.name = "check", .add_options = add_check, .execute = check, .prints_result = true},
      {.name = "reduce",
       .add_options = add_reduce,
       .execute = reduce_solids,
       .prints_result = true},
      {.name = "static", .add_options = add_static, .execute = find_static},
      {.name = "modes", .add_options = add_modes, .execute = find_modes},
      {.name = "campbell", .add_options = add_campbell, .execute = find_campbell},
      {.name = "critical", .add_options = add_critical, .execute = find_critical},
      {.name = "performance", .add_options = add_performance, .execute = find_performance},
      {.name = "linearize", .add_options = add_linearize, .execute = linearize},
      {.name = "wind", .add_options = add_wind, .execute = write_wind},
      {.name = "schema", .add_options = add_schema, .execute = print_schema, .prints_result = true},
      {.name = "new", .add_options = add_new, .execute = write_new},
      {.name = "help", .add_options = add_help, .execute = explain_key, .prints_result = true},
      {.name = "doctor", .add_options = add_doctor, .execute = examine, .prints_result = true},
      {.name = "trace", .add_options = add_trace, .execute = trace},
  });
}

}  // namespace spoke::cli
