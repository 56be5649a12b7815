// The rows of the tables, beside the paper's values.

#include "bench/reproduce/tables.h"

#include <spdlog/fmt/fmt.h>

#include "bench/reproduce/operation_counts.h"
#include "bench/reproduce/paper.h"
#include "graph/machine/duration_text.h"
#include "models/count_text.h"
#include "program/report/markup.h"

namespace spoke::reproduce {
namespace {

using compare::Configuration;
using report::Align;
using report::Column;
using report::Row;
using report::Table;

/// Formats a number in groups of three digits.
std::string grouped(std::int64_t value) {
  const std::string digits = fmt::format("{}", value);
  std::string text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) text += ' ';
    text += digits[k];
  }
  return text;
}

std::string time_text(const std::optional<double>& seconds) {
  return seconds ? graph::duration_text(*seconds) : "-";
}

std::string number_text(const std::optional<double>& value, const char* suffix = "") {
  return value ? fmt::format("{:.2f}{}", *value, suffix) : "-";
}

std::optional<double> median_of(const Reproduction& all, Work work, const Configuration& which) {
  const auto spread = all.timings.find(work, which);
  return spread ? std::optional(spread->median) : std::nullopt;
}

/// Formats the quartiles, or the number of rounds if they are too few for quartiles.
std::string quartiles_text(const Spread& spread) {
  if (spread.rounds < kLeastRounds)
    return counted(static_cast<std::int64_t>(spread.rounds), "round");
  return fmt::format("{} to {}", graph::duration_text(spread.low),
                     graph::duration_text(spread.high));
}

/// Adds the cells of one configuration: time, quartiles, times faster than another.
void add_timing(const Reproduction& all, Work work, const Configuration& which,
                const Configuration& reference, Row& row) {
  const auto spread = all.timings.find(work, which);
  row.cells.push_back(spread ? graph::duration_text(spread->median) : "-");
  row.cells.push_back(spread ? quartiles_text(*spread) : "");
  const auto speedup = all.timings.ratio(work, reference, which);
  row.cells.push_back(speedup ? report::ratio_text(speedup->median) : "-");
}

const Configuration& dense_serial() {
  static const Configuration configuration = serial(Formulation::subsystem);
  return configuration;
}

std::vector<Column> scheme_columns() {
  return {{"threads"},
          {"scheme\u00a01", Align::number},
          {"quartiles", Align::number},
          {"speedup", Align::number},
          {"scheme\u00a02", Align::number},
          {"quartiles", Align::number},
          {"speedup", Align::number},
          {"paper"}};
}

Row scheme_row(const Reproduction& all, Work work, graph::Threads threads, std::string paper) {
  Row row{{fmt::format("{}x{}", threads.outer, threads.inner)}};
  for (const int number : {1, 2})
    add_timing(all, work, scheme(number, threads), dense_serial(), row);
  row.cells.push_back(std::move(paper));
  return row;
}

Row serial_row(const Reproduction& all, Work work, std::string paper) {
  const std::string time = time_text(median_of(all, work, dense_serial()));
  return {{"serial", time, "", "1.00", time, "", "1.00", std::move(paper)}, report::Tone::muted};
}

}  // namespace

Table paper_counts() {
  Table table{"Table 2 as printed",
              {{"part"},
               {"formula"},
               {"evaluated", Align::number},
               {"printed", Align::number},
               {"share", Align::number}},
              {}};
  for (const paper::Count& count : paper::table_2())
    table.rows.push_back({{std::string(name_of(count.stage)), std::string(count.formula),
                           grouped(count.value), grouped(count.printed),
                           fmt::format("{:.2f} %", 100.0 * static_cast<double>(count.value) /
                                                       static_cast<double>(paper::kTable2Total))}});
  table.rows.push_back(
      {{"total", "", grouped(paper::kTable2Total), grouped(paper::kTable2Total), "100 %"}});
  return table;
}

Table our_counts() {
  Table table{"Operations of one evaluation here (multiplications, additions, others)",
              {{"part"},
               {"paper", Align::number},
               {"augmented", Align::number},
               {"subsystem", Align::number},
               {"structured", Align::number}},
              {}};
  constexpr std::array kFormulations{Formulation::augmented, Formulation::subsystem,
                                     Formulation::structured};
  for (const Stage stage : kStages) {
    std::int64_t printed = 0;
    for (const paper::Count& count : paper::table_2())
      if (count.stage == stage) printed += count.value;
    Row row{{std::string(name_of(stage)), grouped(printed)}};
    for (const Formulation formulation : kFormulations)
      row.cells.push_back(grouped(count(formulation, stage).total()));
    table.rows.push_back(row);
  }
  const auto add_sum = [&](const char* name, std::string printed, auto value_of) {
    Row row{{name, std::move(printed)}};
    for (const Formulation formulation : kFormulations)
      row.cells.push_back(grouped(value_of(count(formulation))));
    table.rows.push_back(row);
  };
  add_sum("total", grouped(paper::kTable2Total), [](const Operations& o) { return o.total(); });
  add_sum("of it multiplications", "", [](const Operations& o) { return o.multiplications; });
  add_sum("of it additions", "", [](const Operations& o) { return o.additions; });
  return table;
}

