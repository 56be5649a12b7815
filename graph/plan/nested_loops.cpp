// Finds the loops from the nodes' coordinates and edges.

#include "graph/plan/nested_loops.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace spoke::graph {
namespace {

// One of the loops over subsystems while nodes are added to it in the order of insertion.
class SubsystemLoopBuilder {
 public:
  explicit SubsystemLoopBuilder(const StepGraph& graph)
      : graph_(graph), places_(static_cast<std::size_t>(graph.node_count())) {}

  // Adds the node, in a loop of its own if that of the nodes before it cannot take it.
  void add(NodeId node) {
    const NodeLabel& label = graph_.node(node).label;
    if (label.subsystem < 0) {
      if (!subsystems_.empty()) finish_loop();
      alone_.push_back(node);
      return;
    }
    if (waits_for_another_subsystem(node)) finish_loop();
    add_to(subsystems_[label.subsystem], node);
  }

  std::vector<SubsystemLoop> take_loops() {
    if (!alone_.empty() || !subsystems_.empty()) finish_loop();
    return std::move(loops_);
  }

 private:
  // A body, or an item of it: a slice of a large one.
  using BodyKey = std::pair<int, std::string>;
  static BodyKey key_of(const NodeLabel& label) { return {label.body, label.item}; }

  // A subsystem's share of the loop. Bodies are in ascending order, so that equal loops are shared
  // out equally.
  struct OpenBodyLoop {
    NodeChain alone;
    std::map<BodyKey, NodeChain> bodies;
  };
  using OpenSubsystem = std::vector<OpenBodyLoop>;

  // The place of a node: which loop over subsystems, and which over bodies in it (-1: alone).
  struct Place {
    std::size_t loop = 0;
    std::ptrdiff_t body_loop = -1;
  };
  Place& place_of(NodeId node) { return places_[static_cast<std::size_t>(node.index)]; }

  bool waits_for_another_subsystem(NodeId node) {
    const auto before = graph_.predecessors(node);
    return std::any_of(before.begin(), before.end(), [&](NodeId other) {
      const int subsystem = graph_.node(other).label.subsystem;
      return subsystem >= 0 && subsystem != graph_.node(node).label.subsystem &&
             place_of(other).loop == loops_.size();
    });
  }

  // Whether the node waits for one of another body or item in the given loop over bodies.
  bool waits_for_another_body(NodeId node, std::ptrdiff_t body_loop) {
    const NodeLabel& label = graph_.node(node).label;
    const auto before = graph_.predecessors(node);
    return std::any_of(before.begin(), before.end(), [&](NodeId other) {
      const NodeLabel& its = graph_.node(other).label;
      return its.subsystem == label.subsystem && its.body >= 0 && key_of(its) != key_of(label) &&
             place_of(other).loop == loops_.size() && place_of(other).body_loop == body_loop;
    });
  }

  void add_to(OpenSubsystem& subsystem, NodeId node) {
    const NodeLabel& label = graph_.node(node).label;
    const int body = label.body;
    const auto last = static_cast<std::ptrdiff_t>(subsystem.size()) - 1;
    const bool fits = last >= 0 && (body >= 0 ? !waits_for_another_body(node, last)
                                              : subsystem.back().bodies.empty());
    if (!fits) subsystem.emplace_back();
    NodeChain& chain = body >= 0 ? subsystem.back().bodies[key_of(label)] : subsystem.back().alone;
    chain.push_back(node);
    place_of(node) = {loops_.size(), static_cast<std::ptrdiff_t>(subsystem.size()) - 1};
  }

  void finish_loop() {
    SubsystemLoop& loop = loops_.emplace_back();
    loop.alone = std::exchange(alone_, {});
    for (auto& [index, open] : subsystems_) {
      SubsystemWork& work = loop.subsystems.emplace_back();
      for (OpenBodyLoop& open_loop : open) {
        BodyLoop& body_loop = work.emplace_back();
        body_loop.alone = std::move(open_loop.alone);
        for (auto& [body, chain] : open_loop.bodies) body_loop.bodies.push_back(std::move(chain));
      }
    }
    subsystems_.clear();
  }

  const StepGraph& graph_;
  std::vector<Place> places_;
  NodeChain alone_;
  std::map<int, OpenSubsystem> subsystems_;
  std::vector<SubsystemLoop> loops_;
};

}  // namespace

std::vector<SubsystemLoop> derive_nested_loops(const StepGraph& graph) {
  SubsystemLoopBuilder builder(graph);
  for (int i = 0; i < graph.node_count(); ++i) builder.add({i});
  return builder.take_loops();
}

}  // namespace spoke::graph
