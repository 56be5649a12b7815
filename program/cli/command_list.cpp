// What `spoke --help` lists: all commands, and the programs that have them.

#include "program/cli/commands.h"
#include "program/cli/help_texts.h"

namespace spoke::cli {

std::vector<Command> list_commands(const std::vector<Command>& own) {
  constexpr const char* kWhole = "whole";
  std::vector<Command> commands = {
      {.name = "run", .program = kWhole, .summary = "Simulate a scenario and write its results"},
      {.name = "check", .program = kWhole, .summary = "Validate a scenario and print its model"},
      {.name = "reduce",
       .program = kWhole,
       .summary = "Reduce bodies from finite-element meshes to modes"},
      {.name = "static",
       .program = kWhole,
       .summary = "Find where a model stands in steady rotation, or at rest"},
      {.name = "modes",
       .program = kWhole,
       .summary = "Find frequencies, damping and shapes of a model's vibrations"},
      {.name = "campbell",
       .program = kWhole,
       .summary = "Follow a model's vibrations over the speed of rotation"},
      {.name = "critical",
       .program = kWhole,
       .summary = "Find the speed or load at which an equilibrium becomes unstable"},
      {.name = "performance",
       .program = kWhole,
       .summary = "Find thrust and power of a rotor over wind, tip-speed ratio and pitch"},
      {.name = "linearize",
       .program = kWhole,
       .summary = "Write the state-space matrices of small motions about an equilibrium"},
      {.name = "wind",
       .program = kWhole,
       .summary = "Write a scenario's turbulent wind as a file of TurbSim"},
      {.name = "schema",
       .program = kWhole,
       .summary = "Print the keys of scenarios, for editors or as tables"},
      {.name = "new", .program = kWhole, .summary = "Write a commented scenario to begin with"},
      {.name = "help",
       .program = kWhole,
       .summary = "Explain a key of scenarios: meaning, unit, default, range"},
      {.name = "doctor",
       .program = kWhole,
       .summary = "Say what this installation has, and which optional parts are missing"},
      {.name = "study", .summary = kStudySummary},
      {.name = "import", .summary = kImportSummary},
      {.name = "export", .summary = kExportSummary},
      {.name = "fmu", .summary = kFmuSummary},
      {.name = "verify", .summary = kVerifySummary},
      {.name = "compare", .summary = kCompareSummary},
      {.name = "trace", .program = kWhole, .summary = "Record steps, node by node, to look at"},
      {.name = "reproduce", .summary = kReproduceSummary},
  };
  for (Command& command : commands)
    for (const Command& one : own)
      if (std::string_view(one.name) == command.name) {
        const Command listed = command;
        command = one;
        command.program = listed.program;
        command.summary = listed.summary;
      }
  return commands;
}

}  // namespace spoke::cli
