#pragma once

// Results of a comparison: measurements, and the figures and verdicts derived from them.

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
  WorkAndSpan pass = {};     ///< one pass over the graph, its nodes timed one by one [s]
  double serial_step = 0.0;  ///< T1: median time of a serial step in the rounds [s]
  double span_step = 0.0;    ///< Tinf: T1's share that lies on the costliest path [s]
};

/// Figures derived from one measurement that has a sample.
struct Figures {
  double mean = 0.0;  ///< time per step [s]
  std::optional<double> deviation = {};
  double median = 0.0;
  double speedup = 0.0;  ///< median over rounds of serial time / time in the same round
  double speedup_low = 0.0, speedup_high = 0.0;  ///< quartiles
  double bound = 0.0;           ///< max(T1 / P, Tinf) [s]; P: threads, at most the processors
  double ratio_to_bound = 0.0;  ///< median / bound
  /// The bound with the measured capacity of P threads (Capacity) in place of P [s].
  std::optional<double> bound_at_capacity = {};
};

struct Result {
  Measurement measurement;
  std::optional<Figures> figures = {};
  std::vector<double> speedups = {};  ///< by round
  bool hash_equal = false;      ///< hashes equal serial's after every batch; false without a batch
  bool oversubscribed = false;  ///< more threads than processors
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

/// Fills in the results, and T1 and Tinf of the models. Precondition: machine and models are set,
/// and measure() made the measurements.
void evaluate(Comparison& comparison, std::vector<Measurement> measurements);

bool is_serial(const Result& result);
bool belongs_to(const Result& result, Formulation formulation);

/// Verdict on a formulation: serial against its fastest rival with serial's bits.
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
  const Result* rival = nullptr;  ///< points into the comparison; null for the first two kinds

  /// Whether this is the result that wins.
  bool is_winner(const Result& result) const;
};
Verdict judge(const Comparison& comparison, Formulation formulation);

}  // namespace spoke::compare
