// The sentences of the conclusion, a function for each.

#include "bench/compare/conclusion.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <functional>

#include "graph/machine/duration_text.h"
#include "models/count_text.h"
#include "program/report/markup.h"

namespace spoke::compare {
namespace {

std::string speedup_text(const Result& result) {
  const auto [speedup, low, high] = std::array{result.figures->speedup, result.figures->speedup_low,
                                               result.figures->speedup_high};
  return fmt::format("{} times serial's speed (quartiles {} to {})", report::ratio_text(speedup),
                     report::ratio_text(low), report::ratio_text(high));
}

/// Names the results whose quartiles overlap those of the best one: they are not distinguishable
/// from it.
std::string describe_equals(const Comparison& comparison, const Result& best) {
  std::vector<std::string> names;
  for (const Result& result : comparison.results) {
    const bool other = &result != &best && !is_serial(result);
    if (!other || !result.figures || !result.hash_equal) continue;
    if (!belongs_to(result, best.measurement.configuration.formulation)) continue;
    if (result.figures->speedup_high >= best.figures->speedup_low)
      names.push_back(name_of(result.measurement.configuration));
  }
  if (names.empty()) return "";
  constexpr std::size_t kMost = 3;
  const std::size_t more = names.size() - std::min(kMost, names.size());
  names.resize(names.size() - more);
  return fmt::format("; within its quartiles, so not told from it: {}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string describe_verdict(const Comparison& comparison, const Model& model) {
  using Kind = Verdict::Kind;
  const Verdict verdict = judge(comparison, model.formulation);
  const std::string serial = graph::duration_text(model.serial_step) + " a step";
  if (verdict.kind == Kind::no_reference) return "serial gave no time, so there is no comparison.";
  if (verdict.kind == Kind::no_rival)
    return "serial takes " + serial + "; nothing else was measured with its bits.";
  const Result& rival = *verdict.rival;
  const std::string name = name_of(rival.measurement.configuration);
  switch (verdict.kind) {
    case Kind::disturbed:
      return fmt::format(
          "no verdict; {} seems to have {}, which is more than work and span allow, so the "
          "measurement was disturbed.",
          name, speedup_text(rival));
    case Kind::serial_wins:
      return fmt::format("serial wins with {}; the next, {}, has {}.", serial, name,
                         speedup_text(rival));
    case Kind::rival_wins:
      return fmt::format("{} is best with {} a step, {}, {:.2f} of the bound by work and span{}.",
                         name, graph::duration_text(rival.figures->median), speedup_text(rival),
                         rival.figures->ratio_to_bound, describe_equals(comparison, rival));
    default:
      return fmt::format("nothing is clearly faster than serial with {}; the nearest, {}, has {}.",
                         serial, name, speedup_text(rival));
  }
}

/// Describes the least time per step of all formulations.
std::string describe_overall(const Comparison& comparison) {
  if (comparison.models.size() < 2) return "";
  const Result* best = nullptr;
  for (const Result& result : comparison.results)
    if (result.figures && result.hash_equal &&
        (best == nullptr || result.figures->median < best->figures->median))
      best = &result;
  if (best == nullptr) return "";
  return fmt::format("The least time of all: {}, {}, {} a step.",
                     name_of(best->measurement.configuration.formulation),
                     name_of(best->measurement.configuration),
                     graph::duration_text(best->figures->median));
}

long count(const Comparison& comparison, const std::function<bool(const Result&)>& has) {
  return std::count_if(comparison.results.begin(), comparison.results.end(), has);
}

std::string describe_bits(const Comparison& comparison) {
  const long others = count(comparison, [](const Result& result) {
    return !is_serial(result) && !result.measurement.hashes.empty();
  });
  if (others == 0) return "";
  const long unequal = count(comparison, [](const Result& result) {
    return !result.measurement.hashes.empty() && !result.hash_equal;
  });
  if (unequal == 0) return "All that were measured have the same bits as serial.";
  return fmt::format("{} of {} ended in bits other than serial's: do not use them.", unequal,
                     comparison.results.size());
}

std::string describe_faults(const Comparison& comparison) {
  std::vector<std::string> parts;
  const auto add = [&](Status status, const char* what_one, const char* what_many) {
    const long number = count(
        comparison, [&](const Result& result) { return result.measurement.status == status; });
    if (number > 0)
      parts.push_back(fmt::format("{} of {} {}", number, comparison.results.size(),
                                  number == 1 ? what_one : what_many));
  };
  add(Status::no_answer, "gave no answer in time and was ended.",
      "gave no answer in time and were ended.");
  add(Status::failed, "failed.", "failed.");
  add(Status::slow, "was so slow that it did fewer rounds.",
      "were so slow that they did fewer rounds.");
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string describe_oversubscribed(const Comparison& comparison) {
  const long many = count(comparison, [](const Result& result) { return result.oversubscribed; });
  if (many == 0) return "";
  const long held = count(comparison, [](const Result& result) {
    const ExecutorKind kind = result.measurement.configuration.executor;
    return result.oversubscribed &&
           (kind == ExecutorKind::flow_graph || kind == ExecutorKind::openmp_scheme1);
  });
  return fmt::format(
      "{} of {} {} more threads than processors: {} what oversubscription costs here, not what so "
      "many processors would give.{}",
      many, comparison.results.size(), many == 1 ? "has" : "have",
      many == 1 ? "it shows" : "they show",
      held > 0 ? " Of flow_graph and openmp_scheme1 no more threads work than there are processors."
               : "");
}

/// Says whether the machine was busy, which makes all the rest doubtful.
std::string describe_disturbance(const Comparison& comparison) {
  if (!is_busy(comparison.loads.before, comparison.machine.cores)) return "";
  return fmt::format(
      "Other work was running (load average {:.2f} at the start): times are too long, ratios may "
      "be "
      "too low or too high, and none of what follows is certain until it is repeated on an idle "
      "machine.",
      comparison.loads.before);
}

std::string describe_machine(const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  std::string text = fmt::format("Measured on {}, {} available",
                                 machine.cpu.empty() ? "an unknown processor" : machine.cpu,
                                 counted(machine.cores, "processor"));
  if (comparison.loads.before < 0.0)
    text += "; its load is not known.";
  else
    text += fmt::format(", load average {:.2f} before and {:.2f} after (this comparison included).",
                        comparison.loads.before, comparison.loads.after);
  if (comparison.capacity.is_known()) text += ' ' + comparison.capacity.text() + '.';
  return text;
}

}  // namespace

std::vector<std::string> make_conclusions(const Comparison& comparison) {
  std::vector<std::string> parts;
  for (const Model& model : comparison.models)
    parts.push_back(std::string(name_of(model.formulation)) + ": " +
                    describe_verdict(comparison, model));
  parts.insert(parts.begin(), describe_disturbance(comparison));
  parts.push_back(describe_overall(comparison));
  parts.push_back(describe_bits(comparison));
  parts.push_back(describe_faults(comparison));
  parts.push_back(describe_oversubscribed(comparison));
  parts.push_back(describe_machine(comparison));
  std::erase(parts, "");
  return parts;
}

std::string make_conclusion(const Comparison& comparison) {
  return fmt::format("{}", fmt::join(make_conclusions(comparison), " "));
}

}  // namespace spoke::compare
