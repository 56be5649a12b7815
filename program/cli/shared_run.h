#pragma once

// A run that several processes make together, started by mpirun: the first one leads and writes,
// the others follow.

#include <cstdint>

#include "program/cli/arguments.h"
#include "program/ranks/launch.h"

namespace spoke::cli {

/// Builds the simulation of a run with the method that the command line asks for, at its initial
/// state. `exchange`: joins several processes; null for one.
Simulation build_run(const Arguments& arguments, const Scenario& scenario, Exchange* exchange);
/// Reads the scenario of a run.
Scenario read_run(const Arguments& arguments);

// The first process calls these functions. Without other processes they do nothing.
/// Throws InputError unless all processes have built the same simulation as this one.
void require_same(const Arguments& arguments, const Simulation& simulation, ranks::Launch& launch);
/// Tells the others that there is no simulation.
void give_up(ranks::Launch& launch);
/// Lets the others step to the end of step `step`, which this one is about to do, observed.
void let_advance(std::int64_t step, const ranks::Launch& launch);
/// Tells the others that the run is over.
void let_go(ranks::Launch& launch);

/// Makes the run's steps in a process other than the first. Returns the exit status.
int follow(const Arguments& arguments, ranks::Launch& launch);

}  // namespace spoke::cli
