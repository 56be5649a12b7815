#include "engine/step_recording.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "engine/pass_ends.h"

namespace spoke {
namespace {

using graph::NodeId;
using graph::NodeLabel;
using graph::StepGraph;

/// Runs to make room for: twice as many as expected, and some for short recordings.
std::size_t expected_runs(const RecordingPlan& plan, int passes) {
  const double steps = static_cast<double>(plan.last_step - plan.first_step + 1);
  return 8 + static_cast<std::size_t>(std::ceil(2.0 * steps * plan.passes_per_step / passes));
}

/// Numbers nodes of one pass in the order in which the graph lists them.
class NodeNumbers {
 public:
  int of(const NodeLabel& label) {
    const auto [place, is_new] = numbers_.try_emplace({label.stage, label.subsystem, label.body},
                                                      static_cast<int>(numbers_.size()));
    return place->second;
  }

 private:
  std::map<std::tuple<std::string, int, int>, int> numbers_;
};

/// Ticks as nanoseconds since the start of the recording.
class Nanoseconds {
 public:
  explicit Nanoseconds(std::uint64_t start)
      : start_(start), per_tick_(1e9 * graph::time_stamp_scale().seconds_per_tick) {}
  std::int64_t operator()(std::uint64_t ticks) const {
    // A tick before the start can only be that of a counter that lags on another processor.
    const auto since = static_cast<std::int64_t>(ticks - start_);
    return std::max<std::int64_t>(0, std::llround(static_cast<double>(since) * per_tick_));
  }

