#include "program/report/chart.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/program/report/xml.h"

using namespace spoke::report;

namespace {

BarChart bars() {
  return {"Speedup <over> serial",
          {.title = "speedup"},
          {"one & all", "two"},
          {{"structured", {Bar{1.5, 1.4, 1.6, "", "20 rounds"}, std::nullopt}},
           {"subsystem", {Bar{0.5}, Bar{.value = 1.9, .faint = true}}}},
          {{"bound", {1.7, std::nullopt}}},
          {{"serial", 1.0}}};
}

LineChart lines() {
  return {"Scaling",
          {.title = "threads", .unit = "1"},
          {.title = "time", .unit = "us", .kind = ScaleKind::log},
          {{"measured", {{1, 400}, {2, 210}, {4, 0.0}, {8, 100}}, {{1, 390, 410}, {2, 200, 220}}},
           {"model", {{1, 400}, {8, 90, "at P = 8"}}, {}, false, true}},
          {{"span", 36.0}}};
}

}  // namespace

TEST_CASE("a bar chart is well-formed and has a bar for each value") {
  const std::string svg = render(bars());
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "class=\"bar\"") == 2 + 2);  // and two in the legend
  CHECK(count_of(svg, "class=\"error\"") == 3);
  CHECK(count_of(svg, "class=\"mark\"") == 1 + 1);
  CHECK(count_of(svg, "class=\"reference\"") == 1 + 1);
  CHECK(count_of(svg, "class=\"bar faint\"") == 1);
  CHECK(svg.find("<title>one &amp; all, structured: 1.500\n20 rounds</title>") !=
        std::string::npos);
  CHECK(svg.find("Speedup &lt;over&gt; serial") != std::string::npos);
  CHECK(svg.find("viewBox") != std::string::npos);
  CHECK(svg.find(" width=\"920\"") == std::string::npos);
}

TEST_CASE("a line chart is well-formed, and a gap parts the line") {
  const std::string svg = render(lines());
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, "class=\"point\"") == 3 + 1);  // and one in the legend
  CHECK(count_of(svg, "class=\"band\"") == 1);
  CHECK(count_of(svg, "class=\"line dashed\"") == 1 + 1);
  CHECK(svg.find("measured: threads 2.000 1, time 210.0 us") != std::string::npos);
  const auto path = svg.find("<title>measured</title>");
  const auto begin = svg.find("d=\"", path);
  const std::string commands = svg.substr(begin, svg.find('"', begin + 3) - begin);
  CHECK(count_of(commands, "M") == 2);
  CHECK(count_of(commands, "L") == 1);
}

TEST_CASE("long labels of the y axis move the plot, not into the title") {
  LineChart chart;
  chart.y = {.title = "speed"};
  chart.series = {{"constant", {{0.0, -0.00123456}, {1.0, -0.00123457}}}};
  const std::string svg = render(chart);
  const auto label = svg.find("class=\"tick end\">-0.00123");
  REQUIRE(label != std::string::npos);
  const auto x = svg.rfind("<text x=\"", label) + 9;
  const auto text = label + std::string("class=\"tick end\">").size();
  const double characters = static_cast<double>(svg.find('<', text) - text);
  CHECK(std::stod(svg.substr(x)) - 7.7 * characters >= 20.0);  // right of the title
}

TEST_CASE("charts without values say so") {
  BarChart no_bars;
  CHECK(render(no_bars).find("no data") != std::string::npos);
  no_bars.groups = {"a"};
  no_bars.series = {{"empty", {}}, {"nothing", {std::nullopt}}, {"nan", {Bar{std::nan("")}}}};
  CHECK(render(no_bars).find("no data") != std::string::npos);
  CHECK(xml_fault(render(no_bars)) == "");
  LineChart no_lines;
  no_lines.series = {{"empty", {}}, {"not shown", {{1.0, -1.0}}}};
  no_lines.y.kind = ScaleKind::log;
  CHECK(render(no_lines).find("no data") != std::string::npos);
  CHECK(xml_fault(render(no_lines)) == "");
  CHECK(render(bars()).find("no data") == std::string::npos);
}

TEST_CASE("no coordinate is other than a number") {
  BarChart chart = bars();
  chart.value.kind = ScaleKind::log;
  chart.series[0].bars[0] = Bar{0.0};
  chart.series[1].bars = {Bar{INFINITY}, Bar{-1.0}, Bar{3.0}};
  for (const std::string& svg : {render(chart), render(lines())}) {
    CHECK(count_of(svg, "=\"nan") + count_of(svg, "=\"-nan") + count_of(svg, "=\"inf") == 0);
    CHECK(xml_fault(svg) == "");
  }
}

TEST_CASE("long names are cut with the whole name in the tooltip") {
  BarChart chart = bars();
  const std::string name(70, 'n');
  chart.groups[0] = name;
  const std::string svg = render(chart);
  CHECK(svg.find("<title>" + name + "</title>") != std::string::npos);
  CHECK(svg.find(">" + std::string(39, 'n') + "\u2026</text>") != std::string::npos);
}
