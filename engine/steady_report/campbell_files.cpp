// Tables, files and the page of a Campbell diagram.

#include "engine/steady_report/campbell_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/chart.h"
#include "engine/steady_report/mode_files.h"
#include "engine/support/json.h"

namespace spoke::steady_report {
namespace {

using report::Align;

double hertz(double frequency) { return frequency / (2.0 * std::numbers::pi); }
double speed_at(const CampbellResult& result, std::size_t k) {
  return result.states[k].equilibrium.speed;
}

/// The mode of a branch at speed k; null if there is none.
const Mode* mode_at(const CampbellResult& result, const CampbellBranch& branch, std::size_t k) {
  return branch.modes[k] ? &result.states[k].modes[*branch.modes[k]] : nullptr;
}

std::string frequency_text(const Mode* mode) {
  return mode ? fmt::format("{:.6g}", hertz(mode->frequency)) : std::string();
}

std::string title_of(const CampbellBranch& branch) { return branch.of + ": " + branch.name; }

/// A line of each branch, by what `value` makes of a mode.
template <class Value>
report::LineChart make_chart(const CampbellResult& result, const char* title,
                             const report::Axis& axis, const Value& value) {
  report::LineChart chart{.title = title, .x = {.title = "speed", .unit = "rad/s"}, .y = axis};
  for (const CampbellBranch& branch : result.branches) {
    report::LineSeries line{.name = title_of(branch)};
    for (std::size_t k = 0; k < result.states.size(); ++k)
      if (const Mode* mode = mode_at(result, branch, k))
        line.points.push_back({speed_at(result, k), value(*mode), mode->name});
    chart.series.push_back(std::move(line));
  }
  return chart;
}

/// The frequencies that the diagram shows [Hz]: those that excitation lines come near, and the
/// lowest three branches; lines would be crowded at the bottom if all were shown.
double highest_shown(const CampbellResult& result, const report::LineChart& chart, int harmonics) {
  std::vector<double> peaks;
  for (const report::LineSeries& line : chart.series) {
    double peak = 0.0;
    for (const report::DataPoint& point : line.points) peak = std::max(peak, point.y);
    peaks.push_back(peak);
  }
  std::sort(peaks.begin(), peaks.end());
  double speed = 0.0;
  for (std::size_t k = 0; k < result.states.size(); ++k)
    speed = std::max(speed, std::abs(speed_at(result, k)));
  if (peaks.empty()) return 0.0;
  const double lowest = peaks[std::min<std::size_t>(peaks.size(), 3) - 1];
  const double excited = 1.25 * hertz(harmonics * speed);
  return harmonics == 0 ? peaks.back() : std::min(peaks.back(), std::max(lowest, excited));
}

void add_excitation_lines(const CampbellResult& result, int harmonics, report::LineChart& chart) {
  for (int n = 1; n <= harmonics; ++n) {
    report::LineSeries line{
        .name = fmt::format("{} per revolution", n), .markers = false, .dashed = true};
    for (std::size_t k = 0; k < result.states.size(); ++k)
      line.points.push_back({speed_at(result, k), hertz(n * std::abs(speed_at(result, k)))});
    chart.series.push_back(std::move(line));
  }
}

report::LineChart make_diagram(const CampbellResult& result, int harmonics) {
  report::LineChart chart =
      make_chart(result, "Frequencies over speed", {.title = "frequency", .unit = "Hz"},
                 [](const Mode& mode) { return hertz(mode.frequency); });
  chart.y.low = 0.0;
  chart.y.high = 1.05 * highest_shown(result, chart, harmonics);
  add_excitation_lines(result, harmonics, chart);
  for (report::LineSeries& line : chart.series)
    std::erase_if(line.points, [&](const report::DataPoint& p) { return p.y > *chart.y.high; });
  std::erase_if(chart.series,
                [](const report::LineSeries& line) { return line.points.size() < 2; });
  return chart;
}

/// Whether a mode is damped, or grows, by more than round-off.
bool is_damped(const CampbellResult& result) {
  for (const ModesResult& state : result.states)
    for (const Mode& mode : state.modes)
      if (damping_of(mode) != 0.0) return true;
  return false;
}

}  // namespace

report::Table make_crossing_table(const CampbellResult& result) {
  report::Table table{.caption = "Crossings",
                      .columns = {{"of"},
                                  {"mode"},
                                  {"per revolution", Align::number},
                                  {"speed [rad/s]", Align::number},
                                  {"frequency [Hz]", Align::number},
                                  {"margin", Align::number}}};
  for (const CampbellCrossing& crossing : result.crossings) {
    const CampbellBranch& branch = result.branches[crossing.branch];
    table.rows.push_back(
        {{branch.of, branch.name, std::to_string(crossing.harmonic),
          fmt::format("{:.5g}", crossing.speed), fmt::format("{:.5g}", hertz(crossing.frequency)),
          crossing.margin ? fmt::format("{:.1f} %", 100.0 * *crossing.margin) : ""}});
  }
  return table;
}

report::Table make_branch_table(const CampbellResult& result) {
  const std::size_t last = result.states.size() - 1;
  report::Table table{
      .caption = "Modes, frequencies in Hz",
      .columns = {{"of"},
                  {"mode"},
                  {fmt::format("at {:.5g} rad/s", speed_at(result, 0)), Align::number},
                  {fmt::format("at {:.5g} rad/s", speed_at(result, last)), Align::number}}};
  for (const CampbellBranch& branch : result.branches)
    table.rows.push_back({{branch.of, branch.name, frequency_text(mode_at(result, branch, 0)),
                           frequency_text(mode_at(result, branch, last))}});
  return table;
}

report::Table make_gap_table(const CampbellResult& result) {
  report::Table table{.caption = "Speeds without equilibrium",
                      .columns = {{"speed [rad/s]", Align::number}, {"why"}}};
  for (const CampbellGap& gap : result.gaps)
    table.rows.push_back({{fmt::format("{:.6g}", speed_at(result, gap.speed)), gap.reason}});
  return table;
}

std::string make_csv(const CampbellResult& result) {
  std::string text =
      "speed_rad_per_s,branch,of,mode,frequency_Hz,frequency_rad_per_s,damping_ratio,grows\n";
  for (std::size_t k = 0; k < result.states.size(); ++k)
    for (std::size_t b = 0; b < result.branches.size(); ++b)
      if (const Mode* mode = mode_at(result, result.branches[b], k))
        text += fmt::format("{},{},\"{}\",{},{},{},{},{}\n", speed_at(result, k), b + 1,
                            result.branches[b].of, result.branches[b].name, hertz(mode->frequency),
                            mode->frequency, damping_of(*mode), mode->grows() ? 1 : 0);
  return text;
}

std::string make_json(const CampbellResult& result) {
  Json speeds = Json::array(), branches = Json::array(), crossings = Json::array(),
       gaps = Json::array();
  for (std::size_t k = 0; k < result.states.size(); ++k) speeds.push_back(speed_at(result, k));
  for (const CampbellBranch& branch : result.branches) {
    Json frequencies = Json::array(), damping = Json::array();
    for (std::size_t k = 0; k < result.states.size(); ++k) {
      const Mode* mode = mode_at(result, branch, k);
      frequencies.push_back(mode ? Json(mode->frequency) : Json());
      damping.push_back(mode ? Json(damping_of(*mode)) : Json());
    }
    branches.push_back({{"of", branch.of},
                        {"mode", branch.name},
                        {"frequencies_rad_per_s", frequencies},
                        {"damping_ratios", damping}});
  }
  for (const CampbellCrossing& crossing : result.crossings)
    crossings.push_back({{"branch", crossing.branch + 1},
                         {"per_revolution", crossing.harmonic},
                         {"speed_rad_per_s", crossing.speed},
                         {"frequency_rad_per_s", crossing.frequency},
                         {"margin", crossing.margin ? Json(*crossing.margin) : Json()}});
  for (const CampbellGap& gap : result.gaps)
    gaps.push_back({{"speed_rad_per_s", speed_at(result, gap.speed)}, {"reason", gap.reason}});
  const Json json = {{"speeds_rad_per_s", speeds},
                     {"branches", branches},
                     {"crossings", crossings},
                     {"gaps", gaps}};
  return json.dump_lines();
}

std::string make_html(const CampbellResult& result, int harmonics, const std::string& title) {
  report::Page page(title, "Campbell diagram: frequencies in the frame that turns with the hub");
  page.widen();
  page.add_figure(render(make_diagram(result, harmonics)));
  if (is_damped(result))
    page.add_figure(render(make_chart(result, "Damping over speed", {.title = "damping ratio"},
                                      [](const Mode& mode) { return damping_of(mode); })));
  else
    page.add_paragraph("No mode is damped, and none grows.");
  page.add_table(make_crossing_table(result));
  if (!result.gaps.empty()) page.add_table(make_gap_table(result));
  page.add_table(make_branch_table(result));
  return page.html();
}

}  // namespace spoke::steady_report
