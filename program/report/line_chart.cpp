// Draws a line chart.

#include <algorithm>

#include "program/report/chart.h"
#include "program/report/chart_frame.h"
#include "program/report/markup.h"
#include "program/report/svg.h"

namespace spoke::report {
namespace {

constexpr double kPlotHeight = 340.0;
constexpr double kLeastGutter = 84.0;  // room left of the plot, for labels and title of the y axis
constexpr double kTitleSpace = 32.0;   // part of it for the title and the gap to the plot
constexpr double kRightSpace = 20.0;   // room for half a label of the x axis

struct Axes {
  Scale x, y;

  bool show(double at_x, double at_y) const { return x.shows(at_x) && y.shows(at_y); }
  Point2 position(double at_x, double at_y) const { return {x.position(at_x), y.position(at_y)}; }
};

std::vector<LegendEntry> legend_of(const LineChart& chart) {
  using Sample = LegendEntry::Sample;
  std::vector<LegendEntry> legend;
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const LineSeries& series = chart.series[s];
    legend.push_back({series.name, color_of(s), series.dashed ? Sample::dashed_line : Sample::line,
                      s, series.markers});
  }
  for (const ReferenceLine& line : chart.lines)
    legend.push_back({line.name, "", Sample::reference});
  return legend;
}

/// Adds a value if the axis can show it.
void add(Range& range, const Axis& axis, double value) {
  if (axis.kind == ScaleKind::linear || value > 0.0) range.add(value);
}

struct Ranges {
  Range x, y;
};

Ranges ranges_of(const LineChart& chart) {
  Ranges ranges;
  auto& [x, y] = ranges;
  for (const LineSeries& series : chart.series) {
    for (const DataPoint& point : series.points) {
      add(x, chart.x, point.x);
      add(y, chart.y, point.y);
    }
    for (const BandPoint& point : series.band) {
      add(x, chart.x, point.x);
      add(y, chart.y, point.low);
      add(y, chart.y, point.high);
    }
  }
  for (const ReferenceLine& line : chart.lines) add(y, chart.y, line.value);
  return ranges;
}

/// Lays out the plot, right of the longest label of the y axis; labels do not depend on places.
Box lay_out(const LineChart& chart, const Ranges& ranges) {
  const Scale scale(chart.y, ranges.y, 0.0, 1.0);
  double gutter = kLeastGutter;
  for (const Tick& tick : scale.ticks())
    gutter = std::max(gutter, width_of(tick.label) + kTitleSpace);
  return {gutter, head_height(chart.title, legend_of(chart)), kChartWidth - gutter - kRightSpace,
          kPlotHeight};
}

Axes axes_of(const LineChart& chart, const Ranges& ranges, const Box& plot) {
  return {Scale(chart.x, ranges.x, plot.x, plot.x + plot.width, 10),
          Scale(chart.y, ranges.y, plot.y + plot.height, plot.y)};
}

/// Returns the line's path, a stroke of its own for each unbroken run of points.
std::string line_path(const LineSeries& series, const Axes& axes) {
  std::string commands;
  bool joined = false;
  for (const DataPoint& point : series.points) {
    const bool shown = axes.show(point.x, point.y);
    if (shown) commands += command(joined ? 'L' : 'M', axes.position(point.x, point.y));
    joined = shown;
  }
  return commands;
}

/// Returns the band's outline: its upper edge forth, its lower one back.
std::string band_path(const LineSeries& series, const Axes& axes) {
  std::vector<BandPoint> band;
  for (const BandPoint& point : series.band)
    if (axes.show(point.x, point.low) && axes.show(point.x, point.high)) band.push_back(point);
  std::string commands;
  for (const BandPoint& point : band)
    commands += command(commands.empty() ? 'M' : 'L', axes.position(point.x, point.high));
  for (auto point = band.rbegin(); point != band.rend(); ++point)
    commands += command('L', axes.position(point->x, point->low));
  return commands.empty() ? commands : commands + 'Z';
}

std::string tooltip_of(const LineChart& chart, const LineSeries& series, const DataPoint& point) {
  std::string text = series.name + ": " + chart.x.title + ' ' + figure(point.x, 4);
  if (!chart.x.unit.empty()) text += ' ' + chart.x.unit;
  text += ", " + chart.y.title + ' ' + figure(point.y, 4);
  if (!chart.y.unit.empty()) text += ' ' + chart.y.unit;
  return point.tooltip.empty() ? text : text + '\n' + point.tooltip;
}

void draw_series(Svg& svg, const LineChart& chart, std::size_t s, const Axes& axes) {
  const LineSeries& series = chart.series[s];
  svg.begin_group(color_of(s), series.name);
  const std::string line = line_path(series, axes);
  if (!line.empty()) svg.path(line, series.dashed ? "line dashed" : "line");
  if (series.markers)
    for (const DataPoint& point : series.points) {
      if (!axes.show(point.x, point.y)) continue;
      svg.begin_group("", tooltip_of(chart, series, point));
      svg.path(marker(axes.position(point.x, point.y), s), "point");
      svg.end_group();
    }
  svg.end_group();
}

void draw_bands(Svg& svg, const LineChart& chart, const Axes& axes) {
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const std::string band = band_path(chart.series[s], axes);
    if (band.empty()) continue;
    svg.begin_group(color_of(s));
    svg.path(band, "band");
    svg.end_group();
  }
}

void draw_lines(Svg& svg, const LineChart& chart, const Axes& axes, const Box& plot) {
  for (const ReferenceLine& line : chart.lines) {
    if (!axes.y.shows(line.value)) continue;
    const double y = axes.y.position(line.value);
    svg.begin_group("", line.name + ": " + figure(line.value, 4));
    svg.line({plot.x, y}, {plot.x + plot.width, y}, "reference");
    svg.end_group();
  }
}

bool has_data(const LineChart& chart, const Axes& axes) {
  return std::any_of(chart.series.begin(), chart.series.end(), [&](const LineSeries& series) {
    return !line_path(series, axes).empty() || !band_path(series, axes).empty();
  });
}

}  // namespace

std::string render(const LineChart& chart) {
  const std::vector<LegendEntry> legend = legend_of(chart);
  const Ranges ranges = ranges_of(chart);
  const Box plot = lay_out(chart, ranges);
  const Axes axes = axes_of(chart, ranges, plot);
  Svg svg(kChartWidth, plot.y + plot.height + 46.0, chart.title);
  draw_head(svg, chart.title, legend);
  draw_x_axis(svg, axes.x, chart.x, plot);
  draw_y_axis(svg, axes.y, chart.y, plot);
  svg.line({plot.x, plot.y + plot.height}, {plot.x + plot.width, plot.y + plot.height}, "base");
  draw_bands(svg, chart, axes);
  draw_lines(svg, chart, axes, plot);
  for (std::size_t s = 0; s < chart.series.size(); ++s) draw_series(svg, chart, s, axes);
  if (!has_data(chart, axes)) draw_no_data(svg, plot);
  return svg.markup();
}

}  // namespace spoke::report
