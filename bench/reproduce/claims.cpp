// The claims, a function for each table and figure, and their table.

#include "bench/reproduce/claims.h"

#include <spdlog/fmt/fmt.h>

#include "bench/reproduce/paper.h"
#include "bench/reproduce/tables.h"
#include "program/report/markup.h"

namespace spoke::reproduce {
namespace {

using Kind = Condition::Kind;
using Claims = std::vector<Claim>;

constexpr double kGain = 0.97;  // share of the time without threads below which they gain something
constexpr Condition kGains{Kind::below, 0.0, kGain};
constexpr Condition kLoses{Kind::above, 1.0, 0.0};
constexpr Condition kAlike{Kind::between, 1.0 / 1.1, 1.1};
constexpr Condition kTwoThreads{Kind::above, 1.6, 0.0};    // least speedup on two processors
constexpr Condition kThreeThreads{Kind::above, 2.2, 0.0};  // least speedup on three processors

double as_number(std::int64_t value) { return static_cast<double>(value); }

std::optional<bool> is_met(const Condition& condition, const Ratio& ratio) {
  const auto is_above = [&](double limit) -> std::optional<bool> {
    const Side side = side_of(ratio, limit);
    return side == Side::untold ? std::nullopt : std::optional(side == Side::above);
  };
  const auto above_low = condition.kind == Kind::below ? true : is_above(condition.low);
  const auto above_high = condition.kind == Kind::above ? false : is_above(condition.high);
  if (above_low == false || above_high == true) return false;
  if (above_low && above_high) return true;
  return {};
}

/// Makes a claim about a computed number, which does not vary.
Claim computed(std::string what, std::optional<double> paper, double here,
               const Condition& condition = {}) {
  Claim claim{std::move(what), paper, here, {}, condition, {}};
  if (condition.kind != Kind::none)
    claim.holds = is_met(condition, {here, here, here, kLeastRounds});
  return claim;
}

/// Makes a claim about the ratio of two times in the same rounds.
Claim timed(std::string what, std::optional<double> paper, const std::optional<Ratio>& ratio,
            const Condition& condition = {}) {
  Claim claim{std::move(what), paper, {}, ratio, condition, {}};
  if (!ratio) return claim;
  claim.here = ratio->median;
  if (condition.kind != Kind::none) claim.holds = is_met(condition, *ratio);
  return claim;
}

/// Makes a claim as timed() does, open on a busy machine, where threads wait for processors.
Claim timed_on_threads(const Reproduction& all, std::string what, std::optional<double> paper,
                       const std::optional<Ratio>& ratio, const Condition& condition) {
  Claim claim = timed(std::move(what), paper, ratio, condition);
  if (is_disturbed(all)) claim.holds.reset();
  return claim;
}

Condition around(double value, double share) {
  return {Kind::between, value * (1.0 - share), value * (1.0 + share)};
}

std::string number_text(const std::optional<double>& value) {
  return value ? report::figure(*value) : "-";
}

std::string text_between(double low, double high) {
  const std::string from = report::figure(low), to = report::figure(high);
  return from == to ? "= " + to : from + " to " + to;
}

report::Row row_of(const Claim& claim) {
  const auto& ratio = claim.measured;
  const bool has_quartiles = ratio && ratio->rounds >= kLeastRounds;
  const bool is_comparable = claim.paper && claim.here;
  const bool is_open = claim.condition.kind != Kind::none && !claim.holds;
  const char* const holds = claim.holds ? (*claim.holds ? "yes" : "no") : is_open ? "open" : "";
  return {{claim.what, number_text(claim.paper), number_text(claim.here),
           has_quartiles ? text_between(ratio->low, ratio->high) : "",
           is_comparable ? report::ratio_text(*claim.here / *claim.paper) : "-",
           text_of(claim.condition), holds},
          claim.holds == false ? report::Tone::warning : report::Tone::plain};
}

}  // namespace

Claims claims_on_counts() {
  const auto total = [](Formulation formulation) { return as_number(count(formulation).total()); };
  const paper::InverseSizes sizes = paper::inverse_sizes();
  double evaluated = 0.0;
  for (const paper::Count& line : paper::table_2()) evaluated += as_number(line.value);
  const double printed = as_number(sizes.printed), subsystem = total(Formulation::subsystem);
  const double inverse = as_number(count(Formulation::subsystem, Stage::inverse).total());
  return {computed("total, the formulas evaluated", as_number(paper::kTable2Total), evaluated,
                   around(as_number(paper::kTable2Total), 1e-9)),
          computed("inverse of M_sub by n^3/3, with the 60 unknowns of a blade", printed,
                   as_number(sizes.blade), around(printed, 0.1)),
          computed("the same, twelve blocks of 15 as in (P 11)", printed, as_number(sizes.blocks),
                   around(printed, 0.1)),
          computed("inverse, share of all operations", printed / as_number(paper::kTable2Total),
                   inverse / subsystem),
          computed("augmented / subsystem", {}, total(Formulation::augmented) / subsystem),
          computed("subsystem / structured", {}, subsystem / total(Formulation::structured))};
}

Claims claims_on_drive(const Reproduction& all) {
  if (all.drive.empty()) return {};
  return {computed("hub's final speed [rad/s]; the paper's by Wu and Haug (1988)",
                   paper::kFinalSpeed, all.drive.back().motion.speed,
                   around(paper::kFinalSpeed, 1e-3))};
}

Claims claims_on_subsystem_threads(const Reproduction& all) {
  if (!has_schemes()) return {};
  Claims claims;
  for (const int number : {1, 2})
    for (const int threads : {2, 3})
      claims.push_back(timed_on_threads(
          all, fmt::format("speedup of scheme {} on {} threads", number, threads),
          threads == 2 ? 2.0 : paper::kTable3[1].milliseconds / paper::kTable3[2].milliseconds,
          all.timings.ratio(Work::steps, serial(Formulation::subsystem), scheme(number, threads)),
          threads == 2 ? kTwoThreads : kThreeThreads));
  claims.push_back(timed_on_threads(all, "scheme 1 / scheme 2, on two threads", 1.0,
                                    all.timings.ratio(Work::steps, scheme(1, 2), scheme(2, 2)),
                                    kAlike));
  return claims;
}

Claims claims_on_layers(const Reproduction& all) {
  if (!has_schemes()) return {};
  const auto slower = [&](int number, int inner) {
    return all.timings.ratio(Work::steps, scheme(number, {3, inner}), scheme(number, {3, 1}));
  };
  const double layered = paper::kTable3[3].milliseconds / paper::kTable3[2].milliseconds;
  return {
      timed_on_threads(all, "scheme 1, 3x2 / 3x1", layered, slower(1, 2), kGains),
      timed_on_threads(all, "scheme 2, 3x2 / 3x1", {}, slower(2, 2), {}),
      timed_on_threads(all, "scheme 1, 3x4 / 3x1", {}, slower(1, 4), {}),
      timed_on_threads(all, "scheme 2, 3x4 / 3x1", paper::kScheme2Slowdown, slower(2, 4), kLoses)};
}

Claims claims_on_inverse(const Reproduction& all) {
  constexpr double kShare = 0.986;  // share in Table 2, with its items of effective mass and force
  Claims claims;
  if (all.inverse_share > 0.0)
    claims.push_back(computed("inverse nodes, share of a serial step", kShare, all.inverse_share));
  if (!has_schemes()) return claims;
  for (const int number : {1, 2})
    claims.push_back(timed_on_threads(
        all, fmt::format("scheme {}, 3x4 / 3x1, which the paper sees fall", number), {},
        all.timings.ratio(Work::inverse, scheme(number, {3, 4}), scheme(number, {3, 1})), kGains));
  return claims;
}

Claims claims_on_methods(const Reproduction& all) {
  const auto dense = serial(Formulation::subsystem), own = serial(Formulation::structured);
  const auto printed = [](std::size_t above, std::size_t below) {
    return paper::kTable3[above].milliseconds / paper::kTable3[below].milliseconds;
  };
  const auto ratio = [&](const auto& above, const auto& below) {
    return all.timings.ratio(Work::steps, above, below);
  };
  Claims claims{timed("conventional / subsystem", printed(0, 1),
                      ratio(serial(Formulation::augmented), dense), {Kind::above, 1.5, 0.0})};
  if (const auto layered = best_layered(all)) {
    claims.push_back(timed_on_threads(all, "subsystem / parallel", printed(1, 2),
                                      ratio(dense, scheme(1, 3)), kThreeThreads));
    claims.push_back(timed_on_threads(all, "parallel / layered parallel", printed(2, 3),
                                      ratio(scheme(1, 3), scheme(1, *layered)),
                                      {Kind::above, 1.0 / kGain, 0.0}));
  }
  claims.push_back(timed("subsystem / structured, both serial", {}, ratio(dense, own)));
  claims.push_back(
      timed("structured, auto / serial", {}, ratio(automatic(Formulation::structured), own)));
  return claims;
}

std::string text_of(const Condition& condition) {
  switch (condition.kind) {
    case Kind::below:
      return "< " + report::figure(condition.high);
    case Kind::above:
      return "> " + report::figure(condition.low);
    case Kind::between:
      return text_between(condition.low, condition.high);
    case Kind::none:
      break;
  }
  return "";
}

report::Table claim_table(const Claims& claims) {
  using report::Align;
  report::Table table{"The paper's numbers and ours",
                      {{""},
                       {"paper", Align::number},
                       {"here", Align::number},
                       {"quartiles", Align::number},
                       {"here / paper", Align::number},
                       {"holds if", Align::number},
                       {"holds"}},
                      {}};
  for (const Claim& claim : claims) table.rows.push_back(row_of(claim));
  return table;
}

}  // namespace spoke::reproduce
