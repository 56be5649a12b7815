// Writes the tracks, their slices and the arrows of one step.

#include "program/trace/chrome_trace.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "models/support/json.h"
#include "program/trace/page_data.h"
#include "program/trace/statistics.h"

namespace spoke::trace {
namespace {

constexpr int kProcess = 1;
// Numbers of tracks that are no threads, beyond the numbers of threads.
constexpr int kRunsTrack = 100000;
constexpr int kFirstStepsTrack = 100001;

int track_of_thread(int thread) { return thread + 1; }

std::string json_text(std::string_view text) { return Json(text).dump(); }

/// Nanoseconds, written as the microseconds of the format.
struct Microseconds {
  std::int64_t nanoseconds = 0;
};

}  // namespace
}  // namespace spoke::trace

template <>
struct fmt::formatter<spoke::trace::Microseconds> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }
  template <class Context>
  auto format(const spoke::trace::Microseconds& us, Context& context) const {
    return fmt::format_to(context.out(), "{}.{:03}", us.nanoseconds / 1000, us.nanoseconds % 1000);
  }
};

namespace spoke::trace {
namespace {

/// Events, one per line.
class Events {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    text_.append(std::string_view(is_first_ ? "\n" : ",\n"));
    is_first_ = false;
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  std::string_view text() const { return {text_.data(), text_.size()}; }

