#pragma once

// The hidden command by which a program that measures starts itself to measure one configuration in
// a process of its own.

#include <string>
#include <string_view>
#include <vector>

#include "bench/compare/child.h"
#include "bench/compare/configuration.h"
#include "bench/reproduce/timings.h"
#include "models/scenario.h"

namespace spoke::cli {

/// Task of a child: scenario and options of its simulation.
struct ChildTask {
  std::string scenario;  ///< file; empty: the paper's rotor, which is built in
  std::string text;      ///< text of that file, which children do not read again
  Overrides overrides;
  Integration integration;  ///< its method, step and duration replace those of the scenario
  reproduce::Work work = reproduce::Work::steps;  ///< kind of work in a batch of steps
};

/// Returns the command that starts this program as a child that measures a configuration.
compare::Command make_child_command(const ChildTask& task,
                                    const compare::Configuration& configuration);

/// Runs batches of steps as standard input asks for (compare/rounds.h) until the input ends. A
/// batch of Work::run begins anew at t = 0, before its time counts; one of Work::inverse has no
/// state, and its hash is 0. Returns the exit status.
int measure_child(int argc, char** argv);

/// Whether a command line asks for measure_child().
bool is_child(int argc, char** argv);

}  // namespace spoke::cli
