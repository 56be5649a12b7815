// Makes the table, the files and the curves of operating points.

#include "program/steady_report/performance_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/support/csv_cell.h"
#include "engine/support/plain_zero.h"
#include "models/support/json.h"
#include "program/report/chart.h"

namespace spoke::steady_report {
namespace {

using report::Align;

/// A quantity of a point, as charts show it.
struct Curve {
  const char* title;
  const char* unit;
  double PerformancePoint::*value;
  double scale = 1.0;
};

constexpr double kDegree = 0.017453292519943295;

/// Returns a text of ASCII with its first letter in upper case.
std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string with_unit(const Curve& curve) {
  return *curve.unit ? fmt::format("{} [{}]", curve.title, curve.unit) : curve.title;
}

/// Returns the points as series: one, or of a map one for each pitch.
std::vector<report::LineSeries> make_series(const PerformanceResult& result, const Curve& curve) {
  std::map<double, report::LineSeries> by_pitch;
  for (const PerformancePoint& point : result.points) {
    const double key = result.is_map ? point.pitch : 0.0;
    report::LineSeries& series = by_pitch[key];
    series.name = result.is_map ? fmt::format("pitch {:.4g} deg", point.pitch / kDegree)
                                : std::string(curve.title);
    const double value = point.gap.empty() ? point.*curve.value / curve.scale
                                           : std::numeric_limits<double>::quiet_NaN();
    series.points.push_back({result.is_map ? point.tip_speed_ratio : point.wind, value, point.gap});
  }
  std::vector<report::LineSeries> list;
  for (auto& [pitch, series] : by_pitch) list.push_back(std::move(series));
  return list;
}

std::string draw(const PerformanceResult& result, const Curve& curve) {
  report::LineChart chart;
  chart.title = capitalised(curve.title);
  chart.x.title = result.is_map ? "tip-speed ratio" : "wind at the hub [m/s]";
  chart.y.title = with_unit(curve);
  chart.series = make_series(result, curve);
  return render(chart);
}

std::vector<Curve> choose_curves(const PerformanceResult& result) {
  std::vector<Curve> curves;
  if (!result.is_map) {
    curves = {{"power", "kW", &PerformancePoint::power, 1e3},
              {"thrust", "kN", &PerformancePoint::thrust, 1e3},
              {"speed", "rad/s", &PerformancePoint::speed},
              {"pitch", "deg", &PerformancePoint::pitch, kDegree}};
  }
  curves.push_back({"power coefficient", "", &PerformancePoint::power_coefficient});
  curves.push_back({"thrust coefficient", "", &PerformancePoint::thrust_coefficient});
  if (!result.is_rigid)
    curves.push_back({"tip displacement along the axis", "m", &PerformancePoint::tip_displacement});
  return curves;
}

/// Returns the point of the greatest power coefficient; null if there is no state.
const PerformancePoint* find_best(const PerformanceResult& result) {
  const PerformancePoint* best = nullptr;
  for (const PerformancePoint& point : result.points)
    if (point.gap.empty() && (!best || point.power_coefficient > best->power_coefficient))
      best = &point;
  return best;
}

}  // namespace

report::Table make_performance_table(const PerformanceResult& result) {
  report::Table table{.caption = "Operating points",
                      .columns = {{"wind m/s", Align::number},
                                  {"speed rad/s", Align::number},
                                  {"tip-speed ratio", Align::number},
                                  {"pitch deg", Align::number},
                                  {"power kW", Align::number},
                                  {"thrust kN", Align::number},
                                  {"C_P", Align::number},
                                  {"C_T", Align::number},
                                  {"tip m", Align::number}}};
  for (const PerformancePoint& p : result.points) {
    const auto number = [&](double value) {
      return p.gap.empty() ? fmt::format("{:.6g}", plain_zero(value)) : std::string();
    };
    table.rows.push_back(
        {{fmt::format("{:.6g}", p.wind), number(p.speed), number(p.tip_speed_ratio),
          number(p.pitch / kDegree), number(p.power / 1e3), number(p.thrust / 1e3),
          number(p.power_coefficient), number(p.thrust_coefficient),
          p.gap.empty() ? number(p.tip_displacement) : p.gap},
         p.gap.empty() ? report::Tone::plain : report::Tone::muted});
  }
  return table;
}

std::string make_csv(const PerformanceResult& result) {
  std::string text =
      "wind_m_per_s,speed_rad_per_s,tip_speed_ratio,pitch_rad,power_W,thrust_N,torque_N_m,"
      "power_coefficient,thrust_coefficient,tip_displacement_m,gap\n";
  for (const PerformancePoint& p : result.points) {
    text += fmt::format("{},{},{},{}", p.wind, plain_zero(p.speed), p.tip_speed_ratio,
                        plain_zero(p.pitch));
    for (const double value : {p.power, p.thrust, p.torque, p.power_coefficient,
                               p.thrust_coefficient, p.tip_displacement})
      text += p.gap.empty() ? fmt::format(",{}", plain_zero(value)) : std::string(",");
    text += ',' + csv_cell(p.gap) + '\n';
  }
  return text;
}

std::string make_coefficient_tables(const PerformanceResult& result, int sign) {
  const std::vector<PerformancePoint>& points = result.points;
  const auto has_gap = [](const PerformancePoint& p) { return !p.gap.empty(); };
  if (!result.is_map || points.empty() || std::any_of(points.begin(), points.end(), has_gap))
    return {};
  std::size_t columns = 1;  // pitch angles
  while (columns < points.size() &&
         points[columns].tip_speed_ratio == points.front().tip_speed_ratio)
    ++columns;
  // Columns ascend towards feather.
  const auto place = [&](std::size_t row, std::size_t column) {
    return row * columns + (sign > 0 ? column : columns - 1 - column);
  };
  const std::size_t rows = points.size() / columns;
  // ROSCO skips lines by their number, and its toolbox finds them by their words.
  std::string text = "# Tables of a rotor's coefficients\n# Written by Spoke\n\n";
  const auto add_head = [&](const char* what, std::size_t count, const char* axis) {
    text += fmt::format("# {} vector, {} entries - {}\n", what, count, axis);
  };
  add_head("Pitch angle", columns, "x axis (matrix columns) (deg)");
  for (std::size_t k = 0; k < columns; ++k)
    text += fmt::format(" {:.10g}",
                        plain_zero(sign * points[place(0, k)].pitch * 180.0 / std::numbers::pi));
  text += '\n';
  add_head("TSR", rows, "y axis (matrix rows) (-)");
  for (std::size_t k = 0; k < points.size(); k += columns)
    text += fmt::format(" {:.10g}", points[k].tip_speed_ratio);
  text += fmt::format("\n# Wind speed vector - z axis (m/s)\n {:.10g}\n", points.front().wind);
  const auto add_table = [&](const char* title, const auto& coefficient) {
    text += fmt::format("\n# {} coefficient\n\n", title);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column)
        text += fmt::format(" {:13.6e}", plain_zero(coefficient(points[place(row, column)])));
      text += '\n';
    }
  };
  add_table("Power", [](const PerformancePoint& p) { return p.power_coefficient; });
  text += '\n';
  add_table("Thrust", [](const PerformancePoint& p) { return p.thrust_coefficient; });
  text += '\n';
  add_table("Torque",
            [](const PerformancePoint& p) { return p.power_coefficient / p.tip_speed_ratio; });
  return text;
}

