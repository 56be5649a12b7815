// Derives edges from declared reads and writes, and drops implied ones.

#include "graph/step_graph.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>
#include <utility>

#include "graph/structure/depth_first_order.h"
#include "graph/structure/index_of.h"
#include "graph/structure/reachability.h"
#include "graph/structure/transitive_reduction.h"
#include "spoke/error.h"

namespace spoke::graph {
namespace {

using NodeLists = std::vector<std::vector<NodeId>>;

template <class Id>
void sort_unique(std::vector<Id>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// The accesses to one part that a next access may have to wait for.
struct LatestAccesses {
  NodeId writer;                // last writer; index -1 = none yet
  std::vector<NodeId> readers;  // readers since that write
};

// Derives predecessors by sequential task flow: a node that reads a part waits for its last writer;
// a node that writes one waits for its last writer and for all nodes that have read it since.
NodeLists derive_predecessors(const std::vector<Node>& nodes, std::size_t part_count) {
  NodeLists predecessors(nodes.size());
  std::vector<LatestAccesses> latest(part_count);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const NodeId id{static_cast<int>(i)};
    for (const PartId part : nodes[i].reads) {
      const NodeId writer = latest[index_of(part)].writer;
      if (writer.index >= 0) predecessors[i].push_back(writer);
    }
    for (const PartId part : nodes[i].writes) {
      const LatestAccesses& before = latest[index_of(part)];
      if (before.writer.index >= 0) predecessors[i].push_back(before.writer);
      predecessors[i].insert(predecessors[i].end(), before.readers.begin(), before.readers.end());
    }
    for (const PartId part : nodes[i].reads) latest[index_of(part)].readers.push_back(id);
    for (const PartId part : nodes[i].writes) latest[index_of(part)] = {id, {}};
    sort_unique(predecessors[i]);
  }
  return predecessors;
}

NodeLists inverted(const NodeLists& lists) {
  NodeLists inverse(lists.size());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (const NodeId other : lists[i]) inverse[index_of(other)].push_back({static_cast<int>(i)});
  }
  return inverse;
}

CompressedRows<NodeId> compressed(const NodeLists& lists) {
  CompressedRows<NodeId> rows;
  for (const std::vector<NodeId>& list : lists) {
    rows.append(list);
    rows.end_row();
  }
  return rows;
}

struct Access {
  NodeId node;
  bool writes;
};

void require_different_names(const std::vector<Part>& parts) {
  std::vector<std::string_view> names;
  for (const Part& part : parts) names.push_back(part.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end())
    throw InputError("two parts are named \"" + std::string(*twice) +
                     "\", expected a name for each");
}

// `body_of`: by node the place of its body; nodes that repeat another one share its body, and its
// label but for the pass, so that few labels are compared.
void require_different_labels(const std::vector<Node>& nodes,
                              const std::vector<std::uint32_t>& body_of, const NodeNames& names) {
  using Task = std::tuple<std::string_view, int, int, std::string_view>;
  std::map<Task, std::uint64_t> numbers;
  std::vector<std::uint64_t> by_body;
  std::vector<std::pair<std::uint64_t, std::size_t>> labels;  // task and pass as a number, and node
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const NodeLabel& label = nodes[i].label;
    if (body_of[i] == by_body.size()) {
      const Task task{label.stage, label.subsystem, label.body, label.item};
      by_body.push_back(numbers.try_emplace(task, numbers.size()).first->second);
    }
    labels.emplace_back(by_body[body_of[i]] << 32 | static_cast<std::uint32_t>(label.pass), i);
  }
  std::sort(labels.begin(), labels.end());
  const auto twice =
      std::adjacent_find(labels.begin(), labels.end(),
                         [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != labels.end())
    throw InputError("two nodes are named \"" + name_of(nodes[twice->second].label, names) +
                     "\", expected a label for each");
}

std::vector<std::vector<Access>> accesses_by_part(const StepGraph& graph) {
  std::vector<std::vector<Access>> accesses(graph.parts().size());
  for (int i = 0; i < graph.node_count(); ++i) {
    const Node& node = graph.node({i});
    for (const PartId part : node.writes) accesses[index_of(part)].push_back({{i}, true});
    for (const PartId part : node.reads) accesses[index_of(part)].push_back({{i}, false});
  }
  return accesses;
}

}  // namespace

namespace {

/// Returns a name of a list, or a word with the number.
std::string named(const std::vector<std::string>& names, std::string_view word, int index) {
  if (std::cmp_less(index, names.size())) return names[static_cast<std::size_t>(index)];
  return std::string(word) + " " + std::to_string(index + 1);
}

}  // namespace

std::string NodeNames::of_subsystem(int subsystem) const {
  return named(subsystems, word, subsystem);
}

