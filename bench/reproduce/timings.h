#pragma once

// Configurations that the paper's timings need, and their measured times.

#include <optional>
#include <vector>

#include "bench/compare/rounds.h"
#include "bench/compare/statistics.h"

namespace spoke::reproduce {

/// The work that a measurement times.
enum class Work {
  steps,    ///< whole steps of rk4
  inverse,  ///< the nodes "inverse" of as many steps
  run,      ///< the 20 s from the start, with generalized_alpha
};
/// Returns "steps", "inverse" or "run".
std::string_view name_of(Work work);

/// Returns all configurations to measure for a kind of work, each formulation's serial one first.
/// Without OpenMP in this build there are no nested teams.
std::vector<compare::Configuration> configurations_of(Work work);
/// Whether this build has the two schemes of the paper.
bool has_schemes();

/// Returns one of the paper's schemes (1 or 2), with the formulation subsystem.
compare::Configuration scheme(int number, graph::Threads threads);
/// Returns the executor serial or auto with a formulation.
compare::Configuration serial(Formulation formulation);
compare::Configuration automatic(Formulation formulation);

/// Quartiles of the time per step, or of a run [s].
using Spread = compare::Quartiles;

/// Least number of rounds for quartiles and verdicts by them.
inline constexpr std::size_t kLeastRounds = 3;

/// Quartiles of the ratio of two times in the same round.
using Ratio = compare::Quartiles;

/// Side of a limit on which a ratio lies.
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
  /// Returns none if the configuration was not measured, or gave no sample.
  std::optional<Spread> find(Work work, const compare::Configuration& configuration) const;
  /// Returns the ratio of the first one's time to the second one's.
  std::optional<Ratio> ratio(Work work, const compare::Configuration& above,
                             const compare::Configuration& below) const;

 private:
  const compare::Measurement* measurement(Work work,
                                          const compare::Configuration& configuration) const;

  std::vector<compare::Measurement> of_[3];
};

}  // namespace spoke::reproduce
