// Reduces solids, and prints their modes.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/reduce.h"
#include "models/count_text.h"
#include "program/cli/commands.h"
#include "program/cli/prepare_solids.h"
#include "program/cli/report.h"

namespace spoke::cli {
namespace {

std::string describe_mesh(const SolidReduction& solid) {
  std::string text;
  if (!solid.file.empty()) text += std::filesystem::path(solid.file).filename().string() + ", ";
  text += counted(std::ssize(solid.nodes), "node");
  if (solid.elements > 0)
    text += ", " + counted(static_cast<std::int64_t>(solid.elements), "element");
  return text + fmt::format(", {:.6g} kg", solid.mass);
}

std::string describe_interface(const SolidReductionInterface& interface, double size) {
  const auto number = [&](double value) { return std::abs(value) <= 1e-12 * size ? 0.0 : value; };
  const Eigen::Vector3d& p = interface.point;
  std::string text = fmt::format("{}: {}, {} at [{:.6g}, {:.6g}, {:.6g}] m", interface.name,
                                 name_of(interface.kind),
                                 counted(static_cast<std::int64_t>(interface.nodes), "node"),
                                 number(p.x()), number(p.y()), number(p.z()));
  if (interface.area > 0.0) text += fmt::format(", {:.6g} m^2", interface.area);
  return text;
}

std::string describe_coordinates(const SolidReduction& solid) {
  if (solid.kind == spatial::SolidCoordinates::nodal)
    return counted(solid.coordinates, "displacement") + " of nodes, not reduced";
  const auto vibrations = std::ssize(solid.vibration_frequencies);
  return fmt::format("{}, from {} and {}", counted(solid.coordinates, "mode"),
                     counted(vibrations, "vibration mode"),
                     counted(solid.coordinates - vibrations, "static shape"));
}

/// Tells how long it took, and where it is kept.
std::string describe_making(const SolidReduction& solid) {
  if (solid.was_cached) return fmt::format("in {:.3g} s from {}", solid.seconds, solid.cache_file);
  const std::string kept =
      solid.cache_file.empty() ? "there is no cache" : "kept in " + solid.cache_file;
  return fmt::format("in {:.3g} s; {}", solid.seconds, kept);
}

/// Makes a row a mode; the vibration modes that these were made of stand beside them.
report::Table make_solid_mode_table(const SolidReduction& solid) {
  using report::Align;
  report::Table table{.caption = "Modes of " + solid.subsystem + " / " + solid.body,
                      .columns = {{"mode", Align::number},
                                  {"frequency [Hz]", Align::number},
                                  {"damping ratio", Align::number},
                                  {"vibration mode [Hz]", Align::number}}};
  const std::vector<double>& vibrations = solid.vibration_frequencies;
  for (std::size_t k = 0; k < std::max(solid.frequencies.size(), vibrations.size()); ++k) {
    report::Row row{{std::to_string(k + 1), "", "", ""}};
    if (k < solid.frequencies.size()) {
      row.cells[1] = fmt::format("{:.6g}", solid.frequencies[k]);
      row.cells[2] = fmt::format("{:.4g}", solid.damping_ratios[k]);
    }
    if (k < vibrations.size()) row.cells[3] = fmt::format("{:.6g}", vibrations[k]);
    table.rows.push_back(row);
  }
  return table;
}

void print_solid(const SolidReduction& solid) {
  print_line(solid.subsystem, solid.body + ": " + describe_mesh(solid));
  double size = 0.0;
  for (const SolidReductionInterface& interface : solid.interfaces)
    size = std::max(size, interface.point.norm());
  for (std::size_t i = 0; i < solid.interfaces.size(); ++i)
    print_line(i == 0 ? "interfaces" : "", describe_interface(solid.interfaces[i], size));
  print_line("coordinates", describe_coordinates(solid));
  print_line("made", describe_making(solid));
  print_line("memory", fmt::format("about {:.3g} MB", 1e-6 * solid.memory_bytes));
  if (!solid.frequencies.empty()) print_table(make_solid_mode_table(solid));
}

std::vector<SolidReduction> reduce_all(const Scenario& scenario, bool anew) {
  SolidProgress progress;
  ReduceOptions options;
  options.progress = [&](const std::string& step, double done) { progress.show(step, done); };
  options.anew = anew;
  return reduce(scenario, options);
}

}  // namespace

int reduce_solids(const Arguments& arguments) {
  const Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  warn_of_oddities(arguments.scenario, scenario);
  const std::vector<SolidReduction> solids = reduce_all(scenario, arguments.anew);
  print_title(scenario.title);
  if (solids.empty()) print_line("solids", "none: no body is of kind \"solid\"");
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const SolidReduction& first = solids[solids[k].same_as];
    if (solids[k].same_as == k)
      print_solid(solids[k]);
    else
      print_line(solids[k].subsystem,
                 solids[k].body + ": as " + first.subsystem + " / " + first.body);
  }
  return 0;
}

}  // namespace spoke::cli
