#pragma once

// Numbers of the paper, beside those computed and measured here.

#include <optional>
#include <string>
#include <vector>

#include "bench/reproduce/reproduction.h"
#include "program/report/page.h"

namespace spoke::reproduce {

/// Condition under which a number of the paper holds here.
struct Condition {
  enum class Kind { none, below, above, between };
  Kind kind = Kind::none;
  double low = 0.0, high = 0.0;  ///< limits; below has `high` alone, above `low` alone
};

/// A number of the paper beside Spoke's.
struct Claim {
  std::string what = {};
  std::optional<double> paper = {};    ///< none: Spoke's own
  std::optional<double> here = {};     ///< none: not measured
  std::optional<Ratio> measured = {};  ///< quartiles over the rounds of a timed number
  Condition condition = {};
  /// Whether the condition is met. None without a condition, without a measurement, if the
  /// quartiles lie on both sides of a limit, and for threads on a busy machine.
  std::optional<bool> holds = {};
};

/// Table 2: sizes and counts of operations.
std::vector<Claim> claims_on_counts();
/// Fig. 8: the hub's final speed.
std::vector<Claim> claims_on_drive(const Reproduction& reproduction);
/// Fig. 10 to 12. Without OpenMP in this build there are no claims but that on the share of the
/// inverse part.
std::vector<Claim> claims_on_subsystem_threads(const Reproduction& reproduction);
std::vector<Claim> claims_on_layers(const Reproduction& reproduction);
std::vector<Claim> claims_on_inverse(const Reproduction& reproduction);
/// Fig. 13 and Table 3.
std::vector<Claim> claims_on_methods(const Reproduction& reproduction);

/// Returns a row for each claim: the paper's value, Spoke's, its quartiles, their ratio, and
/// whether the claim holds.
report::Table claim_table(const std::vector<Claim>& claims);
/// Returns "< 0.97", "> 2.2", "0.91 to 1.1", or an empty text.
std::string text_of(const Condition& condition);

}  // namespace spoke::reproduce
