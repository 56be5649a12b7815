#pragma once

// The protocol by which compare, reproduce and the benchmarks measure. Their claims are
// ratios of two ways to do the same work on one machine, so all ways take turns within one run: a
// round times each of them once, and the ratio is taken within the round, where a busy neighbour or
// a changed clock frequency meets both. Processes of their own take turns in compare/rounds.h.
// Google Benchmark was weighed and left: it runs one benchmark to the end before the next (its
// random interleaving shuffles repetitions, but reports no ratios of neighbours), and it cannot
// give one round to an alternative of seconds and many to one of microseconds.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace spoke::bench {

/// Shows what is being done; an empty text clears the display.
using Progress = std::function<void(const std::string&)>;

/// Calls `take_turn(contender, round)` for each contender in each of the rounds; the contender that
/// begins moves on with the rounds.
void take_turns(std::size_t contenders, int rounds,
                const std::function<void(std::size_t, int)>& take_turn);
/// Returns "round 2 of 15: NAME".
std::string describe_turn(int round, int rounds, const std::string& name);

/// One way to do the same work.
struct Alternative {
  std::string name;
  std::function<void()> run;      ///< the timed work
  std::function<void()> prepare;  ///< untimed work before each timed run; may be empty
  double scale = 1.0;             ///< factor from the timed work to the work that is reported
  int reference = 0;              ///< index of the alternative that ratios are taken to
};

struct Effort {
  int rounds = 51;
  double batch_seconds = 1e-3;  ///< work without `prepare` is repeated until it takes that long
  double most_seconds = 12.0;   ///< of one alternative; slower ones make the first rounds only
};

/// The times of one alternative over its rounds.
struct Timing {
  std::string name;
  int rounds = 0;
  double least = 0.0;   ///< [s]
  double median = 0.0;  ///< [s]
  double ratio = 0.0;   ///< median over the rounds of time / time of the reference in that round
  double ratio_low = 0.0, ratio_high = 0.0;  ///< quartiles of that ratio
};

/// Times the alternatives in turns. Precondition: an alternative that others refer to takes part in
/// as many rounds as they do, so it must not be slower by far.
std::vector<Timing> measure(const std::vector<Alternative>& alternatives, const Effort& effort,
                            const Progress& progress);

}  // namespace spoke::bench
