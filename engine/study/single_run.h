#pragma once

// One run of a study, on one thread.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/study/measurement.h"
#include "engine/study/sampling.h"
#include "engine/study/study.h"

namespace spoke {
class Simulation;
struct Scenario;
}  // namespace spoke

namespace spoke::study {

/// How a run ended.
enum class RunStatus : std::uint8_t {
  done,
  doubtful,  ///< done, with warnings
  diverged,
  refused,  ///< the scenario does not take the values
};

/// "done", "doubtful", "diverged", "refused".
std::string_view name_of(RunStatus status);

/// What a run leaves.
struct RunResult {
  std::int64_t run = 0;
  RunStatus status = RunStatus::done;
  std::string diagnosis;           ///< why it diverged or was refused, or the warnings
  std::vector<double> responses;   ///< by response; not a number: none, or a history
  std::vector<History> histories;  ///< by response that is one, in order

  bool has_responses() const { return status <= RunStatus::doubtful; }
};

/// Finds a run whose scenario can be simulated and has the sensors and modes that are asked for,
/// and fills in their units. Throws InputError if all runs are refused, or so many of them, spread
/// evenly, that it is the study which is wrong: what is said against run 1, with its place in the
/// study file. So it does not matter which run comes first.
void check_study(Study& study);

/// Makes runs, one after the other, on one thread; each has the bits that it would have alone. What
/// was built for one, constants, factorisations and step graph, serves the next if only values of
/// the drive differ.
class RunMaker {
 public:
  /// Both must outlive this.
  RunMaker(const Study& study, const Sampling& sampling);
  ~RunMaker();
  RunMaker(const RunMaker&) = delete;
  RunMaker& operator=(const RunMaker&) = delete;

  /// What depends on the values of parameters becomes part of the result.
  RunResult make(std::int64_t run);

 private:
  struct Built;

  Simulation& simulation_of(const Scenario& scenario, const std::vector<double>& values);
  void run_scenario(const Scenario& scenario, const std::vector<double>& values, RunResult& result);

  const Study& study_;
  const Sampling& sampling_;
  std::unique_ptr<Built> built_;  ///< of the last run that simulated
};

}  // namespace spoke::study
