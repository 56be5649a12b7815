#pragma once

// Which configurations the paper's timings need, and what was measured of each.

#include <optional>
#include <vector>

#include "bench/compare/rounds.h"
#include "bench/compare/statistics.h"

namespace spoke::reproduce {

/// What a measurement is of.
enum class Work {
  steps,    ///< whole steps of rk4
  inverse,  ///< the nodes "inverse" of as many steps
  run,      ///< the 20 s from the start, with generalized_alpha
};
/// "steps", "inverse", "run".
std::string_view name_of(Work work);

/// All to be measured of a kind, each formulation's serial one first. Without OpenMP in this build
/// there are no nested teams.
std::vector<compare::Configuration> configurations_of(Work work);
/// Whether this build has the two schemes of the paper.
bool has_schemes();

/// One of the paper's schemes (1 or 2), with the formulation subsystem.
compare::Configuration scheme(int number, graph::Threads threads);
/// Any other.
compare::Configuration serial(Formulation formulation);
compare::Configuration automatic(Formulation formulation);

/// Time per step, or of a run [s].
using Spread = compare::Quartiles;

/// From so many rounds on there are quartiles, and what follows from them.
inline constexpr std::size_t kLeastRounds = 3;

/// One time by another of the same round.
using Ratio = compare::Quartiles;

/// What a ratio says of a limit.
enum class Side {
  below,
  above,
  untold,  ///< the quartiles are on both sides of it, or there are too few rounds for quartiles
};
Side side_of(const Ratio& ratio, double limit);

class Timings {
 public:
  void set(Work work, std::vector<compare::Measurement> measurements);

  const std::vector<compare::Measurement>& all(Work work) const;
  /// None if it was not measured, or gave no sample.
  std::optional<Spread> find(Work work, const compare::Configuration& configuration) const;
  /// The first one's time by the second one's.
  std::optional<Ratio> ratio(Work work, const compare::Configuration& above,
                             const compare::Configuration& below) const;

 private:
  const compare::Measurement* measurement(Work work,
                                          const compare::Configuration& configuration) const;

  std::vector<compare::Measurement> of_[3];
};

}  // namespace spoke::reproduce
