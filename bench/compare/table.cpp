// The rows of the table, with remarks and the best one marked.

#include "bench/compare/table.h"

#include <spdlog/fmt/fmt.h>

#include "bench/compare/conclusion.h"
#include "graph/machine/duration_text.h"
#include "models/count_text.h"

namespace spoke::compare {
namespace {

std::string microseconds(double seconds) { return fmt::format("{:.4g}", seconds * 1e6); }

/// Returns remarks on a result that its figures do not show.
std::string remarks_on(const Comparison& comparison, const Result& result) {
  const Measurement& measurement = result.measurement;
  std::string text;
  const auto add = [&](const std::string& remark) {
    if (!remark.empty()) text += (text.empty() ? "" : ", ") + remark;
  };
  if (measurement.status == Status::slow)
    add(fmt::format("slow: {} of {}", measurement.step_times.size(),
                    counted(comparison.rounds, "round")));
  add(measurement.message);
  if (result.oversubscribed) add("oversubscribed");
  return text;
}

std::string bits_of(const Result& result) {
  if (result.measurement.hashes.empty()) return "-";
  return result.hash_equal ? "equal" : "DIFFER";
}

report::Tone tone_of(const Result& result, const Verdict& verdict) {
  if (verdict.is_winner(result)) return report::Tone::good;
  const Status status = result.measurement.status;
  if (status == Status::no_answer || status == Status::failed || !result.hash_equal)
    return report::Tone::bad;
  if (status == Status::slow) return report::Tone::warning;
  return result.oversubscribed ? report::Tone::muted : report::Tone::plain;
}

}  // namespace

report::Table make_table(const Comparison& comparison, const Model& model) {
  using report::Align;
  report::Table table{
      fmt::format("{}: {}, {}; T1 = {} and Tinf = {} a step; {} a sample",
                  name_of(model.formulation), counted(model.size.graph_nodes, "node"),
                  counted(model.size.graph_edges, "edge"), graph::duration_text(model.serial_step),
                  graph::duration_text(model.span_step), counted(model.batch, "step")),
      {{"configuration"},
       {"mean [us]", Align::number},
       {"std dev", Align::number},
       {"median [us]", Align::number},
       {"speedup", Align::number},
       {"quartiles", Align::number},
       {"to bound", Align::number},
       {"at capacity", Align::number},
       {"bits"},
       {"remarks"}}};
  const Verdict verdict = judge(comparison, model.formulation);
  for (const Result& result : comparison.results) {
    if (!belongs_to(result, model.formulation)) continue;
    std::vector<std::string> cells{name_of(result.measurement.configuration)};
    if (const auto& f = result.figures) {
      const std::vector<std::string> figures{
          microseconds(f->mean),
          f->deviation ? microseconds(*f->deviation) : "-",
          microseconds(f->median),
          fmt::format("{:.3f}", f->speedup),
          fmt::format("{:.3f}-{:.3f}", f->speedup_low, f->speedup_high),
          fmt::format("{:.2f}", f->ratio_to_bound),
          f->bound_at_capacity ? fmt::format("{:.2f}", f->median / *f->bound_at_capacity) : "-"};
      cells.insert(cells.end(), figures.begin(), figures.end());
    } else {
      cells.insert(cells.end(), 7, "-");
    }
    cells.push_back(bits_of(result));
    cells.push_back(remarks_on(comparison, result));
    table.rows.push_back({std::move(cells), tone_of(result, verdict)});
  }
  return table;
}

}  // namespace spoke::compare
