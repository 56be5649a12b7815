// Columns and sentences of what commands print.

#include "engine/cli/report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/cli/standard_streams.h"
#include "models/count_text.h"

namespace spoke::cli {
void print_line(std::string_view label, std::string_view text) {
  print(fmt::format("  {:<16}{}\n", label, text));
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return text;
}

void print_title(const std::string& title) { print(one_line(title) + '\n'); }

void print_model(const Simulation& simulation) {
  const ModelSize size = simulation.size();
  print_title(simulation.scenario().title);
  print_line("model", counted(size.subsystems, "subsystem") + ", " + counted(size.bodies, "body") +
                          ", " + counted(size.coordinates, "coordinate") + ", " +
                          counted(size.joints, "joint"));
  print_line("step graph",
             counted(size.graph_nodes, "node") + ", " + counted(size.graph_edges, "edge"));
}

void print_plan(const Simulation& simulation, int processes) {
  print_model(simulation);
  std::string text =
      fmt::format("{}, {}, {} of {:.6g} s, {} on {} {}", name_of(simulation.options().formulation),
                  name_of(simulation.scenario().integration.method),
                  counted(simulation.planned_steps(), "step"), simulation.step_size(),
                  name_of(simulation.options().executor), name_of(simulation.threads()),
                  simulation.threads().total() == 1 ? "thread" : "threads");
  if (processes > 1) text += fmt::format(" of each of {} processes", processes);
  print_line("solved by", text);
  flush_output();
}

namespace {

/// Of blades in the plane or in space.
template <class Blade>
void warn_of_blades_in_degrees(const std::string& file, const std::vector<Blade>& blades) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const double azimuth = blades[i].azimuth;
    // Unless given, it is that of the first blade and a share of a turn.
    const double share = turn * static_cast<double>(i) / static_cast<double>(blades.size());
    if (std::abs(azimuth) <= turn || std::abs(azimuth - share) <= turn) continue;
    return print_error(fmt::format(
        "warning: {}: the azimuth of blade {} is {:.6g} rad, beyond a turn of 2 pi: degrees?",
        one_line(file), i + 1, azimuth));
  }
}

}  // namespace

void warn_of_degrees(const std::string& file, const Scenario& scenario) {
  if (scenario.space)
    warn_of_blades_in_degrees(file, scenario.space->blades);
  else
    warn_of_blades_in_degrees(file, scenario.rotor.blades);
}

void print_table(const report::Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    widths.push_back(table.columns[c].title.size());
    for (const report::Row& row : table.rows) widths[c] = std::max(widths[c], row.cells[c].size());
  }
  const auto print_row = [&](const auto& text_of) {
    std::string line;
    for (std::size_t c = 0; c < widths.size(); ++c)
      line += table.columns[c].align == report::Align::number
                  ? fmt::format("  {:>{}}", text_of(c), widths[c])
                  : fmt::format("  {:<{}}", text_of(c), widths[c]);
    print(line.substr(0, line.find_last_not_of(' ') + 1) + '\n');
  };
  print('\n' + table.caption + '\n');
  print_row([&](std::size_t c) { return table.columns[c].title; });
  for (const report::Row& row : table.rows) print_row([&](std::size_t c) { return row.cells[c]; });
}

}  // namespace spoke::cli
