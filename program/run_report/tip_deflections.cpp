// Computes each tip's displacement as one number, and the extremes in words.

#include "program/run_report/tip_deflections.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::run_report {
namespace {

/// Joins numbers in increasing order to a text such as "1-3, 5".
std::string join_ranges(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text += std::to_string(numbers[i]);
    if (last > i) text += '-' + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace

TipDeflections::TipDeflections(const Simulation& simulation) {
  const Scenario& scenario = simulation.scenario();
  const std::vector<Blade>& blades = scenario.rotor.blades;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const std::string tip = "blade" + std::to_string(i + 1) + ".tip";
    tips_.push_back({"",
                     {simulation.sensor_index(tip + ".x"), simulation.sensor_index(tip + ".y"), 0},
                     blades[i].azimuth});
  }
  if (!scenario.space) return;
  for (std::size_t i = 0; i < scenario.space->blades.size(); ++i)
    add_spatial_tip(simulation, "blade" + std::to_string(i + 1), "");
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    add_spatial_tip(simulation, subsystem.name, subsystem.name);
}

void TipDeflections::add_spatial_tip(const Simulation& simulation, const std::string& tree,
                                     const std::string& name) {
  std::string sensor = tree;
  std::erase(sensor, ' ');
  sensor += ".tip.";
  tips_.push_back({name,
                   {simulation.sensor_index(sensor + "x"), simulation.sensor_index(sensor + "y"),
                    simulation.sensor_index(sensor + "z")}});
}

TipDeflections::TipDeflections(const Simulation& simulation,
                               const std::vector<TipExtreme>& extremes)
    : TipDeflections(simulation) {
  assert(extremes.size() == tips_.size());
  for (std::size_t i = 0; i < tips_.size(); ++i) tips_[i].extreme = extremes.at(i);
}

std::vector<TipExtreme> TipDeflections::extremes() const {
  std::vector<TipExtreme> all;
  for (const Tip& tip : tips_) all.push_back(tip.extreme);
  return all;
}

double TipDeflections::Tip::deflection(std::span<const double> sensors) const {
  const double x = sensors[components[0]], y = sensors[components[1]];
  if (azimuth) return -std::sin(*azimuth) * x + std::cos(*azimuth) * y;
  return std::hypot(x, y, sensors[components[2]]);
}

void TipDeflections::add(double t, std::span<const double> sensors) {
  for (Tip& tip : tips_) {
    const double deflection = tip.deflection(sensors);
    if (std::abs(deflection) > std::abs(tip.extreme.largest)) tip.extreme = {deflection, t};
  }
}

std::vector<std::string> TipDeflections::describe() const {
  struct Group {
    double size;
    std::string text;
    std::string subsystem;  // name of the subsystem; empty: blades
    std::vector<std::size_t> blades;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < tips_.size(); ++i) {
    const TipExtreme& tip = tips_[i].extreme;
    std::string text = fmt::format("{:.6g} m at {:.6g} s", tip.largest, tip.time);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return g.text == text && g.subsystem.empty() && tips_[i].name.empty();
    });
    if (group == groups.end())
      group =
          groups.insert(groups.end(), {std::abs(tip.largest), std::move(text), tips_[i].name, {}});
    group->blades.push_back(i + 1);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.size > b.size; });
  std::vector<std::string> lines;
  for (const Group& group : groups) {
    const char* blades = group.blades.size() == 1 ? "blade " : "blades ";
    lines.push_back(fmt::format(
        "{} ({})", group.text,
        group.subsystem.empty() ? blades + join_ranges(group.blades) : group.subsystem));
  }
  return lines;
}

TipSummary TipDeflections::summarise() const {
  if (tips_.empty()) return {};
  const auto largest = std::max_element(tips_.begin(), tips_.end(), [](const Tip& a, const Tip& b) {
    return std::abs(a.extreme.largest) < std::abs(b.extreme.largest);
  });
  const std::string line = describe().front();
  return {largest->extreme.largest, line.substr(line.find(" at ") + 1)};
}

std::size_t count_tips(const Scenario& scenario) {
  if (!scenario.space) return scenario.rotor.blades.size();
  return scenario.space->blades.size() + scenario.space->subsystems.size();
}

}  // namespace spoke::run_report
