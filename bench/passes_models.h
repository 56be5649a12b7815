#pragma once

// The models whose passes a step are counted, and what the engine needed before its iteration knew
// of the spin.

#include <functional>
#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::bench {

/// A stretch of a run that is judged by itself.
struct PassesSpan {
  std::string name;
  double from = 0.0;           ///< [s]; it ends where the run ends
  std::vector<double> before;  ///< passes a step then, one for each step of the model
};

/// What a run as accurate as asked took before.
struct SolutionBefore {
  double step = 0.0;    ///< [s]
  double passes = 0.0;  ///< a step
  double time = 0.0;    ///< of the run, by that of the yardstick; 0: there was no such run
};

/// One model, and how it is judged.
struct PassesModel {
  std::string name;
  std::function<Scenario()> scenario;
  std::vector<std::string> sensors;  ///< the components of what is compared
  double duration = 0.0;             ///< [s], a whole number of every step
  double reference_step = 0.0;       ///< [s]
  std::vector<double> steps;         ///< [s], each twice the one before
  std::vector<PassesSpan> spans;     ///< the first one is the whole run
  SolutionBefore percent, permille;  ///< at 1 % and at 0.1 % error
  double most_passes = 0.0;          ///< what was promised, at 1 % error or the largest step
  double most_passes_from = 0.0;     ///< [s]; if not 0, of all steps from this one on
  double least_speedup = 0.0;        ///< likewise, at 0.1 % error, over the time before
  bool slow = false;                 ///< takes ten seconds and more
};

std::vector<PassesModel> make_passes_models();

}  // namespace spoke::bench
