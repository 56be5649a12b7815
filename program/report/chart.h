#pragma once

// Charts as inline SVG for pages of report/page.h, whose style sheet colours them. Series are told
// apart by colours for the colour-blind, lines also by their markers; every mark has a tooltip.

#include <optional>
#include <string>
#include <vector>

#include "program/report/scale.h"

namespace spoke::report {

/// A dashed line across the whole chart at one value.
struct ReferenceLine {
  std::string name = {};
  double value = 0.0;
};

struct Bar {
  double value = 0.0;
  std::optional<double> low = {};
  std::optional<double> high = {};  ///< end of an error bar
  std::string text = {};            ///< text beside it; empty: the value in three digits
  std::string tooltip = {};         ///< text appended to group, series and value
  bool faint = false;               ///< whether it is drawn paler than others
};

/// A series of one bar in each group; none where there is no value.
struct BarSeries {
  std::string name = {};
  std::vector<std::optional<Bar>> bars = {};
};

/// Short strokes across the bars of each group, as for a target or a bound.
struct BarMarks {
  std::string name = {};
  std::vector<std::optional<double>> values = {};  ///< values by group
};

/// Horizontal bars, grouped. Bars begin at 0, or at the low end of a logarithmic axis.
struct BarChart {
  std::string title = {};
  Axis value = {};
  std::vector<std::string> groups = {};
  std::vector<BarSeries> series = {};
  std::vector<BarMarks> marks = {};
  std::vector<ReferenceLine> lines = {};
};

struct DataPoint {
  double x = 0.0, y = 0.0;
  std::string tooltip = {};  ///< text appended to series and values
};

struct BandPoint {
  double x = 0.0, low = 0.0, high = 0.0;
};

/// Points in order, joined by a line. A point that the axes cannot show (not finite, or not
/// positive on a logarithmic one) parts the line.
struct LineSeries {
  std::string name = {};
  std::vector<DataPoint> points = {};
  std::vector<BandPoint> band = {};  ///< band shaded behind the line, in order of x
  bool markers = true;
  bool dashed = false;
};

struct LineChart {
  std::string title = {};
  Axis x = {};
  Axis y = {};
  std::vector<LineSeries> series = {};
  std::vector<ReferenceLine> lines = {};  ///< lines at values of y
};

/// Returns the markup of the drawing. A chart without values shows its axes and says "no data".
std::string render(const BarChart& chart);
std::string render(const LineChart& chart);

}  // namespace spoke::report
