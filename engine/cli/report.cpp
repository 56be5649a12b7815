// Columns and sentences of what commands print.

#include "engine/cli/report.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "models/count_text.h"

namespace spoke::cli {
void print_line(std::string_view label, std::string_view text) {
  fmt::print("  {:<16}{}\n", label, text);
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return text;
}

void print_model(const Simulation& simulation) {
  const ModelSize size = simulation.size();
  fmt::print("{}\n", one_line(simulation.scenario().title));
  print_line("model", counted(size.subsystems, "subsystem") + ", " + counted(size.bodies, "body") +
                          ", " + counted(size.coordinates, "coordinate") + ", " +
                          counted(size.joints, "joint"));
  print_line("step graph",
             counted(size.graph_nodes, "node") + ", " + counted(size.graph_edges, "edge"));
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
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  fmt::print("\n{}\n", table.caption);
  print_row([&](std::size_t c) { return table.columns[c].title; });
  for (const report::Row& row : table.rows) print_row([&](std::size_t c) { return row.cells[c]; });
}

}  // namespace spoke::cli
