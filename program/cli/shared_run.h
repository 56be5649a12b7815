#pragma once

// A run that several processes make together, started by mpirun: the first one leads and writes,
// the others follow.

#include <cstdint>

#include "program/cli/arguments.h"
#include "program/ranks/launch.h"

namespace spoke::cli {

/// Builds the simulation of a run, with the method that the command line asks for; at the state of
/// its start. `exchange`: of several processes, or null.
Simulation build_run(const Arguments& arguments, const Scenario& scenario, Exchange* exchange);
/// The scenario of a run.
Scenario read_run(const Arguments& arguments);

// Of the first process. Alone they do nothing.
/// Throws InputError unless all processes have built the simulation of this one.
void require_same(const Arguments& arguments, const Simulation& simulation, ranks::Launch& launch);
/// Lets the others know that there is none.
void give_up(ranks::Launch& launch);
/// Lets the others step to the end of step `step`, which this one is about to do, observed.
void let_advance(std::int64_t step, const ranks::Launch& launch);
/// Lets the others go.
void let_go(ranks::Launch& launch);

/// What a process other than the first does. The exit status.
int follow(const Arguments& arguments, ranks::Launch& launch);

}  // namespace spoke::cli
