#pragma once

// Drawing of the parts common to all kinds of charts.

#include <string>
#include <vector>

#include "program/report/chart.h"
#include "program/report/svg.h"

namespace spoke::report {

constexpr double kChartWidth = 920.0;
constexpr double kLineHeight = 18.0;

/// Returns the class that gives a series its colour.
std::string color_of(std::size_t series);

/// An entry of a legend: a sample of the mark, and its name.
struct LegendEntry {
  enum class Sample { box, line, dashed_line, reference, mark };
  std::string name = {};
  std::string color = {};
  Sample sample = Sample::box;
  std::size_t marker = 0;
  bool has_marker = false;
};

/// Draws title and legend at the top; no legend of a single entry.
void draw_head(Svg& svg, const std::string& title, const std::vector<LegendEntry>& legend);
/// Returns the height that draw_head() takes, the gap below included.
double head_height(const std::string& title, const std::vector<LegendEntry>& legend);

/// Draws vertical grid lines over the plot with labels below it and the axis title below these.
void draw_x_axis(Svg& svg, const Scale& scale, const Axis& axis, const Box& plot);
/// Draws horizontal grid lines over the plot with labels to its left, the axis title left of these.
void draw_y_axis(Svg& svg, const Scale& scale, const Axis& axis, const Box& plot);
void draw_no_data(Svg& svg, const Box& plot);

}  // namespace spoke::report
