// Columns and sentences of the commands' output.

#include "program/cli/report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

#include "engine/support/csv_cell.h"
#include "models/count_text.h"
#include "models/hints.h"
#include "program/cli/standard_streams.h"

namespace spoke::cli {
void print_line(std::string_view label, std::string_view text) {
  print(fmt::format("  {:<15} {}\n", label, text));
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
  std::string text = counted(size.subsystems, "subsystem") + ", " + counted(size.bodies, "body") +
                     ", " + counted(size.coordinates, "coordinate") + ", " +
                     counted(size.joints, "joint");
  if (size.loops > 0) text += ", " + counted(size.loops, "loop");
  if (size.couplings > 0) text += ", " + counted(size.couplings, "coupling");
  if (size.loops + size.couplings > 0) text += ", " + counted(size.freedoms, "freedom");
  print_line("model", text);
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

void warn_of_oddities(const std::string& file, const Scenario& scenario) {
  for (const std::string& hint : find_hints(scenario))
    print_error(one_line("warning: " + file + ": " + hint));
}

std::vector<std::string> column_heads(const Simulation& simulation) {
  std::vector<std::string> heads;
  for (const std::string& name : simulation.sensor_names()) heads.push_back(csv_cell(name));
  return heads;
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
