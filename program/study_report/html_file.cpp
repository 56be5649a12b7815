// The parts of the page, from top to bottom.

#include "program/study_report/html_file.h"

#include <spdlog/fmt/fmt.h>

#include "models/count_text.h"
#include "program/report/chart.h"
#include "program/report/markup.h"
#include "program/report/page.h"
#include "program/report/study_script.h"
#include "program/study/files.h"
#include "program/study_report/load_part.h"
#include "program/study_report/run_data.h"

namespace spoke::study_report {
namespace {

using report::Align;
using report::Tone;
using study::Analysis;
using study::Response;
using study::ResponseAnalysis;
using study::ResponseKind;
using study::Sampling;
using study::Study;

constexpr const char* kMarkup = R"(<div class="controls">
<label><span>across</span> <select id="scatter-x"></select></label>
<label><span>up</span> <select id="scatter-y"></select></label>
<label><span>colour</span> <select id="colors"></select></label>
<span id="runs-selected"></span>
<button id="runs-clear" type="button">Clear selection</button>
<span class="hint" id="runs-keys">Drag along an axis, or a rectangle among the points, to select runs in both drawings; click an axis to drop its part, double-click to drop all. With the keyboard: left and right go from axis to axis, or from point to point, up and down move the selection of an axis, Enter begins or drops it, + and &#8722; widen and narrow it, 0 drops all.</span>
</div>
<div class="runs">
<figure><figcaption><strong>Parallel coordinates</strong></figcaption><div class="scroll"><canvas id="parallel" tabindex="0" role="application" aria-label="Parallel coordinates of the runs" aria-describedby="runs-keys"></canvas></div></figure>
<figure><figcaption><strong>Points</strong></figcaption><canvas id="scatter" tabindex="0" role="application" aria-label="A point for each run" aria-describedby="runs-keys"></canvas></figure>
</div>
<div class="chosen"><p id="run-values"></p>
<p hidden>Again: <code id="run-replay"></code> <button id="run-copy" type="button">Copy</button></p></div>
<div class="unseen" id="spoken" role="status" aria-live="polite"></div>
<noscript><p class="note warning">The drawings need JavaScript.</p></noscript>
)";

bool is_number(const Response& response) { return response.kind != ResponseKind::history; }

std::string quantity_text(double value, const Response& response) {
  return report::quantity(value, response.unit, 4);
}

std::vector<report::Tile> make_tiles(const Study& study, const Analysis& analysis) {
  const study::RunCounts& counts = analysis.counts;
  const std::int64_t failed = counts.without_responses();
  return {{"runs", std::to_string(study.design.runs), std::string(name_of(study.design.kind))},
          {"parameters", std::to_string(study.parameters.size()), ""},
          {"without result", std::to_string(failed),
           failed == 0 ? "all came to their end"
                       : fmt::format("{} diverged, {} refused", counts.diverged, counts.refused),
           failed == 0 ? Tone::good : Tone::bad},
          {"doubtful", std::to_string(counts.doubtful),
           counts.doubtful == 0 ? "no warnings" : "with warnings, see runs.csv",
           counts.doubtful == 0 ? Tone::good : Tone::warning}};
}

report::Table make_response_table(const Study& study, const Analysis& analysis) {
  report::Table table{.caption = "Responses over all runs that have them",
                      .columns = {{"response"},
                                  {"runs", Align::number},
                                  {"mean", Align::number},
                                  {"deviation", Align::number},
                                  {"least", Align::number},
                                  {"in run", Align::number},
                                  {"greatest", Align::number},
                                  {"in run", Align::number}}};
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    const Response& response = study.responses[k];
    if (!is_number(response)) continue;
    const study::Summary& s = analysis.responses[k].summary;
    if (s.count == 0) {
      table.rows.push_back({{response.name, "0"}, Tone::muted});
      continue;
    }
    table.rows.push_back({{response.name, std::to_string(s.count), quantity_text(s.mean, response),
                           quantity_text(s.deviation, response), quantity_text(s.min, response),
                           std::to_string(s.run_of_min + 1), quantity_text(s.max, response),
                           std::to_string(s.run_of_max + 1)}});
  }
  return table;
}

