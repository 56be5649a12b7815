#pragma once

// The commands of the program, in the order of its help. Each returns the exit status.

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// Simulates a scenario and writes its results. Throws InputError. 3 if the simulation diverged.
int run(const Arguments& arguments);

/// Prints what a scenario's model is and how it vibrates. Throws InputError.
int check(const Arguments& arguments);

/// Finds the equilibrium of a scenario's model, prints it and writes its files. Throws InputError
/// and DivergenceError.
int find_static(const Arguments& arguments);

/// Finds the modes of a scenario's model, prints them and writes their files. Throws InputError and
/// DivergenceError.
int find_modes(const Arguments& arguments);

/// Follows the modes of a scenario's model over speeds, prints them and their crossings with
/// multiples of the speed, and writes their files. Throws InputError and DivergenceError.
int find_campbell(const Arguments& arguments);

/// Linearises a scenario's model, prints its size and writes its matrices. Throws InputError and
/// DivergenceError.
int linearize(const Arguments& arguments);

/// Runs to a time, records the steps that follow, node by node, writes the files and prints a
/// summary. If the simulation diverges meanwhile, of the steps before. Throws InputError, and
/// DivergenceError if there are none, having written nothing.
int trace(const Arguments& arguments);

/// Makes the runs of a study and writes its files. Throws InputError.
int study(const Arguments& arguments);

/// Compares ways to run a scenario's step, prints tables and a conclusion and writes its files.
/// Throws InputError and DivergenceError, having written nothing.
int compare(const Arguments& arguments);

/// Predicts what a scenario's step takes on any number of threads, measures it on those at hand,
/// prints a table and a conclusion and writes its files. Throws InputError and DivergenceError,
/// having written nothing.
int predict(const Arguments& arguments);

/// Repeats the paper's evaluation, prints a table and writes reproduce.html and reproduce.json.
/// Throws InputError, having written nothing.
int reproduce(const Arguments& arguments);

}  // namespace spoke::cli