Table deflection_table(const Reproduction& all) {
  Table table{"Tip in the hub's frame",
              {{"model"},
               {"largest lag [m]", Align::number},
               {"at [s]", Align::number},
               {"error", Align::number},
               {"largest |tip.y| after 15 s [m]", Align::number}},
              {}};
  const auto add = [&](const std::string& name, double lag, double time, double residual) {
    table.rows.push_back({{name, fmt::format("{:.6f}", lag), fmt::format("{:.3f}", time),
                           fmt::format("{:.3g} %", 100.0 * std::abs(lag / exact::kLag - 1.0)),
                           fmt::format("{:.6f}", residual)}});
  };
  for (const Deflection* deflection : {&all.paper, &all.stiffened, &all.finest})
    add(deflection->name, deflection->lag, deflection->lag_time, deflection->residual);
  add("exact Euler-Bernoulli beam (independent)", exact::kLag, exact::kLagTime, exact::kResidual);
  table.rows.back().cells[3] = "";
  return table;
}

Table subsystem_table(const Reproduction& all) {
  Table table{"Time per step and speedup over serial, formulation subsystem", scheme_columns(), {}};
  table.rows = {serial_row(all, Work::steps, "4.93 ms (Table 3)"),
                scheme_row(all, Work::steps, 1, ""),
                scheme_row(all, Work::steps, 2, "time falls as 1/threads (text)"),
                scheme_row(all, Work::steps, 3, "1.78 ms, speedup 2.77 (Table 3)")};
  return table;
}

Table layered_table(const Reproduction& all, Work work) {
  const bool is_whole = work == Work::steps;
  Table table{is_whole ? "Time per step and speedup over serial, formulation subsystem"
                       : "The inverse nodes of a step by themselves",
              scheme_columns(),
              {}};
  table.rows = {
      serial_row(all, work, is_whole ? "4.93 ms (Table 3)" : ""),
      scheme_row(all, work, {3, 1}, is_whole ? "1.78 ms (Table 3)" : ""),
      scheme_row(all, work, {3, 2}, is_whole ? "fastest; scheme 1 0.49 ms (Table 3)" : ""),
      scheme_row(all, work, {3, 3}, is_whole ? "slower than 3x2 (text)" : ""),
      scheme_row(
          all, work, {3, 4},
          is_whole ? "slower yet; scheme 2 1.8 x its 3x1 (text)" : "falls from 3x1 to 3x4 (text)")};
  return table;
}

std::optional<graph::Threads> best_layered(const Reproduction& all) {
  std::optional<graph::Threads> best;
  double least = 0.0;
  for (const int inner : {2, 3, 4}) {
    const auto time = median_of(all, Work::steps, scheme(1, {3, inner}));
    if (!time || (best && *time >= least)) continue;
    best = graph::Threads(3, inner);
    least = *time;
  }
  return best;
}

std::vector<MethodTime> method_times(const Reproduction& all) {
  const auto layered = best_layered(all);
  std::vector<MethodTime> times;
  const auto add = [&](std::string name, const Configuration& which) -> MethodTime& {
    MethodTime time{.name = std::move(name),
                    .how = fmt::format("{}, {}", name_of(which.formulation), name_of(which))};
    time.seconds = median_of(all, Work::steps, which);
    if (const auto ratio =
            layered ? all.timings.ratio(Work::steps, which, scheme(1, *layered)) : std::nullopt)
      time.ratio = ratio->median;
    const Integration& integration = all.scenario.integration;
    if (time.seconds) time.run = *time.seconds * integration.duration / integration.step;
    return times.emplace_back(std::move(time));
  };
  const auto print = [](const paper::StepTime& printed, MethodTime& time) {
    time.paper_ms = printed.milliseconds;
    time.paper_ratio = printed.ratio;
  };
  print(paper::kTable3[0], add("conventional", serial(Formulation::augmented)));
  print(paper::kTable3[1], add("subsystem", dense_serial()));
  print(paper::kTable3[2], add("parallel", scheme(1, {3, 1})));
  print(paper::kTable3[3],
        add("layered parallel", scheme(1, layered.value_or(graph::Threads(3, 2)))));
  add("Spoke", serial(Formulation::structured));
  add("Spoke, auto", automatic(Formulation::structured));
  MethodTime implicit{
      .name = "Spoke, implicit",
      .how = fmt::format("structured, serial, generalized_alpha, step {} s", all.implicit.step)};
  if (const auto step = median_of(all, Work::run, serial(Formulation::structured))) {
    implicit.seconds = *step;
    implicit.run = *step * all.scenario.integration.duration / all.implicit.step;
  }
  times.push_back(implicit);
  return times;
}

Table method_table(const Reproduction& all) {
  Table table{"Table 3 and Spoke's own ways",
              {{"method"},
               {"paper, a step", Align::number},
               {"paper, ratio", Align::number},
               {"here, a step", Align::number},
               {"here, ratio", Align::number},
               {"here, the 20 s", Align::number},
               {"here as"}},
              {}};
  for (const MethodTime& time : method_times(all))
    table.rows.push_back(
        {{time.name, time.paper_ms ? fmt::format("{:.2f} ms", *time.paper_ms) : "-",
          number_text(time.paper_ratio), time_text(time.seconds),
          time.ratio ? fmt::format("{:.3g}", *time.ratio) : "-", time_text(time.run), time.how},
         time.paper_ms ? report::Tone::plain : report::Tone::good});
  return table;
}

}  // namespace spoke::reproduce
