#include "program/trace/chrome_trace.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "program/trace/page_data.h"
#include "tests/program/trace/samples.h"

using namespace spoke;
using namespace spoke::trace;
using namespace spoke::trace::testing;
using nlohmann::json;

namespace {

std::int64_t nanoseconds(const json& us) { return std::llround(1000.0 * us.get<double>()); }

struct Interval {
  std::int64_t begin = 0;
  std::int64_t end = 0;
  bool contains(const Interval& other) const { return begin <= other.begin && other.end <= end; }
};

Interval interval_of(const json& event) {
  const std::int64_t begin = nanoseconds(event["ts"]);
  return {begin, begin + nanoseconds(event["dur"])};
}

/// The events of a file, sorted as a viewer does.
struct Events {
  std::map<int, std::vector<Interval>> tracks;  ///< slices by thread, in the order of the file
  std::map<std::int64_t, Interval> steps;
  std::vector<Interval> runs;
  std::vector<json> nodes;
  std::map<int, json> leaving, arriving;  ///< ends of arrows by id
  std::set<int> named;
  std::vector<int> counter;
};

Events sort_out(const json& file) {
  Events events;
  for (const json& event : file["traceEvents"]) {
    const std::string kind = event["ph"];
    CHECK(event["pid"] == 1);
    if (kind == "M") {
      if (event["name"] == "thread_name") events.named.insert(event["tid"].get<int>());
    } else if (kind == "C") {
      events.counter.push_back(event["args"]["nodes"]);
    } else if (kind == "s" || kind == "f") {
      auto& ends = kind == "s" ? events.leaving : events.arriving;
      CHECK(ends.emplace(event["id"].get<int>(), event).second);
    } else {
      REQUIRE(kind == "X");
      events.tracks[event["tid"]].push_back(interval_of(event));
      if (event["cat"] == "step")
        events.steps[event["args"]["step"]] = interval_of(event);
      else if (event["cat"] == "run")
        events.runs.push_back(interval_of(event));
      else
        events.nodes.push_back(event);
    }
  }
  return events;
}

void check_no_overlap(Events& events) {
  for (auto& entry : events.tracks) {
    const auto& track = entry.first;
    auto& intervals = entry.second;
    CAPTURE(track);
    CHECK(events.named.count(track) == 1);
    std::sort(intervals.begin(), intervals.end(), [](const Interval& one, const Interval& other) {
      return std::tuple(one.begin, one.end) < std::tuple(other.begin, other.end);
    });
    int overlaps = 0;
    for (std::size_t k = 1; k < intervals.size(); ++k)
      overlaps += intervals[k].begin < intervals[k - 1].end;
    CHECK(overlaps == 0);
  }
}

void check_parents(const Events& events, const json& spoke) {
  int outside = 0;
  for (const json& node : events.nodes) {
    const Interval own = interval_of(node);
    const auto step = events.steps.find(node["args"]["step"].get<std::int64_t>());
    if (step == events.steps.end())
      outside += node["args"]["step"] != -1;
    else
      outside += !step->second.contains(own);
    outside += std::none_of(events.runs.begin(), events.runs.end(),
                            [&](const Interval& run) { return run.contains(own); });
    const auto index = node["args"]["node"].get<std::size_t>();
    outside += node["name"] != spoke["graph"]["name"][index];
    outside += node["cat"] != spoke["stages"][spoke["graph"]["stage"][index].get<std::size_t>()];
  }
  CHECK(outside == 0);
  CHECK(events.steps.size() == spoke["steps"].size());
}

/// Whether an arrow's end lies in a slice. A coarse clock gives short nodes no duration: the end of
/// an arrow then lies at that of the slice.
bool lies_in(const json& slice, const json& end) {
  const Interval own = interval_of(slice);
  const std::int64_t time = nanoseconds(end["ts"]);
  return slice["tid"] == end["tid"] && own.begin <= time &&
         (time < own.end || (own.begin == own.end && time == own.end));
}

/// Checks that each edge of the chosen step has one pair of ends in each pass, each within its
/// slice.
void check_arrows(const Events& events, const json& file) {
  const json& spoke = file["spoke"];
  const std::int64_t chosen = file["otherData"]["step_with_arrows"];
  std::map<std::pair<int, int>, json> slices;  // by pass and node
  int passes = 0;
  for (const json& node : events.nodes) {
    if (node["args"]["step"] != chosen) continue;
    const int pass = node["args"]["pass"].get<int>();
    slices[{pass, node["args"]["node"].get<int>()}] = node;
    passes = std::max(passes, pass + 1);
  }
  std::vector<std::pair<json, json>> expected;
  const auto expect = [&](const json& edges, int pass, int passes_on) {
    for (std::size_t k = 0; k < edges["from"].size(); ++k) {
      const auto from = slices.find({pass, edges["from"][k].get<int>()});
      const auto to = slices.find({pass + passes_on, edges["to"][k].get<int>()});
      if (from != slices.end() && to != slices.end())
        expected.emplace_back(from->second, to->second);
    }
  };
  for (int pass = 0; pass < passes; ++pass) {
    expect(spoke["graph"]["edges"], pass, 0);
    expect(spoke["graph"]["next_pass_edges"], pass, 1);
  }
  CHECK_FALSE(expected.empty());
  REQUIRE(events.leaving.size() == expected.size());
  REQUIRE(events.arriving.size() == expected.size());
  for (std::size_t k = 0; const auto& [id, leaving] : events.leaving) {
    REQUIRE(events.arriving.count(id) == 1);
    const json& arriving = events.arriving.at(id);
    CHECK(arriving["bp"] == "e");
    CHECK(leaving["name"] == arriving["name"]);
    CHECK(leaving["cat"] == arriving["cat"]);
    CHECK(leaving["ts"].get<double>() <= arriving["ts"].get<double>());
    CHECK(lies_in(expected[k].first, leaving));
    CHECK(lies_in(expected[k].second, arriving));
    ++k;
  }
}

/// Checks that each node runs once in a step and pass, except for the hub solve of a window.
void check_once(const Events& events, bool is_windowed) {
  std::set<std::tuple<std::int64_t, int, int>> seen;
  int twice = 0;
  for (const json& node : events.nodes) {
    const json& args = node["args"];
    if (args["step"] == -1 || (is_windowed && node["name"] == "hub solve")) continue;
    twice += !seen.emplace(args["step"], args["pass"], args["node"]).second;
  }
  CHECK(twice == 0);
}

void check_counter(const Events& events, int threads) {
  REQUIRE_FALSE(events.counter.empty());
  CHECK(*std::min_element(events.counter.begin(), events.counter.end()) == 0);
  CHECK(*std::max_element(events.counter.begin(), events.counter.end()) <= threads);
  CHECK(events.counter.back() == 0);
}

/// Checks that the page's data are those of the file: equal slices, so equal sums.
void check_page(const Events& events, const json& file, const json& page) {
  json description = page;
  description.erase("slices");
  CHECK(description == file["spoke"]);
  const json& slices = page["slices"];
  REQUIRE(slices["node"].size() == events.nodes.size());
  int different = 0;
  for (std::size_t k = 0; k < events.nodes.size(); ++k) {
    const json& event = events.nodes[k];
    for (const char* field : {"node", "step", "pass", "cluster"})
      different += slices[field][k] != event["args"][field];
    different += slices["thread"][k].get<int>() + 1 != event["tid"].get<int>();
    different += slices["begin_us"][k] != event["ts"];
    different += slices["duration_us"][k] != event["dur"];
  }
  CHECK(different == 0);
}

void check_file(const Sample& sample) {
  CAPTURE(name_of(sample.executor));
  CAPTURE(sample.window);
  CAPTURE(sample.is_coupled);
  const Trace trace = make_trace(sample);
  const json file = json::parse(make_chrome_trace(trace));
  CHECK(file["displayTimeUnit"] == "ns");
  CHECK(file["otherData"]["scenario"] == "sample");
  Events events = sort_out(file);
  CHECK(events.nodes.size() == trace.steps.slices.size());
  CHECK(events.steps.size() == 10);
  check_no_overlap(events);
  check_parents(events, file["spoke"]);
  check_arrows(events, file);
  check_once(events, trace.steps.window_steps > 1 && !sample.is_coupled);
  check_counter(events, trace.steps.threads);
  check_page(events, file, json::parse(make_page_data(trace)));
}

}  // namespace

