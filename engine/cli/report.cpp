#include "engine/cli/report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace spoke::cli {
namespace {

std::string count(int number, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", number, number == 1 ? singular : plural);
}

}  // namespace

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
  print_line("model", count(size.subsystems, "subsystem", "subsystems") + ", " +
                          count(size.bodies, "body", "bodies") + ", " +
                          count(size.coordinates, "coordinate", "coordinates") + ", " +
                          count(size.joints, "joint", "joints"));
  print_line("step graph", count(size.graph_nodes, "node", "nodes") + ", " +
                               count(size.graph_edges, "edge", "edges"));
}

}  // namespace spoke::cli
