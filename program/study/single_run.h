#pragma once

// One run of a study, on one thread.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "program/study/measurement.h"
#include "program/study/sampling.h"
#include "program/study/sensor_statistics.h"
#include "program/study/study.h"

namespace spoke {
class Simulation;
struct Scenario;
}  // namespace spoke

namespace spoke::study {

/// The end of a run.
enum class RunStatus : std::uint8_t {
  done,
  doubtful,  ///< done, with warnings
  diverged,
  refused,  ///< the scenario does not accept the values
};

/// Returns "done", "doubtful", "diverged" or "refused".
std::string_view name_of(RunStatus status);

/// The result of a run.
struct RunResult {
  std::int64_t run = 0;
  RunStatus status = RunStatus::done;
  std::string diagnosis;           ///< reason of divergence or refusal, or the warnings
  std::vector<double> responses;   ///< values by response; not a number: none, or a history
  std::vector<History> histories;  ///< histories, in the order of the responses that are histories
  std::vector<SensorStatistics> statistics;  ///< by sensor of the study's statistics; or none

  bool has_responses() const { return status <= RunStatus::doubtful; }
};

/// Finds a run whose scenario can be simulated and has the sensors and modes that are asked for,
/// and fills in their units. Throws InputError if all runs are refused, or so many of them, spread
/// evenly, that the study itself must be wrong. The error is that of run 1, with its place in the
/// study file, whichever run was tried first.
void check_study(Study& study);

/// Makes runs, one after the other, on one thread; each has the bits that it would have alone.
/// Constants, factorisations and step graph of one run serve the next if only values of the drive
/// differ.
class RunMaker {
 public:
  /// Refers to both, which must outlive this object.
  RunMaker(const Study& study, const Sampling& sampling);
  ~RunMaker();
  RunMaker(const RunMaker&) = delete;
  RunMaker& operator=(const RunMaker&) = delete;

  /// Makes a run. Faults due to the values of parameters become part of the result.
  RunResult make(std::int64_t run);

 private:
  struct Built;

  Simulation& simulation_of(const Scenario& scenario, const std::vector<double>& values);
  void run_scenario(const Scenario& scenario, const std::vector<double>& values, RunResult& result);

  const Study& study_;
  const Sampling& sampling_;
  std::unique_ptr<Built> built_;  ///< model of the last run that simulated
};

}  // namespace spoke::study
