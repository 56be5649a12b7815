#pragma once

// Cases whose results are known: a scenario, an analysis of it, and figures with their exact or
// published values.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/critical.h"
#include "engine/modes.h"
#include "engine/performance.h"
#include "models/scenario.h"

namespace spoke::verify {

/// What is done with a scenario.
enum class AnalysisKind { steady, modes, critical, performance, linearize, run };

/// Returns "static", "modes", "critical", "performance", "linearize", "run".
std::string_view name_of(AnalysisKind kind);

/// An analysis with its options; those of other kinds stay as they are.
struct Analysis {
  AnalysisKind kind = AnalysisKind::modes;
  SteadyState state{};  ///< static, modes, linearize, critical loads
  std::optional<int> count{};
  std::optional<ModeFrame> frame{};
  CriticalOptions critical{};
  PerformanceOptions performance{};
};

/// A number that a case is judged by.
struct Figure {
  std::string name;      ///< "first flap frequency"
  std::string quantity;  ///< what is read, a word that the analysis knows: "frequency"
  std::string of;        ///< of what: a mode, a sensor, a joint; may be empty
  int number = 1;        ///< of several that are alike, from 1
  double at = 0.0;       ///< time of a run [s], frequency of an answer [rad/s]
  double exact = 0.0;    ///< in its unit
  std::string unit;      ///< "rad/s", "Hz", "kN"; "": dimensionless
  double error = 0.0;    ///< allowed, a share of `scale`
  double scale = 0.0;    ///< by which errors are measured: by default the exact value's magnitude
  double times = 1.0;    ///< factor of Spoke's value before it is compared
};

/// A case: what is computed, where the values to compare with are from, and these.
struct Case {
  std::string name;      ///< "beck_column", unique
  std::string group;     ///< heading that it stands under
  std::string title;     ///< a sentence about the model
  std::string source;    ///< citation
  std::string by;        ///< how the value was got: "closed form", "published", ...
  std::string scenario;  ///< name of the scenario's file without its ending
  Overrides overrides;   ///< as by --set
  Analysis analysis;
  std::vector<Figure> figures;
};

/// Returns the factor from SI to a unit of figures; 0: the unit is not known.
double factor_of_unit(std::string_view unit);

/// Returns the command that does the same as a case by hand, the scenario being in `folder`; of
/// several winds, ratios or pitches for the first.
std::string command_of(const Case& one, const std::string& folder);

}  // namespace spoke::verify
