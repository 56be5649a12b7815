// Writes and draws what air does to sections of blades.

#include "program/steady_report/static_air.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <numbers>
#include <utility>

#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "program/report/chart.h"

namespace spoke::steady_report {
namespace {

/// A value of a section, its name in files with its unit, and in charts.
struct Quantity {
  const char* key;
  const char* title;
  double SectionAir::*value;
};

constexpr Quantity kQuantities[] = {
    {"angle_of_attack_rad", "angle of attack", &SectionAir::attack},
    {"relative_speed_m_per_s", "relative speed", &SectionAir::relative_speed},
    {"axial_induction", "axial induction", &SectionAir::axial_induction},
    {"tangential_induction", "tangential induction", &SectionAir::tangential_induction},
    {"lift_coefficient", "lift", &SectionAir::lift},
    {"drag_coefficient", "drag", &SectionAir::drag},
    {"moment_coefficient", "moment", &SectionAir::moment},
    {"axial_force_N_per_m", "along the axis", &SectionAir::axial_force},
    {"tangential_force_N_per_m", "in the direction of the turn", &SectionAir::tangential_force},
    {"pitching_moment_N", "pitching moment", &SectionAir::pitching_moment}};

/// Quantities that share a chart: from `first` on, before `last`, times `factor`.
struct Group {
  std::size_t first, last;
  double factor = 1.0;
};

/// Draws some of the quantities of a blade over its stations.
void add_chart(const BladeEquilibrium& blade, const char* title, report::Axis value, Group group,
               report::Page& page) {
  report::LineChart chart{
      .title = title, .x = {.title = "distance from the root", .unit = "m"}, .y = std::move(value)};
  for (std::size_t k = group.first; k < group.last; ++k) {
    report::LineSeries line{.name = kQuantities[k].title};
    for (const SectionAir& section : blade.air)
      line.points.push_back({section.station, group.factor * section.*kQuantities[k].value});
    chart.series.push_back(std::move(line));
  }
  page.add_figure(render(chart), "Of " + blade.name + ".");
}

}  // namespace

std::vector<report::Fact> make_air_facts(const EquilibriumResult& result) {
  assert(result.air);
  const RotorAir& air = *result.air;
  return {{"wind", fmt::format("{:.6g} m/s along the axis", plain_zero(air.wind))},
          {"thrust of air", fmt::format("{:.6g} N", plain_zero(air.thrust))},
          {"torque of air", fmt::format("{:.6g} N m", plain_zero(air.torque))},
          {"power of air", fmt::format("{:.6g} W", plain_zero(air.torque * result.speed))}};
}

bool has_air(const EquilibriumResult& result) {
  return std::any_of(result.blades.begin(), result.blades.end(),
                     [](const BladeEquilibrium& blade) { return !blade.air.empty(); });
}

Json air_json(const RotorAir& air, double speed) {
  return {{"wind_m_per_s", plain_zero(air.wind)},
          {"thrust_N", plain_zero(air.thrust)},
          {"torque_N_m", plain_zero(air.torque)},
          {"power_W", plain_zero(air.torque * speed)}};
}

Json section_air_json(const BladeEquilibrium& blade) {
  Json list = Json::array();
  for (const SectionAir& section : blade.air) {
    Json json = {{"station_m", section.station}};
    for (const Quantity& quantity : kQuantities)
      json.set(quantity.key, plain_zero(section.*quantity.value));
    list.push_back(std::move(json));
  }
  return list;
}

std::string make_air_csv(const EquilibriumResult& result) {
  std::string text = "blade,station_m";
  for (const Quantity& quantity : kQuantities) text += std::string(",") + quantity.key;
  text += '\n';
  for (const BladeEquilibrium& blade : result.blades)
    for (const SectionAir& section : blade.air) {
      text += fmt::format("{},{}", csv_cell(blade.name), plain_zero(section.station));
      for (const Quantity& quantity : kQuantities)
        text += fmt::format(",{}", plain_zero(section.*quantity.value));
      text += '\n';
    }
  return text;
}

void add_air_charts(const EquilibriumResult& result, report::Page& page) {
  for (const BladeEquilibrium& blade : result.blades) {
    if (blade.air.empty()) continue;
    add_chart(blade, "Angle of attack", {.title = "angle of attack", .unit = "deg"},
              {0, 1, 180.0 / std::numbers::pi}, page);
    add_chart(blade, "Relative speed", {.title = "relative speed", .unit = "m/s"}, {1, 2}, page);
    add_chart(blade, "Induction factors", {.title = "induction factor"}, {2, 4}, page);
    add_chart(blade, "Coefficients of lift, drag and moment", {.title = "coefficient"}, {4, 7},
              page);
    add_chart(blade, "Forces by length", {.title = "force by length", .unit = "N/m"}, {7, 9}, page);
    return;
  }
}

}  // namespace spoke::steady_report
