#pragma once

// The models whose passes per step are counted, and the passes before the iteration knew of the
// spin.

#include <functional>
#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::bench {

/// A stretch of a run that is judged separately.
struct PassesSpan {
  std::string name;
  double from = 0.0;           ///< its begin [s]; it ends where the run ends
  std::vector<double> before;  ///< passes a step before, one for each step of the model
};

/// The cost of a run of the accuracy asked, before.
struct SolutionBefore {
  double step = 0.0;    ///< [s]
  double passes = 0.0;  ///< a step
  /// Time of the run relative to that of the yardstick; 0: there was no such run.
  double time = 0.0;
};

/// One model, and the criteria by which it is judged.
struct PassesModel {
  std::string name;
  std::function<Scenario()> scenario;
  std::vector<std::string> sensors;  ///< components of the quantity that is compared
  double duration = 0.0;             ///< [s], a whole multiple of every step
  double reference_step = 0.0;       ///< [s]
  std::vector<double> steps;         ///< [s], each twice the one before
  std::vector<PassesSpan> spans;     ///< the first one is the whole run
  SolutionBefore percent, permille;  ///< costs before at 1 % and at 0.1 % error
  double most_passes = 0.0;          ///< promised passes at 1 % error or the largest step
  /// Step [s] from which on the promise holds for all; 0: only as above.
  double most_passes_from = 0.0;
  double least_speedup = 0.0;  ///< promised speedup at 0.1 % error over the time before
  bool slow = false;           ///< whether it takes ten seconds and more
};

std::vector<PassesModel> make_passes_models();

}  // namespace spoke::bench