 private:
  std::uint64_t start_;
  double per_tick_;
};

void sort_by_begin(std::vector<NodeSlice>& slices) {
  std::stable_sort(slices.begin(), slices.end(), [](const NodeSlice& one, const NodeSlice& other) {
    return one.begin < other.begin;
  });
}

}  // namespace

StepRecording::StepRecording(const StepGraph& run_graph, const StepData& data,
                             const RecordingPlan& plan)
    : plan_(plan),
      passes_(count_passes(run_graph)),
      clocks_(static_cast<int>(data.clocks.size())),
      recorder_(plan.threads, run_graph.node_count(),
                graph::make_room(expected_runs(plan, passes_), run_graph.node_count(), plan.threads,
                                 plan.buffer_bytes)),
      at_begin_(data.clocks.size()),
      places_(data.clocks.size() * static_cast<std::size_t>(passes_)),
      dropped_(static_cast<std::size_t>(plan.last_step - plan.first_step + 1), 0) {
  const std::size_t runs = expected_runs(plan, passes_);
  all_places_.resize(runs * places_.size());
  run_places_.resize(runs);
  find_origins(run_graph, data.is_coupled);
}

int StepRecording::count_passes(const StepGraph& run_graph) {
  int last = 0;
  for (const graph::Node& node : run_graph.nodes()) last = std::max(last, node.label.pass);
  return last + 1;
}

void StepRecording::find_origins(const StepGraph& run_graph, bool is_coupled) {
  NodeNumbers numbers;
  for (const graph::Node& node : run_graph.nodes()) {
    const NodeLabel& label = node.label;
    // Coupled: all follow the only clock. Else those of no subsystem, the hub solve, follow none.
    const int clock = is_coupled ? 0 : label.subsystem;
    origins_.push_back({numbers.of(label), clock, std::max(label.pass, 0)});
  }
}

void StepRecording::begin_run(const StepData& data) {
  for (std::size_t c = 0; c < at_begin_.size(); ++c)
    at_begin_[c] = {static_cast<std::int64_t>(data.clocks[c].step),
                    static_cast<int>(data.clocks[c].passes)};
  complete_ = last_complete_step(data);
  recorder_.begin_run();
}

void StepRecording::end_run(const StepData& data) {
  const bool is_recorded = recorder_.is_recording();
  recorder_.end_run();
  place_passes(data);
  if (!is_recorded) return drop_steps();
  const auto run = static_cast<std::size_t>(recorder_.runs() - 1);
  std::copy(places_.begin(), places_.end(),
            all_places_.begin() + static_cast<std::ptrdiff_t>(run * places_.size()));
  run_places_[run] = place_of_all(data);
}

/// Each clock has gone pass by pass from where it stood at the begin to where it stands now; how
/// many passes the steps took that it completed on the way is in their records.
void StepRecording::place_passes(const StepData& data) {
  for (std::size_t c = 0; c < data.clocks.size(); ++c) {
    const Clock& clock = data.clocks[c];
    const auto passes_of = [&](std::int64_t step) {
      const double passes = data.is_coupled ? of_step(data.records, step).step.passes
                                            : of_step(data.subsystems[c].records, step).passes;
      return static_cast<int>(passes);
    };
    Place at = at_begin_[c];
    for (int pass = 0; pass < passes_; ++pass) {
      const bool is_there = static_cast<double>(at.step) == clock.step &&
                            static_cast<double>(at.pass) == clock.passes;
      places_[c * static_cast<std::size_t>(passes_) + static_cast<std::size_t>(pass)] =
          is_there ? Place{} : at;
      if (is_there) continue;
      ++at.pass;
      if (static_cast<double>(at.step) < clock.step && at.pass == passes_of(at.step))
        at = {at.step + 1, 0};
    }
  }
}

/// Of the hub solve: the pass that all clocks made that made one, or else the last pass of the last
/// step that the run completed.
StepRecording::Place StepRecording::place_of_all(const StepData& data) const {
  if (passes_ == 1) {
    Place common;
    bool is_common = true;
    for (const Place& place : places_) {
      if (place.step < 0) continue;
      if (common.step < 0) common = place;
      is_common = is_common && common.step == place.step && common.pass == place.pass;
    }
    if (is_common) return common;
  }
  const std::int64_t last = last_complete_step(data);
  if (last <= complete_) return {};
  return {last, static_cast<int>(of_step(data.records, last).step.passes) - 1};
}

void StepRecording::drop_steps() {
  for (const Place& place : places_)
    if (is_wanted(place.step))
      dropped_[static_cast<std::size_t>(place.step - plan_.first_step)] = 1;
}

StepRecording::Place StepRecording::place_of(const Origin& origin, int run) const {
  if (origin.clock < 0) return run_places_[static_cast<std::size_t>(run)];
  const int row = (run * clocks_ + origin.clock) * passes_;
  return all_places_[static_cast<std::size_t>(row + origin.pass)];
}

std::vector<TracedStep> StepRecording::find_steps(double step_size) const {
  std::map<std::int64_t, int> passes;
  const auto used = static_cast<std::size_t>(recorder_.runs()) * places_.size();
  for (std::size_t k = 0; k < used; ++k) {
    const Place& place = all_places_[k];
    if (!is_wanted(place.step) || is_dropped(place.step)) continue;
    int& most = passes[place.step];
    most = std::max(most, place.pass + 1);
  }
  std::vector<TracedStep> steps;
  for (const auto& [step, count] : passes)
    steps.push_back({step, static_cast<double>(step) * step_size, count});
  return steps;
}

template <class Wants>
void StepRecording::add_slices(int run, Wants wants, std::vector<NodeSlice>& slices) const {
  const Nanoseconds nanoseconds(recorder_.run(0).begin);
  for (int thread = 0; thread < recorder_.threads(); ++thread)
    for (const graph::NodeRecord& record : recorder_.records(run, thread)) {
      const Origin& origin = origins_[static_cast<std::size_t>(record.node)];
      const Place place = place_of(origin, run);
      if (wants(place))
        slices.push_back({origin.node, place.step, place.pass, record.cluster, thread,
                          nanoseconds(record.begin), nanoseconds(record.end)});
    }
}

TracedStep StepRecording::collect_step(std::int64_t step, double step_size,
                                       std::vector<NodeSlice>& slices) const {
  TracedStep traced{step, static_cast<double>(step) * step_size, 0};
  // Clocks only go forward: in the runs before one without this step or later ones there is none.
  for (int run = recorder_.runs() - 1; run >= 0; --run) {
    std::int64_t latest = -1;
    for (const Place& place : places_of(run)) {
      latest = std::max(latest, place.step);
      if (place.step == step) traced.passes = std::max(traced.passes, place.pass + 1);
    }
    if (latest >= 0 && latest < step) break;
    add_slices(
        run, [step](const Place& place) { return place.step == step; }, slices);
  }
  sort_by_begin(slices);
  return traced;
}

void StepRecording::collect(double step_size, StepTrace& trace) const {
  trace.steps = find_steps(step_size);
  trace.dropped_steps = std::count(dropped_.begin(), dropped_.end(), char{1});
  trace.threads = recorder_.threads();
  trace.recording_cost = graph::time_stamp_scale().cost;
  if (recorder_.runs() == 0) return;
  const Nanoseconds nanoseconds(recorder_.run(0).begin);
  for (int run = 0; run < recorder_.runs(); ++run) {
    const auto& [begin, end] = recorder_.run(run);
    trace.runs.push_back({nanoseconds(begin), nanoseconds(end)});
    add_slices(
        run, [this](const Place& place) { return !is_dropped(place.step); }, trace.slices);
  }
  sort_by_begin(trace.slices);
}

TracedGraph describe_graph(const StepGraph& one_pass, const StepGraph& two_passes) {
  TracedGraph graph;
  graph.subsystem_word = one_pass.subsystem_word();
  for (int i = 0; i < one_pass.node_count(); ++i) {
    graph.labels.push_back(one_pass.node({i}).label);
    graph.names.push_back(one_pass.name_of({i}));
    for (const NodeId next : one_pass.successors({i})) graph.edges.push_back({i, next.index});
  }
  NodeNumbers numbers;
  std::vector<int> number_of;
  for (const graph::Node& node : two_passes.nodes()) number_of.push_back(numbers.of(node.label));
  for (int i = 0; i < two_passes.node_count(); ++i)
    for (const NodeId next : two_passes.successors({i}))
      if (two_passes.node({i}).label.pass == 0 && two_passes.node(next).label.pass == 1)
        graph.next_pass_edges.push_back({number_of[static_cast<std::size_t>(i)],
                                         number_of[static_cast<std::size_t>(next.index)]});
  return graph;
}

}  // namespace spoke
