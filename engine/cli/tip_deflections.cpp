// Turns each tip's displacement to the direction of its blade, and describes the extremes.

#include "engine/cli/tip_deflections.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::cli {
namespace {

/// Numbers in increasing order, as "1-3, 5".
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
  const auto& blades = simulation.scenario().rotor.blades;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const std::string tip = "blade" + std::to_string(i + 1) + ".tip";
    blades_.push_back({simulation.sensor_index(tip + ".x"),
                       simulation.sensor_index(tip + ".y"),
                       std::cos(blades[i].azimuth),
                       std::sin(blades[i].azimuth),
                       {}});
  }
}

TipDeflections::TipDeflections(const Simulation& simulation,
                               const std::vector<TipExtreme>& extremes)
    : TipDeflections(simulation) {
  assert(extremes.size() == blades_.size());
  for (std::size_t i = 0; i < blades_.size(); ++i) blades_[i].extreme = extremes.at(i);
}

std::vector<TipExtreme> TipDeflections::extremes() const {
  std::vector<TipExtreme> all;
  for (const Blade& blade : blades_) all.push_back(blade.extreme);
  return all;
}

void TipDeflections::add(double t, std::span<const double> sensors) {
  for (Blade& blade : blades_) {
    const double across = -blade.sine * sensors[blade.x] + blade.cosine * sensors[blade.y];
    if (std::abs(across) > std::abs(blade.extreme.largest)) blade.extreme = {across, t};
  }
}

std::vector<std::string> TipDeflections::describe() const {
  struct Group {
    double size;
    std::string text;
    std::vector<std::size_t> blades;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < blades_.size(); ++i) {
    const TipExtreme& tip = blades_[i].extreme;
    std::string text = fmt::format("{:.6g} m at {:.6g} s", tip.largest, tip.time);
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.text == text; });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {std::abs(tip.largest), std::move(text), {}});
    }
    group->blades.push_back(i + 1);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.size > b.size; });
  std::vector<std::string> lines;
  for (const Group& group : groups) {
    lines.push_back(fmt::format("{} ({} {})", group.text,
                                group.blades.size() == 1 ? "blade" : "blades",
                                join_ranges(group.blades)));
  }
  return lines;
}

}  // namespace spoke::cli
