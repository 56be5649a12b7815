// Draws a bar chart.

#include <algorithm>
#include <cmath>

#include "program/report/chart.h"
#include "program/report/chart_frame.h"
#include "program/report/markup.h"
#include "program/report/svg.h"

namespace spoke::report {
namespace {

constexpr double kBarHeight = 15.0;
constexpr double kGroupGap = 11.0;
constexpr std::size_t kLongestGroup = 40;  // characters

/// The places of all parts of a chart.
struct Layout {
  Box plot;
  double group_height = 0.0;
};

std::vector<LegendEntry> legend_of(const BarChart& chart) {
  std::vector<LegendEntry> legend;
  for (std::size_t s = 0; s < chart.series.size(); ++s)
    legend.push_back({chart.series[s].name, color_of(s)});
  for (const BarMarks& marks : chart.marks)
    legend.push_back({marks.name, "", LegendEntry::Sample::mark});
  for (const ReferenceLine& line : chart.lines)
    legend.push_back({line.name, "", LegendEntry::Sample::reference});
  return legend;
}

Range range_of(const BarChart& chart) {
  Range range;
  if (chart.value.kind == ScaleKind::linear) range.add(0.0);
  const auto add = [&](double value) {
    if (chart.value.kind == ScaleKind::linear || value > 0.0) range.add(value);
  };
  for (const BarSeries& series : chart.series)
    for (const auto& bar : series.bars) {
      if (!bar) continue;
      for (const double value :
           {bar->value, bar->low.value_or(bar->value), bar->high.value_or(bar->value)})
        add(value);
    }
  for (const BarMarks& marks : chart.marks)
    for (const auto& value : marks.values)
      if (value) add(*value);
  for (const ReferenceLine& line : chart.lines) add(line.value);
  return range;
}

/// Returns the bar to draw, if there is one.
const Bar* bar_of(const BarSeries& series, std::size_t group, const Scale& scale) {
  if (group >= series.bars.size() || !series.bars[group]) return nullptr;
  return scale.shows(series.bars[group]->value) ? &*series.bars[group] : nullptr;
}

bool has_data(const BarChart& chart, const Scale& scale) {
  for (const BarSeries& series : chart.series)
    for (std::size_t g = 0; g < chart.groups.size(); ++g)
      if (bar_of(series, g, scale) != nullptr) return true;
  return false;
}

std::string text_of(const Bar& bar) { return bar.text.empty() ? figure(bar.value) : bar.text; }

/// Returns where bars begin.
double base_of(const Scale& scale) { return scale.position(std::max(scale.low(), 0.0)); }

Layout lay_out(const BarChart& chart) {
  double gutter = 40.0;
  for (const std::string& group : chart.groups)
    gutter = std::max(gutter, width_of(shortened(group, kLongestGroup)) + 14.0);
  double values = 30.0;  // width of the column of numbers right of the plot
  for (const BarSeries& series : chart.series)
    for (const auto& bar : series.bars)
      if (bar) values = std::max(values, width_of(text_of(*bar)) + 14.0);
  const double bars = static_cast<double>(std::max<std::size_t>(1, chart.series.size()));
  Layout layout;
  layout.group_height = bars * kBarHeight + kGroupGap;
  const double groups = static_cast<double>(std::max<std::size_t>(2, chart.groups.size()));
  layout.plot = {gutter, head_height(chart.title, legend_of(chart)), kChartWidth - gutter - values,
                 groups * layout.group_height};
  return layout;
}

void draw_error_bar(Svg& svg, const Scale& scale, const Bar& bar, double middle) {
  if (!bar.low || !bar.high || !scale.shows(*bar.low) || !scale.shows(*bar.high)) return;
  const double low = scale.position(*bar.low);
  const double high = scale.position(*bar.high);
  svg.line({low, middle}, {high, middle}, "error");
  for (const double x : {low, high}) svg.line({x, middle - 3.0}, {x, middle + 3.0}, "error");
}

void draw_bar(Svg& svg, const Scale& scale, const Bar& bar, double top) {
  const double base = base_of(scale);
  const double end = scale.position(bar.value);
  const double middle = top + 0.5 * kBarHeight;
  svg.box({std::min(base, end), top + 1.0, std::abs(end - base), kBarHeight - 2.0},
          bar.faint ? "bar faint" : "bar");
  draw_error_bar(svg, scale, bar, middle);
  // In a column of their own, numbers cross neither error bars nor reference lines.
  svg.text({kChartWidth, middle + 4.0}, text_of(bar), "value end");
}

void draw_group(Svg& svg, const BarChart& chart, const Scale& scale, const Layout& layout,
                std::size_t group) {
  const double top = layout.plot.y + static_cast<double>(group) * layout.group_height;
  svg.begin_group("", chart.groups[group]);
  svg.text({layout.plot.x - 9.0, top + 0.5 * layout.group_height + 4.0},
           shortened(chart.groups[group], kLongestGroup), "end");
  svg.end_group();
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const BarSeries& series = chart.series[s];
    const Bar* bar = bar_of(series, group, scale);
    if (bar == nullptr) continue;
    std::string tooltip = chart.groups[group] + ", " + series.name + ": " + figure(bar->value, 4);
    if (!chart.value.unit.empty()) tooltip += ' ' + chart.value.unit;
    if (!bar->tooltip.empty()) tooltip += "\n" + bar->tooltip;
    svg.begin_group(color_of(s), tooltip);
    draw_bar(svg, scale, *bar, top + 0.5 * kGroupGap + static_cast<double>(s) * kBarHeight);
    svg.end_group();
  }
}

void draw_marks(Svg& svg, const BarChart& chart, const Scale& scale, const Layout& layout) {
  for (const BarMarks& marks : chart.marks)
    for (std::size_t g = 0; g < std::min(marks.values.size(), chart.groups.size()); ++g) {
      if (!marks.values[g] || !scale.shows(*marks.values[g])) continue;
      const double x = scale.position(*marks.values[g]);
      const double top = layout.plot.y + static_cast<double>(g) * layout.group_height;
      svg.begin_group("", chart.groups[g] + ", " + marks.name + ": " + figure(*marks.values[g], 4));
      svg.line({x, top + 3.0}, {x, top + layout.group_height - 3.0}, "mark");
      svg.end_group();
    }
}

void draw_lines(Svg& svg, const BarChart& chart, const Scale& scale, const Box& plot) {
  for (const ReferenceLine& line : chart.lines) {
    if (!scale.shows(line.value)) continue;
    const double x = scale.position(line.value);
    svg.begin_group("", line.name + ": " + figure(line.value, 4));
    svg.line({x, plot.y}, {x, plot.y + plot.height}, "reference");
    svg.end_group();
  }
}

}  // namespace

std::string render(const BarChart& chart) {
  const Layout layout = lay_out(chart);
  const Box& plot = layout.plot;
  const Scale scale(chart.value, range_of(chart), plot.x, plot.x + plot.width, 8);
  Svg svg(kChartWidth, plot.y + plot.height + 46.0, chart.title);
  draw_head(svg, chart.title, legend_of(chart));
  draw_x_axis(svg, scale, chart.value, plot);
  const double base = base_of(scale);
  for (std::size_t g = 0; g < chart.groups.size(); ++g) draw_group(svg, chart, scale, layout, g);
  svg.line({base, plot.y}, {base, plot.y + plot.height}, "base");
  draw_marks(svg, chart, scale, layout);
  draw_lines(svg, chart, scale, plot);
  if (!has_data(chart, scale)) draw_no_data(svg, plot);
  return svg.markup();
}

}  // namespace spoke::report
