#pragma once

// What was measured, and what follows from it.

#include <optional>
#include <string>
#include <vector>

#include "bench/compare/rounds.h"
#include "bench/compare/span.h"
#include "engine/support/machine.h"

namespace spoke::compare {

/// One formulation of the scenario, on one thread.
struct Model {
  Formulation formulation = Formulation::structured;
  ModelSize size = {};
  std::int64_t batch = 1;    ///< steps of a sample
  WorkAndSpan pass = {};     ///< of a pass over the graph, its nodes timed one by one [s]
  double serial_step = 0.0;  ///< T1: median time of a serial step in the rounds [s]
  double span_step = 0.0;    ///< Tinf: T1's share that lies on the costliest path [s]
};

/// What follows from one measurement. Without a sample there are no figures.
struct Figures {
  double mean = 0.0;  ///< time per step [s]
  std::optional<double> deviation = {};
  double median = 0.0;
  double speedup = 0.0;  ///< median over rounds of serial time / time in the same round
  double speedup_low = 0.0, speedup_high = 0.0;  ///< quartiles
  double bound = 0.0;           ///< max(T1 / P, Tinf) [s]; P: threads, at most the processors
  double ratio_to_bound = 0.0;  ///< median / bound
  /// The bound with what P threads really did at once (Capacity) instead of P [s].
  std::optional<double> bound_at_capacity = {};
};

struct Result {
  Measurement measurement;
  std::optional<Figures> figures = {};
  std::vector<double> speedups = {};  ///< by round
  bool hash_equal = false;            ///< to serial's after every batch, at least one
  bool oversubscribed = false;        ///< more threads than processors
};

struct Loads {
  double before = -1.0, after = -1.0;  ///< runnable processes over a minute; -1: not known
};

struct Comparison {
  Scenario scenario;       ///< with the values in force
  double step_size = 0.0;  ///< [s]
  Machine machine = {};
  Loads loads = {};
  Capacity capacity = {};
  int rounds = 0;                  ///< planned
  std::vector<Model> models = {};  ///< by formulation, in order of the results
  std::vector<Result> results = {};
};

const Model& model_of(const Comparison& comparison, Formulation formulation);

/// Fills in results and, of the models, T1 and Tinf. Precondition: machine and models are set,
/// measurements as by measure().
void evaluate(Comparison& comparison, std::vector<Measurement> measurements);

bool is_serial(const Result& result);
bool belongs_to(const Result& result, Formulation formulation);

/// What can be said of a formulation: serial against its fastest rival with serial's bits.
struct Verdict {
  enum class Kind {
    no_reference,  ///< serial gave no time
    no_rival,      ///< nothing else did
    disturbed,     ///< the rival seems faster than work and span allow
    serial_wins,   ///< three quarters of the rounds are slower than serial, by more than a trifle
    undecided,
    rival_wins,  ///< three quarters of the rounds are faster than serial, by more than a trifle
  };
  Kind kind = Kind::no_reference;
  const Result* rival = nullptr;  ///< of `comparison`; none of the first two kinds

  /// Whether this is the result that wins.
  bool is_winner(const Result& result) const;
};
Verdict judge(const Comparison& comparison, Formulation formulation);

}  // namespace spoke::compare
