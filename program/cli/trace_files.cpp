// Writes the files, prints the summary, and explains why there is nothing to write.

#include "program/cli/trace_files.h"

#include <spdlog/fmt/fmt.h>

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "graph/machine/duration_text.h"
#include "models/count_text.h"
#include "program/cli/report.h"
#include "program/cli/standard_streams.h"
#include "program/trace/files.h"
#include "program/trace/statistics.h"
#include "program/viewer/viewer_page.h"

namespace spoke::cli {
namespace {

std::string describe_steps(const StepTrace& trace) {
  const auto& first = trace.steps.front();
  int passes = 0;
  for (const TracedStep& step : trace.steps) passes += step.passes;
  std::string text =
      fmt::format("{} from t = {:.6g} s on, {}, {}", counted(std::ssize(trace.steps), "step"),
                  first.time, counted(passes, "pass"), counted(std::ssize(trace.slices), "slice"));
  if (trace.dropped_steps > 0)
    text += fmt::format("; {} dropped, the buffer was full", counted(trace.dropped_steps, "step"));
  return text;
}

void print_summary(const StepTrace& trace, const Capacity& capacity) {
  const trace::Summary summary = trace::summarise(trace);
  const int threads = trace.threads;
  print_line("T1", graph::duration_text(summary.work) +
                       ", all nodes of a step one after the other (medians)");
  print_line("Tinf", graph::duration_text(summary.span) + ", the longest path through a step");
  const bool overlaps = trace::overlap(trace);
  print_line(overlaps ? "time per step" : "makespan",
             fmt::format("{}{}, speedup {:.2f}", graph::duration_text(summary.elapsed),
                         overlaps ? " on average, for steps overlap" : "", summary.speedup));
  print_line("bound", fmt::format("{}, {}", graph::duration_text(summary.bound),
                                  overlaps ? fmt::format("T1/{}", threads)
                                           : fmt::format("max(T1/{}, Tinf)", threads)));
  if (capacity.is_known() && threads > 1)
    print_line("capacity",
               capacity.text() + ": bound " +
                   graph::duration_text(trace::bound_at_capacity(trace, summary, capacity)));
  print_line("idle", fmt::format("{:.0f} % of the time of {}", 100.0 * summary.idle,
                                 counted(threads, "thread")));
}

std::string describe_runs(const trace::MoreThreads& more) {
  if (more.window_steps > 1) return fmt::format("windows of {} steps", more.window_steps);
  return more.passes == 1 ? "runs of one pass" : fmt::format("runs of {} passes", more.passes);
}

report::Table table_of(const trace::MoreThreads& more) {
  using report::Align;
  report::Table table{
      fmt::format("More threads, in {}: T1 = {} and Tinf = {} a step, at most {:.3g} times as fast",
                  describe_runs(more), graph::duration_text(more.work),
                  graph::duration_text(more.span), more.bound()),
      {{"threads", Align::number},
       {"list schedule", Align::number},
       {"speedup", Align::number},
       {"auto", Align::number},
       {"speedup", Align::number},
       {"plan of auto"}}};
  for (const trace::StepOnThreads& row : more.rows)
    table.rows.push_back(
        {{std::to_string(row.threads), graph::duration_text(row.scheduled),
          fmt::format("{:.2f}", more.work / row.scheduled), graph::duration_text(row.by_auto),
          fmt::format("{:.2f}", more.work / row.by_auto),
          row.clusters == 1 ? "serial" : counted(row.clusters, "cluster")}});
  return table;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string explain_absence(const std::optional<StepTrace>& steps) {
  if (!steps) return "the run had come to its end before";
  if (steps->dropped_steps == 0) return "the run ended before a step was complete";
  return fmt::format("no step fitted into its buffer; spoke trace --buffer {} would do",
                     megabytes(steps->bytes_of_all));
}

}  // namespace

std::int64_t megabytes(std::size_t bytes) {
  return static_cast<std::int64_t>(std::ceil(1e-6 * static_cast<double>(bytes)));
}

void write_trace(const Simulation& simulation, StepTrace steps, const std::filesystem::path& folder,
                 bool prints, std::optional<trace::MoreThreads> more_threads) {
  assert(!steps.steps.empty());
  trace::Trace trace = trace::describe(simulation, std::move(steps));
  trace.more_threads = std::move(more_threads);
  const trace::WrittenFiles written = trace::write_files(trace, folder, viewer_page());
  if (!prints) return;
  print_line("traced", describe_steps(trace.steps));
  print_line("traced on", trace.steps.executor);
  for (const std::string& note : trace.notes) print_line("", note);
  print_summary(trace.steps, trace.capacity);
  for (const std::string& remark : written.remarks) print_line("", remark);
  const std::string on_size = trace::remark_on_size(trace.steps.slices.size());
  if (!on_size.empty()) print_line("", on_size);
  if (trace.more_threads) {
    print_table(table_of(*trace.more_threads));
    print("\n");
  }
  print_line("written", folder.string() + ": " + list(written.names));
}

void write_trace_of_run(const Simulation& simulation, std::optional<StepTrace> steps,
                        const std::filesystem::path& folder, bool prints) {
  if (steps && !steps->steps.empty())
    return write_trace(simulation, std::move(*steps), folder, prints);
  print_error(fmt::format("warning: no trace written to {}: {}", one_line(folder.string()),
                          explain_absence(steps)));
}

}  // namespace spoke::cli
