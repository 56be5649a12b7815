// Derives levels by the longest path, shares of threads, and the barriers that can be left out.

#include "graph/plan/level_rounds.h"

#include <algorithm>
#include <cassert>

#include "graph/plan/static_share.h"
#include "graph/structure/index_of.h"

namespace spoke::graph {
namespace {

std::vector<std::vector<NodeId>> nodes_by_level(const StepGraph& graph) {
  std::vector<std::vector<NodeId>> levels;
  std::vector<std::size_t> level_of(static_cast<std::size_t>(graph.node_count()), 0);
  for (int i = 0; i < graph.node_count(); ++i) {
    std::size_t& level = level_of[static_cast<std::size_t>(i)];
    for (const NodeId before : graph.predecessors({i}))
      level = std::max(level, level_of[index_of(before)] + 1);
    if (level >= levels.size()) levels.resize(level + 1);
    levels[level].push_back({i});
  }
  return levels;
}

}  // namespace

std::vector<Round> derive_level_rounds(const StepGraph& graph, int threads) {
  assert(threads >= 1);
  struct Place {
    std::size_t round;
    int thread;
  };
  std::vector<Place> places(static_cast<std::size_t>(graph.node_count()));
  std::vector<Round> rounds;
  for (const auto& level : nodes_by_level(graph)) {
    bool needs_barrier = rounds.empty();
    for (int thread = 0; thread < threads; ++thread) {
      const StaticShare share = static_share(level.size(), thread, threads);
      for (std::size_t k = share.begin; k < share.end; ++k) {
        places[index_of(level[k])].thread = thread;
        for (const NodeId before : graph.predecessors(level[k])) {
          const Place& place = places[index_of(before)];
          needs_barrier |= place.round + 1 == rounds.size() && place.thread != thread;
        }
      }
    }
    if (needs_barrier) rounds.emplace_back(static_cast<std::size_t>(threads));
    for (const NodeId node : level) {
      Place& place = places[index_of(node)];
      place.round = rounds.size() - 1;
      rounds.back()[static_cast<std::size_t>(place.thread)].push_back(node);
    }
  }
  return rounds;
}

bool ends_alone(const std::vector<Round>& rounds) {
  if (rounds.size() < 2) return false;  // no barrier
  const Round& last = rounds.back();
  return std::all_of(last.begin() + 1, last.end(), [](const auto& nodes) { return nodes.empty(); });
}

}  // namespace spoke::graph
