// Turns the records of runs into slices of steps and passes.

#include "engine/step/run/step_recording.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>

#include "engine/step/pass_integration.h"

namespace spoke {
namespace {

using graph::NodeId;
using graph::NodeLabel;
using graph::StepGraph;

std::size_t count_steps(const RecordingPlan& plan) {
  assert(plan.first_step <= plan.last_step + 1);
  return static_cast<std::size_t>(plan.last_step - plan.first_step + 1);
}

/// Numbers nodes of one pass in the order in which the graph lists them.
class NodeNumbers {
 public:
  int of(const NodeLabel& label) {
    const auto [place, is_new] = numbers_.try_emplace(
        {label.stage, label.subsystem, label.body, label.item}, static_cast<int>(numbers_.size()));
    return place->second;
  }

 private:
  std::map<std::tuple<std::string, int, int, std::string>, int> numbers_;
};

/// Converts ticks to nanoseconds since the start of the recording.
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

StepRecording::StepRecording(const StepGraph& run_graph, const StepTable& data,
                             const RecordingPlan& plan)
    : plan_(plan),
      passes_(count_passes(run_graph)),
      progress_count_(static_cast<int>(data.progress.size())),
      nodes_(run_graph.node_count()),
      room_(find_room()),
      recorder_(plan.threads, nodes_, room_),
      at_begin_(data.progress.size()),
      run_passes_(data.progress.size() * static_cast<std::size_t>(passes_)),
      all_passes_(room_.runs * run_passes_.size()),
      system_passes_(room_.runs),
      dropped_(count_steps(plan), 0) {
  find_origins(run_graph, data.is_coupled);
}

StepRecording::Needs StepRecording::find_needs() const {
  const auto threads = static_cast<std::size_t>(plan_.threads);
  const auto nodes = static_cast<std::size_t>(nodes_);
  const auto progress_count = static_cast<std::size_t>(progress_count_);
  const std::size_t pass_count = progress_count * static_cast<std::size_t>(passes_);
  Needs needs;
  needs.always = threads * sizeof(graph::NodeRecorder::Lane) + nodes * sizeof(Origin) +
                 (progress_count + pass_count) * sizeof(PassOfStep) + count_steps(plan_);
  needs.run = sizeof(graph::NodeRecorder::Run) + threads * sizeof(std::size_t) +
              (pass_count + 1) * sizeof(PassOfStep);
  needs.records = nodes * sizeof(graph::NodeRecord);
  return needs;
}

/// The slowest subsystem makes all passes of a run, unless it waits at the end of a window; some
/// runs more allow for that.
std::size_t StepRecording::count_most_runs() const {
  const std::size_t steps = count_steps(plan_);
  const std::size_t passes = steps * static_cast<std::size_t>(plan_.most_passes);
  return 8 + steps / 64 + passes / static_cast<std::size_t>(passes_);
}

/// Finds as much room as the buffer holds. Records of the runs that find a place may be for fewer,
/// if threads share the nodes unevenly.
graph::RecorderRoom StepRecording::find_room() const {
  const Needs needs = find_needs();
  if (plan_.buffer_bytes <= needs.always) return {};
  const std::size_t bytes = plan_.buffer_bytes - needs.always;
  const std::size_t runs = std::min(count_most_runs(), bytes / (needs.run + needs.records));
  return graph::make_room(runs, nodes_, plan_.threads, bytes - runs * needs.run);
}

/// Returns the bytes that are enough for so many runs, however the threads share the nodes.
std::size_t StepRecording::bytes_of(int runs) const {
  const Needs needs = find_needs();
  return needs.always + static_cast<std::size_t>(runs) * static_cast<std::size_t>(plan_.threads) *
                            (needs.run + needs.records);
}

int StepRecording::count_passes(const StepGraph& run_graph) {
  int last = 0;
  for (const graph::Node& node : run_graph.nodes()) last = std::max(last, node.label.pass);
  return last + 1;
}

void StepRecording::find_origins(const StepGraph& run_graph, bool is_coupled) {
  NodeNumbers numbers;
  origins_.reserve(static_cast<std::size_t>(nodes_));
  for (const graph::Node& node : run_graph.nodes()) {
    const NodeLabel& label = node.label;
    // In a coupled system all follow the only progress. Else the hub solve, of no subsystem,
    // follows none.
    const int progress = is_coupled ? 0 : label.subsystem;
    origins_.push_back({numbers.of(label), progress, std::max(label.pass, 0)});
  }
}

void StepRecording::begin_run(const StepTable& data) {
  for (std::size_t c = 0; c < at_begin_.size(); ++c)
    at_begin_[c] = {data.progress[c].step, data.progress[c].passes};
  complete_ = last_complete_step(data);
  recorder_.begin_run();
}

void StepRecording::end_run(const StepTable& data) {
  const bool is_recorded = recorder_.is_recording();
  recorder_.end_run();
  find_passes(data);
  if (is_recorded)
    keep_passes(data);
  else
    drop_steps();
  complete_ = last_complete_step(data);
  if (runs_of_first_ == 0 && complete_ >= plan_.first_step) runs_of_first_ = count_runs();
}

void StepRecording::keep_passes(const StepTable& data) {
  const auto run = static_cast<std::size_t>(recorder_.runs() - 1);
  std::copy(run_passes_.begin(), run_passes_.end(),
            all_passes_.begin() + static_cast<std::ptrdiff_t>(run * run_passes_.size()));
  system_passes_[run] = pass_of_all(data);
}

/// Each subsystem (coupled: the system) has gone pass by pass from where it stood at the begin to
/// where it stands now; the passes that the steps took that it completed on the way are in their
/// records.
void StepRecording::find_passes(const StepTable& data) {
  for (std::size_t c = 0; c < data.progress.size(); ++c) {
    const StepProgress& progress = data.progress[c];
    PassOfStep at = at_begin_[c];
    for (int pass = 0; pass < passes_; ++pass) {
      const bool is_there = at.step == progress.step && at.pass == progress.passes;
      run_passes_[c * static_cast<std::size_t>(passes_) + static_cast<std::size_t>(pass)] =
          is_there ? PassOfStep{} : at;
      // Another processor holds the records: they are looked at only for a next pass.
      if (is_there || pass + 1 == passes_) continue;
      ++at.pass;
      if (at.step < progress.step && at.pass == data.passes_of(c, at.step)) at = {at.step + 1, 0};
    }
  }
}

/// Returns the pass of the hub solve: that of all subsystems that made one, or else the last pass
/// of the last step that the run completed.
StepRecording::PassOfStep StepRecording::pass_of_all(const StepTable& data) const {
  if (passes_ == 1) {
    PassOfStep common;
    bool is_common = true;
    for (const PassOfStep& at : run_passes_) {
      if (at.step < 0) continue;
      if (common.step < 0) common = at;
      is_common = is_common && common.step == at.step && common.pass == at.pass;
    }
    if (is_common) return common;
  }
  const std::int64_t last = last_complete_step(data);
  if (last <= complete_) return {};
  return {last, static_cast<int>(data.most_passes_of(last)) - 1};
}

void StepRecording::drop_steps() {
  for (const PassOfStep& at : run_passes_)
    if (is_wanted(at.step)) dropped_[static_cast<std::size_t>(at.step - plan_.first_step)] = 1;
}

std::int64_t StepRecording::count_dropped() const {
  const std::int64_t made = std::min(complete_, plan_.last_step) - plan_.first_step + 1;
  return std::count(dropped_.begin(), dropped_.begin() + std::max<std::int64_t>(made, 0), char{1});
}

StepRecording::PassOfStep StepRecording::pass_of(const Origin& origin, int run) const {
  if (origin.progress < 0) return system_passes_[static_cast<std::size_t>(run)];
  return passes_in(run)[static_cast<std::size_t>(origin.progress * passes_ + origin.pass)];
}

std::vector<TracedStep> StepRecording::find_steps(double step_size) const {
  std::map<std::int64_t, int> passes;
  const auto used = static_cast<std::size_t>(recorder_.runs()) * run_passes_.size();
  for (std::size_t k = 0; k < used; ++k) {
    const PassOfStep& at = all_passes_[k];
    if (!is_recorded(at.step)) continue;
    int& most = passes[at.step];
    most = std::max(most, at.pass + 1);
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
      const PassOfStep at = pass_of(origin, run);
      if (wants(at))
        slices.push_back({origin.node, at.step, at.pass, record.cluster, thread,
                          nanoseconds(record.begin), nanoseconds(record.end)});
    }
}

TracedStep StepRecording::collect_step(std::int64_t step, double step_size,
                                       std::vector<NodeSlice>& slices) const {
  TracedStep traced{step, static_cast<double>(step) * step_size, 0};
  // Progress only goes forward: runs before one without this step or later ones have none of it
  // either.
  for (int run = recorder_.runs() - 1; run >= 0; --run) {
    std::int64_t latest = -1;
    for (const PassOfStep& at : passes_in(run)) {
      latest = std::max(latest, at.step);
      if (at.step == step) traced.passes = std::max(traced.passes, at.pass + 1);
    }
    if (latest >= 0 && latest < step) break;
    add_slices(
        run, [step](const PassOfStep& at) { return at.step == step; }, slices);
  }
  sort_by_begin(slices);
  return traced;
}

void StepRecording::collect(double step_size, StepTrace& trace) const {
  trace.steps = find_steps(step_size);
  trace.dropped_steps = count_dropped();
  trace.bytes_of_first = runs_of_first_ > 0 ? bytes_of(runs_of_first_) : 0;
  trace.bytes_of_all = bytes_of(count_runs());
  trace.threads = recorder_.threads();
  trace.recording_cost = graph::time_stamp_scale().cost;
  if (recorder_.runs() == 0) return;
  const Nanoseconds nanoseconds(recorder_.run(0).begin);
  for (int run = 0; run < recorder_.runs(); ++run) {
    const auto& [begin, end] = recorder_.run(run);
    trace.runs.push_back({nanoseconds(begin), nanoseconds(end)});
    add_slices(
        run, [this](const PassOfStep& at) { return at.step < 0 || is_recorded(at.step); },
        trace.slices);
  }
  sort_by_begin(trace.slices);
}

TracedGraph describe_graph(const StepGraph& one_pass, const StepGraph& two_passes) {
  TracedGraph graph;
  const graph::NodeNames& names = *one_pass.names();
  graph.subsystem_word = names.word;
  for (int i = 0; i < one_pass.node_count(); ++i) {
    const graph::NodeLabel& label = one_pass.node({i}).label;
    graph.labels.push_back(label);
    for (int k = static_cast<int>(graph.subsystems.size()); k <= label.subsystem; ++k)
      graph.subsystems.push_back(names.of_subsystem(k));
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
