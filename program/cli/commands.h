#pragma once

// The commands of the programs `spoke`, which makes runs, and `spoke-whole`, which has all that
// need more of the engine, in the order of their help. Each returns the exit status. Others, such
// as `spoke study`, are programs beside them.

#include <vector>

#include "program/cli/program.h"

namespace spoke::cli {

/// Simulates a scenario and writes its results. Throws InputError. Returns 3 if the simulation
/// diverged.
int run(const Arguments& arguments);

/// Prints what a scenario's model is and how it vibrates. Throws InputError.
int check(const Arguments& arguments);

/// Reduces the solids of a scenario to modes, and prints these. Throws InputError.
int reduce_solids(const Arguments& arguments);

/// Finds the equilibrium of a scenario's model, prints it and writes its files. Throws InputError
/// and DivergenceError.
int find_static(const Arguments& arguments);

/// Finds the modes of a scenario's model, prints them and writes their files. Throws InputError and
/// DivergenceError.
int find_modes(const Arguments& arguments);

/// Follows the modes of a scenario's model over speeds, prints them and their crossings with
/// multiples of the speed, and writes their files. Throws InputError and DivergenceError.
int find_campbell(const Arguments& arguments);

/// Finds the least speed or load at which an equilibrium of a scenario's model is lost or a mode
/// stops decaying, prints it and writes its files. Throws InputError and DivergenceError.
int find_critical(const Arguments& arguments);

/// Finds steady states of a scenario's rotor in wind, prints them and writes their files. Throws
/// InputError.
int find_performance(const Arguments& arguments);

/// Writes the wind of a scenario with turbulence as a file of TurbSim. Throws InputError.
int write_wind(const Arguments& arguments);

/// Prints the keys that scenarios may have. Throws InputError.
int print_schema(const Arguments& arguments);

/// Writes a commented scenario to begin with. Throws InputError, and OutputError.
int write_new(const Arguments& arguments);

/// Prints what a key of scenarios means. Throws InputError if there is none of this name.
int explain_key(const Arguments& arguments);

/// Prints what this installation has, and which optional parts are missing.
int examine(const Arguments& arguments);

/// Linearises a scenario's model, prints its size and writes its matrices. Throws InputError and
/// DivergenceError.
int linearize(const Arguments& arguments);

/// Runs to a time, records the steps that follow, node by node, writes the files and prints a
/// summary. If the simulation diverges meanwhile, these hold the steps before. Throws InputError,
/// and DivergenceError if there are no such steps, having written nothing.
int trace(const Arguments& arguments);

/// Returns the command `run` with its options.
Command make_run();

/// Throws OtherProgramNeeded if this program cannot run such a scenario: `spoke` may have less than
/// the whole engine. One that has it returns.
void require_enough(const Scenario& scenario);
/// Does so before the scenario is read, for what can be read once only, and where MPI is begun.
void require_enough(const Arguments& arguments);

/// Returns all commands, in the order of --help: of those that this program has, `own`, with
/// options and what they do, of the others the programs that have them.
std::vector<Command> list_commands(const std::vector<Command>& own);

/// Returns all commands as `spoke-whole` has them.
std::vector<Command> make_commands();

}  // namespace spoke::cli