std::string make_json(const PerformanceResult& result, const Scenario& scenario) {
  Json points = Json::array();
  for (const PerformancePoint& p : result.points) {
    Json point = {{"wind_m_per_s", p.wind},
                  {"speed_rad_per_s", plain_zero(p.speed)},
                  {"tip_speed_ratio", p.tip_speed_ratio},
                  {"pitch_rad", plain_zero(p.pitch)}};
    if (!p.gap.empty()) {
      point.set("gap", p.gap);
    } else {
      point.set("power_W", p.power);
      point.set("thrust_N", p.thrust);
      point.set("torque_N_m", p.torque);
      point.set("power_coefficient", p.power_coefficient);
      point.set("thrust_coefficient", p.thrust_coefficient);
      point.set("tip_displacement_m", p.tip_displacement);
    }
    points.push_back(std::move(point));
  }
  Json json = {{"version", SPOKE_VERSION},
               {"scenario", scenario.name},
               {"title", scenario.title},
               {"blades", result.is_rigid ? "rigid" : "elastic"},
               {"over", result.is_map ? "tip_speed_ratio" : "wind"},
               {"radius_m", result.radius},
               {"density_kg_per_m3", result.density},
               {"points", points}};
  if (!result.rotor.empty()) json.set("rotor", result.rotor);
  return json.dump_lines();
}

std::string make_html(const PerformanceResult& result, const std::string& title) {
  report::Page page(title, result.is_map ? "Performance over tip-speed ratio and pitch"
                                         : "Performance over wind speed");
  page.widen();
  std::vector<report::Tile> tiles;
  if (const PerformancePoint* best = find_best(result))
    tiles.push_back({"Greatest power coefficient", fmt::format("{:.4f}", best->power_coefficient),
                     fmt::format("at tip-speed ratio {:.4g}, pitch {:.3g} deg",
                                 best->tip_speed_ratio, plain_zero(best->pitch / kDegree))});
  tiles.push_back({"Radius", fmt::format("{:.6g} m", result.radius),
                   result.is_rigid ? "rigid blades" : "elastic blades"});
  tiles.push_back({"Density of the air", fmt::format("{:.6g} kg/m\u00b3", result.density),
                   "wind along the axis"});
  page.add_tiles(tiles);
  page.add_markup("<div class=\"side\">\n");
  for (const Curve& curve : choose_curves(result)) page.add_figure(draw(result, curve));
  page.add_markup("</div>\n");
  page.add_table(make_performance_table(result));
  return page.html();
}

}  // namespace spoke::steady_report
