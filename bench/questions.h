#pragma once

// The questions that the benchmarks answer, one function for each.

#include "bench/report.h"

namespace spoke::bench {

struct QuestionOptions {
  bool quick = false;  ///< whether it is a smoke run: few rounds, the slowest alternatives left out
};

/// What does one evaluation of the accelerations cost, by formulation and size?
void measure_formulations(const QuestionOptions& options, Report& report);

/// What do two threads gain on whole steps of rotors, by executor?
void measure_executors(const QuestionOptions& options, Report& report);

/// What does a step of every shipped model take, and what does auto gain there?
void measure_models(const QuestionOptions& options, Report& report);

/// How long does the 20 s spin-up take at 0.1 % accuracy, Spoke's way and the paper's way?
void measure_time_to_solution(const QuestionOptions& options, Report& report);

/// How do costs grow with size, of loops, chains, rotors and nodal solids, their starts and memory?
void measure_growth(const QuestionOptions& options, Report& report);

/// How long do problems take that other programs have been timed on, by error?
void measure_peers(const QuestionOptions& options, Report& report);

/// How long do commands of the program take beyond their integration?
void measure_start_up(const QuestionOptions& options, Report& report);

/// How many passes does a step need, by model and step, and at the steps that accuracy allows?
/// Takes five minutes: only if named.
void measure_passes(const QuestionOptions& options, Report& report);

}  // namespace spoke::bench
