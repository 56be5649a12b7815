// Draws deflections of blades and of a support.

#include "program/steady_report/static_deflections.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "models/space/solid.h"
#include "program/report/chart.h"

namespace spoke::steady_report {
namespace {

using Eigen::Vector3d;

/// Number of lines that can be told apart.
constexpr std::size_t kMostLines = 6;

/// The component of a node's deflection that a line shows.
enum class Direction { lag, flap };

/// Whether a node of a blade is one of a beam or a rigid body, or the frame or a place of a solid;
/// others of a solid are in no row. `first`: that of its body.
bool is_in_row(const BladeEquilibrium& blade, std::size_t node, std::size_t first) {
  for (const SolidDeformation& solid : blade.solids)
    if (solid.body == blade.bodies[node]) return node - first <= solid.solid->places.size();
  return true;
}

/// Returns the nodes that lines show, from the root on.
std::vector<std::size_t> find_row(const BladeEquilibrium& blade) {
  std::vector<std::size_t> row;
  std::size_t first = 0;
  for (std::size_t k = 0; k < blade.nodes.size(); ++k) {
    if (blade.bodies[k] != blade.bodies[first]) first = k;
    if (is_in_row(blade, k, first)) row.push_back(k);
  }
  return row;
}

/// Plots the deflections of a blade's nodes along the axis of rotation, or in the plane across the
/// blade.
report::LineSeries deflection_line(const BladeEquilibrium& blade, Direction direction) {
  report::LineSeries line{.name = blade.name};
  const Vector3d along = (blade.undeformed.back() - blade.undeformed.front()).normalized();
  const Vector3d axis =
      direction == Direction::flap ? Vector3d::UnitZ() : Vector3d(Vector3d::UnitZ().cross(along));
  for (const std::size_t k : find_row(blade)) {
    const Vector3d& from = blade.undeformed[k];
    line.points.push_back({from.norm(), axis.dot(blade.nodes[k] - from)});
  }
  return line;
}

/// Whether nobody could tell two lines apart.
bool are_alike(const report::LineSeries& a, const report::LineSeries& b) {
  constexpr double kShare = 1e-5;
  double size = 0.0, distance = 0.0;
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    size = std::max({size, std::abs(a.points[k].y), std::abs(b.points[k].y)});
    distance = std::max(distance, std::abs(a.points[k].y - b.points[k].y));
  }
  return distance <= kShare * size;
}

void add_chart(const std::vector<const BladeEquilibrium*>& blades, Direction direction,
               const std::string& title, report::Page& page) {
  report::LineChart chart{.title = title,
                          .x = {.title = "distance from the hub", .unit = "m"},
                          .y = {.title = "deflection", .unit = "m"}};
  for (const BladeEquilibrium* blade : blades) {
    report::LineSeries line = deflection_line(*blade, direction);
    const auto same = std::find_if(chart.series.begin(), chart.series.end(),
                                   [&](const auto& other) { return are_alike(other, line); });
    if (same != chart.series.end())
      same->name += ", " + line.name;
    else if (chart.series.size() < kMostLines)
      chart.series.push_back(std::move(line));
  }
  if (chart.series.empty()) return;
  // A single line has no legend.
  page.add_figure(render(chart),
                  chart.series.size() == 1 ? "Of " + chart.series.front().name + "." : "");
}

/// Plots one component of the displacements of a support's nodes. Where a body does not begin at
/// the end of the one before, the line is parted.
report::LineSeries displacement_line(const BladeEquilibrium& support, const char* name, int axis) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  report::LineSeries line{.name = name};
  std::size_t last = 0;
  for (const std::size_t k : find_row(support)) {
    const Vector3d& from = support.undeformed[k];
    const bool is_other = support.bodies[k] != support.bodies[last];
    if (is_other && (from - support.undeformed[last]).norm() > 1e-6 * from.norm())
      line.points.push_back({kNan, kNan});
    line.points.push_back({from.norm(), support.nodes[k][axis] - from[axis]});
    last = k;
  }
  return line;
}

void add_support_chart(const BladeEquilibrium& support, report::Page& page) {
  report::LineChart chart{.title = "Displacement of the support",
                          .x = {.title = "distance from its base", .unit = "m"},
                          .y = {.title = "displacement", .unit = "m"}};
  for (const auto& [name, axis] : {std::pair{"along x", 0}, {"along y", 1}, {"along z", 2}})
    chart.series.push_back(displacement_line(support, name, axis));
  page.add_figure(render(chart), "In the axes of what the support stands on.");
}

}  // namespace

void add_deflection_charts(const EquilibriumResult& result, report::Page& page) {
  std::vector<const BladeEquilibrium*> blades;
  for (const BladeEquilibrium& blade : result.blades)
    if (blade.nodes.size() > 1) blades.push_back(&blade);
  const bool has_support = result.hub && !blades.empty() && blades.back() == &result.blades.back();
  if (has_support) blades.pop_back();
  add_chart(blades, Direction::flap, "Deflection along the axis of rotation", page);
  add_chart(blades, Direction::lag, "Deflection in the plane of rotation", page);
  if (has_support) add_support_chart(result.blades.back(), page);
}

}  // namespace spoke::steady_report