std::string NodeNames::of_body(int subsystem, int body) const {
  const bool has_names = subsystem >= 0 && std::cmp_less(subsystem, bodies.size());
  return named(has_names ? bodies[static_cast<std::size_t>(subsystem)] : std::vector<std::string>{},
               "body", body);
}

std::string name_of(const NodeLabel& label, const NodeNames& names) {
  std::string name;
  if (label.subsystem >= 0) name.append(names.of_subsystem(label.subsystem)).append(" / ");
  if (label.body >= 0) name.append(names.of_body(label.subsystem, label.body)).append(" / ");
  if (!label.item.empty()) name.append(label.item).append(" / ");
  name.append(label.stage);
  if (label.pass >= 0) name.append(" (pass ").append(std::to_string(label.pass + 1)).append(")");
  return name;
}

// This is not in the header, since spans of vectors take long to compile.
std::span<const Node> StepGraph::nodes() const { return nodes_; }
std::span<const Part> StepGraph::parts() const { return *parts_; }
std::span<const NodeId> StepGraph::serial_order() const { return serial_order_; }

std::string StepGraph::name_of(NodeId node) const {
  return graph::name_of(this->node(node).label, *names_);
}

StepGraphBuilder::StepGraphBuilder(std::string subsystem_word)
    : names_(std::make_shared<const NodeNames>(NodeNames{std::move(subsystem_word), {}, {}})) {}

StepGraphBuilder::StepGraphBuilder(std::shared_ptr<const NodeNames> names)
    : names_(std::move(names)) {
  assert(names_);
}

PartId StepGraphBuilder::add_part(std::string name, std::vector<std::span<std::byte>> memory,
                                  std::size_t record_size) {
  assert(!shared_);
  parts_.push_back({std::move(name), std::move(memory), record_size});
  return {static_cast<int>(parts_.size()) - 1};
}

void StepGraphBuilder::share_parts(std::shared_ptr<const std::vector<Part>> parts) {
  assert(parts && parts_.empty());
  shared_ = std::move(parts);
}

NodeId StepGraphBuilder::add_declared_node(Node node, std::function<void()> body) {
  for (auto* list : {&node.reads, &node.writes}) {
    sort_unique(*list);
    if (list->empty()) continue;
    if (list->front().index < 0 || list->back().index >= static_cast<int>(parts().size())) {
      throw InputError("node \"" + name_of(node.label, *names_) +
                       "\" declares a part that was not added");
    }
  }
  nodes_.push_back(std::move(node));
  body_of_.push_back(static_cast<std::uint32_t>(bodies_.size()));
  bodies_.push_back(std::move(body));
  return {static_cast<int>(nodes_.size()) - 1};
}

NodeId StepGraphBuilder::repeat_node(NodeId node, int pass) {
  assert(pass >= 0);
  Node copy = nodes_.at(index_of(node));
  copy.label.pass = pass;
  nodes_.push_back(std::move(copy));
  body_of_.push_back(body_of_[index_of(node)]);
  return {static_cast<int>(nodes_.size()) - 1};
}

StepGraph StepGraphBuilder::build() {
  if (!shared_) require_different_names(parts());
  require_different_labels(nodes_, body_of_, *names_);
  NodeLists predecessors = derive_predecessors(nodes_, parts().size());
  reduce_transitively(predecessors);

  StepGraph graph;
  graph.predecessors_ = compressed(predecessors);
  graph.successors_ = compressed(inverted(predecessors));
  graph.serial_order_ = depth_first_order<NodeId>(
      static_cast<int>(nodes_.size()), [&](NodeId node) { return graph.predecessors(node); },
      [&](NodeId node) { return graph.successors(node); });
  graph.nodes_ = std::exchange(nodes_, {});
  graph.parts_ = shared_ ? std::exchange(shared_, {})
                         : std::make_shared<const std::vector<Part>>(std::exchange(parts_, {}));
  graph.bodies_ = std::exchange(bodies_, {});
  graph.body_of_ = std::exchange(body_of_, {});
  graph.names_ = names_;
  assert(conflicts_are_ordered(graph));
  return graph;
}

bool conflicts_are_ordered(const StepGraph& graph) {
  Reachability descendants(graph.node_count());
  for (int i = graph.node_count(); i-- > 0;) {
    for (const NodeId successor : graph.successors({i})) {
      if (successor.index <= i) return false;
      descendants.absorb(i, successor.index);
    }
  }
  for (const std::vector<Access>& accesses : accesses_by_part(graph)) {
    for (const Access& writer : accesses) {
      if (!writer.writes) continue;
      for (const Access& other : accesses) {
        const auto [first, second] = std::minmax(writer.node.index, other.node.index);
        if (first != second && !descendants.contains(first, second)) return false;
      }
    }
  }
  return true;
}

}  // namespace spoke::graph
