#include "program/trace/page_data.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/approx.h"
#include "tests/program/trace/samples.h"

using namespace spoke;
using namespace spoke::trace;
using namespace spoke::trace::testing;
using nlohmann::json;
using spoke::testing::approx;

TEST_CASE("the page's data tell settings, graph, steps and slices") {
  const Trace trace = make_trace({ExecutorKind::flow_graph, 2, 1, true});
  const json data = json::parse(make_page_data(trace));
  CHECK(data["format"] == "spoke-trace");
  CHECK(data["version"] == 1);
  CHECK(data["scenario"] == "sample");
  CHECK(data["settings"]["executor"] == "flow_graph");
  CHECK(data["settings"]["threads"] == "2");
  CHECK(data["settings"]["window_steps"] == 1);
  CHECK(data["settings"]["step_s"] == 0.01);
  CHECK(data["notes"] == json::array());
  CHECK(data["machine"]["cores"].get<int>() >= 1);
  CHECK(data["subsystem_word"] == "blade");
  CHECK(data["subsystems"].front() == "blade 1");
  CHECK(data["threads"] == json({"main", "worker 1"}));
  CHECK(data["stages"].front() == "hub motion");
  REQUIRE(data["steps"].size() == 10);
  CHECK(data["steps"][0]["step"] == 21);
  CHECK(data["steps"][0]["time_s"].get<double>() == approx(0.21));
  CHECK(data["dropped_steps"] == 0);
  const json& graph = data["graph"];
  const std::size_t nodes = trace.steps.graph.labels.size();
  for (const char* column : {"stage", "subsystem", "body", "name"})
    CHECK(graph[column].size() == nodes);
  for (const char* edges : {"edges", "next_pass_edges"}) {
    CHECK(graph[edges]["from"].size() > 0);
    CHECK(graph[edges]["from"].size() == graph[edges]["to"].size());
  }
  for (const auto& slices : data["slices"].items()) {
    CAPTURE(slices.key());
    CHECK(slices.value().size() == trace.steps.slices.size());
  }
  CHECK(data["slices"].size() == 7);
}

TEST_CASE("times are written in microseconds, to the nanosecond") {
  Trace trace = small_trace();
  trace.steps.slices = {{0, 7, 0, -1, 0, 5, 1234567}};
  const std::string text = make_page_data(trace);
  CHECK(text.find("\"begin_us\":[0.005]") != std::string::npos);
  CHECK(text.find("\"duration_us\":[1234.562]") != std::string::npos);
}

TEST_CASE("the page takes the data in place of null, and no text of theirs ends its element") {
  const std::string begin = "<p>a</p><script type=\"application/json\" id=\"spoke-trace\">";
  const std::string end = "</script><p>b</p>";
  const std::string page = begin + "null" + end;
  const Trace trace = make_trace({});
  const std::string data = make_page_data(trace);
  CHECK(data.find("</script>") != std::string::npos);  // in the title
  const std::string text = make_trace_page(page, data);
  CHECK(text.starts_with(begin));
  REQUIRE(text.ends_with(end));
  const std::string inside = text.substr(begin.size(), text.size() - begin.size() - end.size());
  CHECK(inside.find('<') == std::string::npos);
  CHECK(json::parse(inside) == json::parse(data));
}

TEST_CASE("a page without one place for the data is refused") {
  const std::string element = "<script type=\"application/json\" id=\"spoke-trace\">null</script>";
  CHECK_THROWS_AS(make_trace_page("<p>nothing</p>", "{}"), std::invalid_argument);
  CHECK_THROWS_AS(make_trace_page(element + element, "{}"), std::invalid_argument);
  CHECK_THROWS_AS(
      make_trace_page("<script type=\"application/json\" id=\"spoke-trace\">{}</script>", "{}"),
      std::invalid_argument);
}
