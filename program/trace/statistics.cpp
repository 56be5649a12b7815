// Work, span, makespan and idle time of traced steps.

#include "program/trace/statistics.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>

#include "graph/calibrate/quantiles.h"
#include "graph/structure/index_of.h"

namespace spoke::trace {
namespace {

double seconds(std::int64_t nanoseconds) { return 1e-9 * static_cast<double>(nanoseconds); }
double duration(const NodeSlice& slice) { return seconds(slice.end - slice.begin); }

using graph::index_of;
using graph::median;

/// The slices of a step by which it is timed, gathered in one walk over all slices.
struct StepSlices {
  std::vector<double> durations;  // by pass and node; 0 for nodes that did not run
  std::int64_t begin = std::numeric_limits<std::int64_t>::max();
  std::int64_t end = 0;
};

std::map<std::int64_t, StepSlices> gather(const StepTrace& trace) {
  std::map<std::int64_t, StepSlices> steps;
  const std::size_t nodes = trace.graph.labels.size();
  for (const TracedStep& step : trace.steps)
    steps[step.step].durations.resize(nodes * index_of(step.passes));
  for (const NodeSlice& slice : trace.slices) {
    const auto found = steps.find(slice.step);
    if (found == steps.end()) continue;
    StepSlices& step = found->second;
    step.durations[index_of(slice.pass) * nodes + index_of(slice.node)] += duration(slice);
    step.begin = std::min(step.begin, slice.begin);
    step.end = std::max(step.end, slice.end);
  }
  return steps;
}

/// Finds the span. Nodes are in a topological order, and passes follow each other.
double find_span(const TracedGraph& graph, const std::vector<double>& durations) {
  const std::size_t nodes = graph.labels.size();
  std::vector<std::vector<int>> before(nodes), in_pass_before(nodes);
  for (const NodeEdge& edge : graph.edges) before[index_of(edge.to)].push_back(edge.from);
  for (const NodeEdge& edge : graph.next_pass_edges)
    in_pass_before[index_of(edge.to)].push_back(edge.from);
  std::vector<double> ends(durations.size());
  double span = 0.0;
  for (std::size_t k = 0; k < durations.size(); ++k) {
    const std::size_t pass = k / nodes, node = k % nodes;
    double begin = 0.0;
    for (const int from : before[node])
      begin = std::max(begin, ends[pass * nodes + index_of(from)]);
    if (pass > 0)
      for (const int from : in_pass_before[node])
        begin = std::max(begin, ends[(pass - 1) * nodes + index_of(from)]);
    ends[k] = begin + durations[k];
    span = std::max(span, ends[k]);
  }
  return span;
}

}  // namespace

std::vector<StepTimes> time_steps(const StepTrace& trace) {
  std::vector<StepTimes> times;
  for (const auto& [number, step] : gather(trace))
    times.push_back({number, std::accumulate(step.durations.begin(), step.durations.end(), 0.0),
                     find_span(trace.graph, step.durations), seconds(step.end - step.begin)});
  return times;
}

bool overlap(const StepTrace& trace) {
  std::int64_t end = 0;
  for (const auto& [number, step] : gather(trace)) {
    if (step.begin < end) return true;
    end = step.end;
  }
  return false;
}

double bound_at_capacity(const StepTrace& trace, const Summary& summary, const Capacity& capacity) {
  assert(capacity.is_known());
  return capacity.bound(summary.work, overlap(trace) ? 0.0 : summary.span, trace.threads);
}

Summary summarise(const StepTrace& trace) {
  assert(!trace.steps.empty());
  const std::vector<StepTimes> times = time_steps(trace);
  std::vector<double> works, spans, makespans;
  for (const StepTimes& step : times) {
    works.push_back(step.work);
    spans.push_back(step.span);
    makespans.push_back(step.makespan);
  }
  Summary summary{.work = median(works), .span = median(spans), .elapsed = median(makespans)};
  summary.bound = std::max(summary.work / trace.threads, summary.span);
  double busy = std::accumulate(works.begin(), works.end(), 0.0);
  double available = trace.threads * std::accumulate(makespans.begin(), makespans.end(), 0.0);
  summary.speedup = summary.work / summary.elapsed;
  if (overlap(trace)) {
    const auto steps = gather(trace);
    std::int64_t begin = steps.begin()->second.begin, end = 0;
    for (const auto& [number, step] : steps) {
      begin = std::min(begin, step.begin);
      end = std::max(end, step.end);
    }
    available = trace.threads * seconds(end - begin);
    summary.elapsed = seconds(end - begin) / static_cast<double>(times.size());
    summary.bound = summary.work / trace.threads;
    summary.speedup = busy / static_cast<double>(times.size()) / summary.elapsed;
  }
  summary.idle = std::max(0.0, 1.0 - busy / available);
  return summary;
}

std::vector<double> mean_costs(const StepTrace& trace) {
  std::vector<double> sums(trace.graph.labels.size()), counts(sums.size());
  for (const NodeSlice& slice : trace.slices) {
    if (slice.step < 0) continue;
    sums[index_of(slice.node)] += duration(slice);
    counts[index_of(slice.node)] += 1.0;
  }
  for (std::size_t node = 0; node < sums.size(); ++node)
    if (counts[node] > 0.0) sums[node] /= counts[node];
  return sums;
}

std::vector<double> time_shares(const StepTrace& trace) {
  std::vector<double> shares(trace.graph.labels.size());
  double all = 0.0;
  for (const NodeSlice& slice : trace.slices) {
    if (slice.step < 0) continue;
    shares[index_of(slice.node)] += duration(slice);
    all += duration(slice);
  }
  for (double& share : shares) share = all > 0.0 ? share / all : 0.0;
  return shares;
}

std::vector<int> longest_path(const std::vector<NodeEdge>& edges,
                              const std::vector<double>& costs) {
  std::vector<std::vector<int>> next(costs.size());
  std::vector<int> waiting(costs.size()), ready, before(costs.size(), -1);
  for (const NodeEdge& edge : edges) {
    next[index_of(edge.from)].push_back(edge.to);
    ++waiting[index_of(edge.to)];
  }
  for (std::size_t node = 0; node < costs.size(); ++node)
    if (waiting[node] == 0) ready.push_back(static_cast<int>(node));
  std::vector<double> ends = costs;
  for (std::size_t k = 0; k < ready.size(); ++k) {
    const int node = ready[k];
    for (const int successor : next[index_of(node)]) {
      const double end = ends[index_of(node)] + costs[index_of(successor)];
      if (before[index_of(successor)] < 0 || end > ends[index_of(successor)]) {
        ends[index_of(successor)] = end;
        before[index_of(successor)] = node;
      }
      if (--waiting[index_of(successor)] == 0) ready.push_back(successor);
    }
  }
  std::vector<int> path;
  if (costs.empty()) return path;
  for (int node = static_cast<int>(std::max_element(ends.begin(), ends.end()) - ends.begin());
       node >= 0; node = before[index_of(node)])
    path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace spoke::trace
