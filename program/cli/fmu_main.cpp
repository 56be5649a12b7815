// The program "spoke-fmu", which `spoke fmu` starts.

#include <CLI/CLI.hpp>

#include "program/cli/fmu_command.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::FmuArguments;

const char* const kFmuText =
    R"(Writes an FMU for co-simulation on Linux, of FMI 3.0 or, with --fmi 2, of FMI 2.0, for Simulink,
OpenModelica and others. It holds the scenario with the files that it names, and all of Spoke that it
needs: importers need no Spoke.

Inputs, each held over a communication step; all that the model has, unless named:
  drive.torque                   torque on a hub that turns freely, in place of the scenario's
  drive.speed                    speed of a hub that is driven, reached at the end of the step
  ROTOR.drive.torque, .speed     the same of further rotors
  load.NAME                      factor of the loads of that name
  wind.x, wind.y, wind.z         velocity of the wind at the hub, inertial frame, reached at the end of the
                                 step; the scenario's shear stays
  blade1.JOINT.velocity          of a joint whose motion is { by = "program" }, reached at the end of
  SUBSYSTEM.JOINT.velocity       the step; or .acceleration, over the step, where it is named
Outputs: columns of sensors.csv, or the words before their last, for all of a sensor.
An input acts from the first value on that is not its start value. See docs/fmu.md.

Examples:
  spoke fmu models/wu_haug_rotor.toml --out rotor.fmu
  spoke fmu models/nrel_5mw_turbine.toml --out turbine.fmu --input drive.torque
            --output hub.speed blade1.tip
  spoke fmu models/nrel_5mw_in_wind.toml --fmi 2 --out turbine.fmu --input wind.x drive.torque
)";

const char* const kFmuStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or scenario, or an FMU that cannot be written; nothing is written then, and
     the message on stderr says file:line:column, key, what is wrong and what is expected
  3  the model has no accelerations at its start
)";

void add_options(CLI::App& command, Arguments& arguments, FmuArguments& own) {
  cli::add_common(command, arguments);
  cli::add_path(command, "--out", arguments.out, "The FMU to write, NAME.fmu", "FILE");
  command.get_option("--out")->required();
  cli::add_force(command, arguments);
  command.add_option("--input", own.inputs, "Inputs that it has; none: no inputs [all]")
      ->type_name("NAME...");
  command.add_option("--output", own.outputs, "Outputs that it has [all columns of sensors.csv]")
      ->type_name("SENSOR...");
  command.add_option("--fmi", own.version, "Version of the standard: 2 or 3 [3]")
      ->type_name("VERSION")
      ->check(CLI::IsMember({2, 3}));
  command.footer(std::string(kFmuText) + '\n' + kFmuStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  FmuArguments own;
  return cli::run_program(
      {.name = "fmu",
       .summary = cli::kFmuSummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::make_fmu(arguments, own); }},
      argc, argv);
}