TEST_CASE("trace.json validates for every executor, window and kind of hub") {
  for (const ExecutorKind kind : graph::executor_kinds())
    for (const bool is_coupled : {false, true})
      for (const int window : {1, 4}) check_file({kind, 2, window, is_coupled});
}

TEST_CASE("trace.json validates for nested teams, many threads and the augmented formulation") {
  for (const ExecutorKind kind : graph::executor_kinds())
    if (kind == ExecutorKind::openmp_scheme1 || kind == ExecutorKind::openmp_scheme2)
      check_file({kind, {3, 2}, 1, false, Formulation::subsystem});
  check_file({ExecutorKind::flow_graph, 6, 3, false, Formulation::augmented});
  check_file({ExecutorKind::flow_graph, 12, 8, false});
}

TEST_CASE("trace.json of a trace made by hand") {
  const json file = json::parse(make_chrome_trace(small_trace()));
  Events events = sort_out(file);
  check_no_overlap(events);
  check_parents(events, file["spoke"]);
  check_arrows(events, file);
  CHECK(events.leaving.size() == 6);  // two passes of two edges, and two edges between them
  CHECK(file["otherData"]["step_with_arrows"] == 8);
  CHECK(events.steps.at(7).begin == 1000);
  CHECK(events.steps.at(7).end == 10000);
  CHECK(events.nodes[1]["args"]["cost_us"] == 3.0);
  CHECK(events.counter == std::vector<int>{1, 2, 1, 0, 1, 2, 1, 0, 1, 2, 1, 0, 1, 2, 1, 0});
}