/// Shows the part of each response's variance that each parameter explains.
report::BarChart make_share_chart(const Study& study, const Analysis& analysis,
                                  const Sampling& sampling) {
  report::BarChart chart{.title = "Part of the variance that one parameter explains",
                         .value = {.title = "part of the variance", .low = 0.0, .high = 1.0}};
  for (const std::size_t i : sampling.sampled()) chart.groups.push_back(study.parameters[i].name);
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    if (analysis.responses[k].summary.count == 0) continue;
    report::BarSeries series{.name = study.responses[k].name};
    for (const study::MainEffect& effect : analysis.responses[k].effects)
      series.bars.emplace_back(report::Bar{.value = effect.share});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Shows the mean response from the lowest to the highest level of each parameter.
report::LineChart make_effect_chart(const Study& study, std::size_t k, const Analysis& analysis) {
  const Response& response = study.responses[k];
  report::LineChart chart{
      .title = "Mean of " + response.name + " by the place of each parameter in its range",
      .x = {.title = "from the parameter's lowest value to its highest", .low = 0.0, .high = 1.0},
      .y = {.title = response.name, .unit = response.unit}};
  for (const study::MainEffect& effect : analysis.responses[k].effects) {
    const study::Parameter& parameter = study.parameters[effect.parameter];
    report::LineSeries line{.name = parameter.name};
    const auto count = static_cast<double>(effect.levels.size());
    for (std::size_t l = 0; l < effect.levels.size(); ++l) {
      const study::EffectLevel& level = effect.levels[l];
      if (level.count == 0) continue;
      const std::string value = plain_text(parameter, level.low);
      line.points.push_back({(static_cast<double>(l) + 0.5) / count, level.mean,
                             level.low == level.high ? value
                                                     : report::figure(level.low, 4) + " to " +
                                                           report::figure(level.high, 4)});
    }
    chart.series.push_back(std::move(line));
  }
  return chart;
}

report::BarChart make_index_chart(const Study& study, std::size_t k, const Analysis& analysis) {
  report::BarChart chart{
      .title = "Sobol indices of " + study.responses[k].name,
      .value = {.title = "part of the variance", .low = 0.0},
  };
  report::BarSeries first{.name = "by itself (first order)"},
      total{.name = "with all others (total)"};
  for (const study::SobolIndex& index : analysis.responses[k].indices) {
    chart.groups.push_back(study.parameters[index.parameter].name);
    first.bars.emplace_back(report::Bar{.value = std::max(index.first, 0.0),
                                        .text = fmt::format("{:.3f}", index.first)});
    total.bars.emplace_back(
        report::Bar{.value = index.total, .text = fmt::format("{:.3f}", index.total)});
  }
  chart.series = {std::move(first), std::move(total)};
  return chart;
}

void add_effects(const Study& study, const Sampling& sampling, const Analysis& analysis,
                 report::Page& page) {
  if (study.design.kind == study::DesignKind::table) return;
  page.add_heading("What the responses depend on");
  page.add_paragraph(
      "Main effects: the mean response where a parameter has one value, or lies in one of equally "
      "probable parts of its range, over all that the others do meanwhile; and the part of the "
      "response's variance that these means explain. What several parameters do together only is "
      "in no main effect.");
  page.add_figure(report::render(make_share_chart(study, analysis, sampling)));
  page.add_markup("<div class=\"side\">\n");
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    if (!is_number(study.responses[k]) || analysis.responses[k].summary.count == 0) continue;
    if (!analysis.responses[k].indices.empty())
      page.add_figure(report::render(make_index_chart(study, k, analysis)),
                      "From " + counted(analysis.responses[k].index_points, "point") +
                          " whose runs all have the response.");
    page.add_figure(report::render(make_effect_chart(study, k, analysis)));
  }
  page.add_markup("</div>\n");
}

void add_commands(const Study& study, const Sampling& sampling, const Analysis& analysis,
                  report::Page& page) {
  page.add_heading("Runs to look at");
  report::Table ends{.caption = "Runs at the ends, and the commands that make them again",
                     .columns = {{"response"}, {""}, {"run", Align::number}, {"command"}}};
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    const study::Summary& s = analysis.responses[k].summary;
    if (s.count == 0) continue;
    const auto add = [&](const char* what, std::int64_t run) {
      ends.rows.push_back({{study.responses[k].name, what, std::to_string(run + 1),
                            study::replay_command(study, sampling, run)}});
    };
    add("least", s.run_of_min);
    add("greatest", s.run_of_max);
  }
  if (!study.responses.empty()) page.add_table(ends);
  if (analysis.failed.empty()) return;
  report::Table failed{
      .caption = "Runs without result" +
                 std::string(analysis.counts.without_responses() > std::ssize(analysis.failed)
                                 ? ", the first of them; all are in runs.csv"
                                 : ""),
      .columns = {{"run", Align::number}, {"status"}, {"why"}, {"command"}}};
  for (const study::FailedRun& run : analysis.failed)
    failed.rows.push_back({{std::to_string(run.run + 1), std::string(name_of(run.status)),
                            run.diagnosis, study::replay_command(study, sampling, run.run)},
                           Tone::bad});
  page.add_table(failed);
}

}  // namespace

std::string make_html(const Study& study, const Sampling& sampling,
                      const study::ForEachRun& for_each, const Analysis& analysis,
                      const std::optional<study::LoadAnalysis>& loads) {
  report::Page page(study.title, fmt::format("{} of {}, {}", counted(study.design.runs, "run"),
                                             study.scenario_file, name_of(study.design.kind)));
  page.widen();
  page.add_tiles(make_tiles(study, analysis));
  page.add_heading("Runs");
  if (const std::int64_t stride = drawn_stride(study); stride > 1)
    page.add_paragraph(fmt::format("Drawn is every {}th run; all are in runs.csv.", stride));
  page.add_markup(kMarkup);
  if (!study.responses.empty()) page.add_table(make_response_table(study, analysis));
  if (loads) add_loads(study, *loads, page);
  add_effects(study, sampling, analysis, page);
  if (!study.responses.empty() || !analysis.failed.empty())
    add_commands(study, sampling, analysis, page);
  page.add_data("study-data", make_run_data(study, sampling, for_each));
  page.add_script(report::study_script());
  return page.html();
}

}  // namespace spoke::study_report