 private:
  fmt::memory_buffer text_;
  bool is_first_ = true;
};

void name_track(int track, std::string_view name, int order, Events& events) {
  events.add(R"({{"ph":"M","pid":{},"tid":{},"name":"thread_name","args":{{"name":{}}}}})",
             kProcess, track, json_text(name));
  events.add(
      R"({{"ph":"M","pid":{},"tid":{},"name":"thread_sort_index","args":{{"sort_index":{}}}}})",
      kProcess, track, order);
}

void add_names(const Trace& trace, Events& events) {
  events.add(R"({{"ph":"M","pid":{},"name":"process_name","args":{{"name":{}}}}})", kProcess,
             json_text("spoke, " + trace.title));
  name_track(kRunsTrack, "runs of the executor", 1, events);
  for (int thread = 0; thread < trace.steps.threads; ++thread)
    name_track(track_of_thread(thread), name_of_thread(thread), 1000 + thread, events);
}

void add_runs(const StepTrace& trace, Events& events) {
  for (std::size_t k = 0; k < trace.runs.size(); ++k)
    events.add(R"({{"ph":"X","pid":{},"tid":{},"ts":{},"dur":{},"name":"run {}","cat":"run"}})",
               kProcess, kRunsTrack, Microseconds{trace.runs[k].begin},
               Microseconds{trace.runs[k].end - trace.runs[k].begin}, k + 1);
}

/// The time from the first begin of a step's slices to their last end.
struct Extent {
  std::int64_t begin = std::numeric_limits<std::int64_t>::max();
  std::int64_t end = 0;
};

/// Adds steps. Those that overlap, as blades run ahead of one another, go to different tracks.
void add_steps(const StepTrace& trace, Events& events) {
  std::map<std::int64_t, Extent> extents;
  for (const NodeSlice& slice : trace.slices) {
    Extent& extent = extents[slice.step];
    extent.begin = std::min(extent.begin, slice.begin);
    extent.end = std::max(extent.end, slice.end);
  }
  std::vector<TracedStep> by_begin = trace.steps;
  std::stable_sort(by_begin.begin(), by_begin.end(), [&](const auto& one, const auto& other) {
    return extents[one.step].begin < extents[other.step].begin;
  });
  std::vector<std::int64_t> ends;  // end by track
  for (const TracedStep& step : by_begin) {
    const auto [begin, end] = extents[step.step];
    const auto found = std::find_if(ends.begin(), ends.end(),
                                    [first = begin](std::int64_t last) { return last <= first; });
    const int track = kFirstStepsTrack + static_cast<int>(found - ends.begin());
    if (found == ends.end()) {
      ends.push_back(end);
      const auto count = static_cast<int>(ends.size());
      name_track(track, count == 1 ? "steps" : fmt::format("steps ({})", count), 1 + count, events);
    } else {
      *found = end;
    }
    events.add(R"({{"ph":"X","pid":{},"tid":{},"ts":{},"dur":{},"name":"step {}","cat":"step",)"
               R"("args":{{"step":{},"time_s":{},"passes":{}}}}})",
               kProcess, track, Microseconds{begin}, Microseconds{end - begin}, step.step,
               step.step, step.time, step.passes);
  }
}

void add_nodes(const StepTrace& trace, Events& events) {
  const std::vector<double> costs = mean_costs(trace);
  std::vector<std::string> heads;  // text with which all slices of a node begin
  std::vector<std::string> ends;
  for (std::size_t node = 0; node < trace.graph.names.size(); ++node) {
    heads.push_back(fmt::format(R"("name":{},"cat":{})", json_text(trace.graph.names[node]),
                                json_text(trace.graph.labels[node].stage)));
    ends.push_back(fmt::format(R"("node":{},"cost_us":{:.3f})", node, 1e6 * costs[node]));
  }
  for (const NodeSlice& slice : trace.slices) {
    const auto node = static_cast<std::size_t>(slice.node);
    events.add(R"({{"ph":"X","pid":{},"tid":{},"ts":{},"dur":{},{},)"
               R"("args":{{"step":{},"pass":{},"cluster":{},{}}}}})",
               kProcess, track_of_thread(slice.thread), Microseconds{slice.begin},
               Microseconds{slice.end - slice.begin}, heads[node], slice.step, slice.pass,
               slice.cluster, ends[node]);
  }
}

/// Adds an arrow. It leaves within the slice that it comes from, and so before its end.
void add_arrow(const NodeSlice& from, const NodeSlice& to, int id, Events& events) {
  const std::int64_t leaves = std::max(from.begin, from.end - 1);
  events.add(R"({{"ph":"s","pid":{},"tid":{},"ts":{},"id":{},"name":"edge","cat":"edge"}})",
             kProcess, track_of_thread(from.thread), Microseconds{leaves}, id);
  events.add(
      R"({{"ph":"f","bp":"e","pid":{},"tid":{},"ts":{},"id":{},"name":"edge","cat":"edge"}})",
      kProcess, track_of_thread(to.thread), Microseconds{to.begin}, id);
}

void add_arrows(const StepTrace& trace, Events& events) {
  const TracedStep& step = middle_step(trace);
  const std::vector<NodeSlice> slices = trace.slices_of(step.step);
  std::map<std::pair<int, int>, const NodeSlice*> found;  // slices by pass and node
  for (const NodeSlice& slice : slices) found[{slice.pass, slice.node}] = &slice;
  int id = 0;
  const auto add = [&](const std::vector<NodeEdge>& edges, int from_pass, int to_pass) {
    for (const NodeEdge& edge : edges) {
      const auto from = found.find({from_pass, edge.from});
      const auto to = found.find({to_pass, edge.to});
      if (from != found.end() && to != found.end())
        add_arrow(*from->second, *to->second, ++id, events);
    }
  };
  for (int pass = 0; pass < step.passes; ++pass) {
    add(trace.graph.edges, pass, pass);
    add(trace.graph.next_pass_edges, pass, pass + 1);
  }
}

/// Adds the number of nodes that run, whenever it changes.
void add_counter(const StepTrace& trace, Events& events) {
  std::map<std::int64_t, int> changes;
  for (const NodeSlice& slice : trace.slices) {
    ++changes[slice.begin];
    --changes[slice.end];
  }
  int running = 0;
  for (const auto& [time, change] : changes) {
    running += change;
    if (change != 0)
      events.add(R"({{"ph":"C","pid":{},"ts":{},"name":"running nodes","args":{{"nodes":{}}}}})",
                 kProcess, Microseconds{time}, running);
  }
}

Json describe_origin(const Trace& trace) {
  return {{"version", SPOKE_VERSION},
          {"created", trace.created},
          {"scenario", trace.scenario},
          {"executor", name_of(trace.options.executor)},
          {"threads", trace.threads},
          {"machine", trace.machine.cpu},
          {"step_with_arrows", middle_step(trace.steps).step},
          {"dropped_steps", trace.steps.dropped_steps}};
}

}  // namespace

std::string make_chrome_trace(const Trace& trace) {
  assert(!trace.steps.steps.empty());
  Events events;
  add_names(trace, events);
  add_runs(trace.steps, events);
  add_steps(trace.steps, events);
  add_nodes(trace.steps, events);
  add_arrows(trace.steps, events);
  add_counter(trace.steps, events);
  const std::string origin = describe_origin(trace).dump();
  return fmt::format(
      "{{\"displayTimeUnit\":\"ns\",\n\"otherData\":{},\n\"spoke\":{},\n\"traceEvents\":[{}\n]}}\n",
      origin, make_description(trace), events.text());
}

}  // namespace spoke::trace
