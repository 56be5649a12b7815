// Draws the parts common to all charts: title, legend, axes and grid.

#include "program/report/chart_frame.h"

namespace spoke::report {
namespace {

constexpr double kTitleHeight = 28.0;
constexpr double kSampleWidth = 26.0;
constexpr double kEntryGap = 22.0;
constexpr std::size_t kLongestEntry = 60;  // characters

double entry_width(const LegendEntry& entry) {
  return kSampleWidth + width_of(shortened(entry.name, kLongestEntry)) + kEntryGap;
}

bool is_shown(const std::vector<LegendEntry>& legend) { return legend.size() > 1; }

void draw_sample(Svg& svg, const LegendEntry& entry, Point2 at) {
  const double y = at.y - 4.0;
  switch (entry.sample) {
    case LegendEntry::Sample::box:
      svg.box({at.x + 6.0, y - 6.0, 12.0, 12.0}, "bar");
      break;
    case LegendEntry::Sample::line:
    case LegendEntry::Sample::dashed_line:
      svg.path(command('M', {at.x, y}) + "h20",
               entry.sample == LegendEntry::Sample::line ? "line" : "line dashed");
      break;
    case LegendEntry::Sample::reference:
      svg.line({at.x, y}, {at.x + 20.0, y}, "reference");
      break;
    case LegendEntry::Sample::mark:
      svg.line({at.x + 12.0, y - 7.0}, {at.x + 12.0, y + 7.0}, "mark");
      break;
  }
  if (entry.has_marker) svg.path(marker({at.x + 10.0, y}, entry.marker), "point");
}

/// Lays the legend out in rows; draws it if there is a drawing. Returns the number of rows.
int lay_out_legend(Svg* svg, const std::vector<LegendEntry>& legend, double top) {
  if (!is_shown(legend)) return 0;
  double x = 0.0;
  int row = 0;
  for (const LegendEntry& entry : legend) {
    const double width = entry_width(entry);
    if (x > 0.0 && x + width > kChartWidth) {
      x = 0.0;
      ++row;
    }
    if (svg != nullptr) {
      const double y = top + kLineHeight * (row + 1) - 4.0;
      svg->begin_group(entry.color);
      draw_sample(*svg, entry, {x, y});
      svg->text({x + kSampleWidth, y}, shortened(entry.name, kLongestEntry), "");
      svg->end_group();
    }
    x += width;
  }
  return row + 1;
}

}  // namespace

std::string color_of(std::size_t series) {
  return std::string(1, 's') + static_cast<char>('0' + series % 8);
}

double head_height(const std::string& title, const std::vector<LegendEntry>& legend) {
  const double top = title.empty() ? 4.0 : kTitleHeight;
  return top + kLineHeight * lay_out_legend(nullptr, legend, top) + 12.0;
}

void draw_head(Svg& svg, const std::string& title, const std::vector<LegendEntry>& legend) {
  if (!title.empty()) svg.text({0.0, 16.0}, title, "title");
  lay_out_legend(&svg, legend, title.empty() ? 4.0 : kTitleHeight);
}

void draw_x_axis(Svg& svg, const Scale& scale, const Axis& axis, const Box& plot) {
  const double bottom = plot.y + plot.height;
  for (const Tick& tick : scale.ticks()) {
    const double x = scale.position(tick.value);
    svg.line({x, plot.y}, {x, bottom}, "grid");
    svg.text({x, bottom + 17.0}, tick.label, "tick middle");
  }
  svg.text({plot.x + 0.5 * plot.width, bottom + 38.0}, title_of(axis), "axis middle");
}

void draw_y_axis(Svg& svg, const Scale& scale, const Axis& axis, const Box& plot) {
  for (const Tick& tick : scale.ticks()) {
    const double y = scale.position(tick.value);
    svg.line({plot.x, y}, {plot.x + plot.width, y}, "grid");
    svg.text({plot.x - 8.0, y + 4.0}, tick.label, "tick end");
  }
  svg.upward_text({14.0, plot.y + 0.5 * plot.height}, title_of(axis), "axis middle");
}

void draw_no_data(Svg& svg, const Box& plot) {
  svg.text({plot.x + 0.5 * plot.width, plot.y + 0.5 * plot.height + 4.0}, "no data", "axis middle");
}

}  // namespace spoke::report
