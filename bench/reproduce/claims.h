#pragma once

// What the paper says in numbers, beside what was computed and measured here.

#include <optional>
#include <string>
#include <vector>

#include "bench/reproduce/reproduction.h"
#include "program/report/page.h"

namespace spoke::reproduce {

/// When a number of the paper holds here.
struct Condition {
  enum class Kind { none, below, above, between };
  Kind kind = Kind::none;
  double low = 0.0, high = 0.0;  ///< below: `high`, above: `low`
};

/// A number of the paper and ours.
struct Claim {
  std::string what = {};
  std::optional<double> paper = {};    ///< none: Spoke's own
  std::optional<double> here = {};     ///< none: not measured
  std::optional<Ratio> measured = {};  ///< over the rounds, of what was timed
  Condition condition = {};
  /// None without a condition; nor if it was not measured, the quartiles lie on both sides of a
  /// limit, or it is of threads on a busy machine.
  std::optional<bool> holds = {};
};

/// Table 2: sizes and counts of operations.
std::vector<Claim> claims_on_counts();
/// Fig. 8: the hub's final speed.
std::vector<Claim> claims_on_drive(const Reproduction& reproduction);
/// Fig. 10 to 12; none without OpenMP in this build, but for the share of the inverse part.
std::vector<Claim> claims_on_subsystem_threads(const Reproduction& reproduction);
std::vector<Claim> claims_on_layers(const Reproduction& reproduction);
std::vector<Claim> claims_on_inverse(const Reproduction& reproduction);
/// Fig. 13 and Table 3.
std::vector<Claim> claims_on_methods(const Reproduction& reproduction);

/// A row per claim: the paper's value, ours, its quartiles, ours by the paper's, whether it holds.
report::Table claim_table(const std::vector<Claim>& claims);
/// "< 0.97", "> 2.2", "0.91 to 1.1", or nothing.
std::string text_of(const Condition& condition);

}  // namespace spoke::reproduce
