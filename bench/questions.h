#pragma once

// The questions that the benchmarks answer, one function for each.

#include "bench/report.h"

namespace spoke::bench {

struct QuestionOptions {
  bool quick = false;  ///< whether it is a smoke run: few rounds, the slowest alternatives left out
};

/// What does one evaluation of the accelerations cost, by formulation and size?
void measure_formulations(const QuestionOptions& options, Report& report);

/// What does one evaluation of the accelerations cost in space, against the plane?
void measure_spatial_evaluations(const QuestionOptions& options, Report& report);

/// What does a whole step cost, with the sensors of every step, beside the evaluations it contains?
void measure_whole_steps(const QuestionOptions& options, Report& report);

/// How long does the 20 s spin-up take at 0.1 % accuracy, Spoke's way and the paper's way?
void measure_time_to_solution(const QuestionOptions& options, Report& report);

/// What do closed loops cost, and how does it grow with their number?
void measure_loops(const QuestionOptions& options, Report& report);

/// How do costs grow with size, of loops, chains, rotors and nodal solids, their starts and memory?
void measure_growth(const QuestionOptions& options, Report& report);

/// How long do problems take that other programs have been timed on, by error?
void measure_peers(const QuestionOptions& options, Report& report);

/// What do solids cost, reduced and in nodal coordinates, and what do two threads gain on one body?
void measure_solids(const QuestionOptions& options, Report& report);

/// What does a support cost beside the rotor on it, and what do two threads gain?
void measure_supports(const QuestionOptions& options, Report& report);

/// What do strains of second order cost beside linear ones?
void measure_strains(const QuestionOptions& options, Report& report);

/// What does air cost beside the structure of the blades that it acts on?
void measure_air(const QuestionOptions& options, Report& report);

/// How many passes does a step need, by model and step, and at the steps that accuracy allows?
/// Takes five minutes: only if named.
void measure_passes(const QuestionOptions& options, Report& report);

/// What do two threads gain on graphs shaped like a step, by executor, size and cost of a node?
void measure_step_graphs(const QuestionOptions& options, Report& report);

/// What do two threads gain on whole steps of rotors, by executor?
void measure_executors(const QuestionOptions& options, Report& report);

/// How long do commands of the program take beyond their integration?
void measure_start_up(const QuestionOptions& options, Report& report);

/// What does recording which node ran when cost, switched off and on?
void measure_tracing(const QuestionOptions& options, Report& report);

/// How many runs a second does a study make, beside processes of their own?
void measure_study(const QuestionOptions& options, Report& report);

/// What does auto gain, or cost, on whole runs of the program? Takes half an hour: only if named.
void measure_whole_runs(const QuestionOptions& options, Report& report);

}  // namespace spoke::bench
