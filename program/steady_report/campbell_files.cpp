// Makes the tables and files of a Campbell diagram.

#include "program/steady_report/campbell_files.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "engine/support/csv_cell.h"
#include "models/support/json.h"
#include "program/steady_report/mode_files.h"

namespace spoke::steady_report {
namespace {

using report::Align;

double speed_at(const CampbellResult& result, std::size_t k) {
  return result.states[k].equilibrium.speed;
}

/// Returns the mode of a branch at speed k; null if there is none.
const Mode* mode_at(const CampbellResult& result, const CampbellBranch& branch, std::size_t k) {
  return branch.modes[k] ? &result.states[k].modes[*branch.modes[k]] : nullptr;
}

std::string frequency_text(const Mode* mode) {
  return mode ? fmt::format("{:.6g}", hertz(mode->frequency)) : std::string();
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
                  {"mode"},
                  {fmt::format("at {:.5g} rad/s", speed_at(result, last)), Align::number}}};
  const auto name_text = [](const Mode* mode) { return mode ? mode->name : std::string(); };
  for (const CampbellBranch& branch : result.branches) {
    const Mode* first = mode_at(result, branch, 0);
    const Mode* end = mode_at(result, branch, last);
    table.rows.push_back({{branch.of, name_text(first), frequency_text(first), name_text(end),
                           frequency_text(end)}});
  }
  return table;
}

std::vector<std::string> describe_losses(const CampbellResult& result) {
  std::vector<std::string> lines;
  for (const CampbellLoss& loss : result.losses) {
    const CampbellBranch& branch = result.branches[loss.branch];
    lines.push_back(fmt::format(
        "{} of {} is not followed beyond {:.6g} rad/s: none of the {} lowest modes at {:.6g} rad/s "
        "goes on from it; a larger --count may have it",
        mode_at(result, branch, loss.last)->name, branch.of, speed_at(result, loss.last),
        result.states[loss.lost].modes.size(), speed_at(result, loss.lost)));
  }
  return lines;
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
        text += fmt::format("{},{},{},{},{},{},{},{}\n", speed_at(result, k), b + 1,
                            quoted_csv_cell(result.branches[b].of),
                            csv_cell(result.branches[b].name), hertz(mode->frequency),
                            mode->frequency, damping_of(*mode), mode->grows() ? 1 : 0);
  return text;
}

std::string make_json(const CampbellResult& result) {
  Json speeds = Json::array(), branches = Json::array(), crossings = Json::array(),
       gaps = Json::array(), losses = Json::array();
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
  for (const CampbellLoss& loss : result.losses)
    losses.push_back({{"branch", loss.branch + 1},
                      {"mode", mode_at(result, result.branches[loss.branch], loss.last)->name},
                      {"last_speed_rad_per_s", speed_at(result, loss.last)},
                      {"speed_rad_per_s", speed_at(result, loss.lost)}});
  const Json json = {{"frame", name_of(result.states[0].frame)},
                     {"speeds_rad_per_s", speeds},
                     {"branches", branches},
                     {"crossings", crossings},
                     {"gaps", gaps},
                     {"losses", losses}};
  return json.dump_lines();
}

}  // namespace spoke::steady_report
