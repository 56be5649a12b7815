#pragma once

// The command of the program `spoke-predict`.

#include "bench/programs/predict_arguments.h"
#include "program/cli/arguments.h"

namespace spoke::cli {

/// Predicts what a scenario's step takes on any number of threads, measures it on those at hand,
/// prints a table and a conclusion and writes its files. Returns the exit status. Throws InputError
/// and DivergenceError, having written nothing.
int predict(const Arguments& arguments, const PredictArguments& own);

}  // namespace spoke::cli
