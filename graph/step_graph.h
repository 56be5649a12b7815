#pragma once

// The step graph: nodes, what they read and write, and the edges that follow.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "graph/access.h"
#include "graph/compressed_rows.h"
#include "spoke/export.h"

namespace spoke::graph {

/// Handle of one node: its place in the order of insertion, 0-based.
struct NodeId {
  int index = -1;  ///< in the order of insertion
  /// By index.
  friend auto operator<=>(const NodeId&, const NodeId&) = default;
};

/// A node's coordinates: what it does, for which subsystem and body, and in which of several passes
/// (0-based, -1 = none).
struct NodeLabel {
  std::string stage;   ///< what it does
  int subsystem = -1;  ///< of which one; -1: of none
  int body = -1;       ///< of the subsystem
  int pass = -1;       ///< of several
};

/// A node's name for people, counted from 1: "subsystem 2 / body 3 / inverse", or "hub solve" for
/// a node of no subsystem and no body; one of several passes ends in " (pass 4)". `subsystem_word`
/// replaces "subsystem".
SPOKE_EXPORT std::string name_of(const NodeLabel& label,
                                 std::string_view subsystem_word = "subsystem");

/// A part of the step's data: one or several ranges of memory under one name.
struct Part {
  std::string name;                          ///< unique, for people
  std::vector<std::span<std::byte>> memory;  ///< where it lies
  std::size_t record_size = 0;  ///< bytes of a record, if a node touches one of many; 0: all
};

/// A node as it was declared. `reads` and `writes` are sorted and free of repetitions; a part in
/// both is updated in place.
struct Node {
  NodeLabel label;             ///< its coordinates
  std::vector<PartId> reads;   ///< what it needs
  std::vector<PartId> writes;  ///< what it changes
};

/// One integration step as a graph of nodes, immutable. Its edges follow from the declared reads
/// and writes in the order of insertion, and are transitively reduced. Made by StepGraphBuilder;
/// run by an Executor (graph/executor.h).
class SPOKE_EXPORT StepGraph {
 public:
  int node_count() const { return static_cast<int>(nodes_.size()); }  ///< of all passes
  /// Without implied edges.
  int edge_count() const { return static_cast<int>(successors_.size()); }

  /// All nodes in the order of insertion, which is a topological order.
  std::span<const Node> nodes() const;
  /// One of them.
  const Node& node(NodeId id) const { return nodes_[static_cast<std::size_t>(id.index)]; }
  /// What the nodes read and write, in the order of addition.
  std::span<const Part> parts() const;
  /// One of them.
  const Part& part(PartId id) const { return parts_[static_cast<std::size_t>(id.index)]; }

  /// The nodes that wait for `node`; ascending, without implied edges, as all these lists.
  std::span<const NodeId> successors(NodeId node) const {
    return successors_.row(static_cast<std::size_t>(node.index));
  }
  /// Those it waits for.
  std::span<const NodeId> predecessors(NodeId node) const {
    return predecessors_.row(static_cast<std::size_t>(node.index));
  }

  /// A topological order for one thread, depth first: a node is followed by what it made ready,
  /// so that one subsystem is worked on while its data are in cache.
  std::span<const NodeId> serial_order() const;

  /// The node's name for people, e.g. "blade 2 / body 3 / inverse".
  std::string name_of(NodeId node) const;
  /// What a subsystem is called in names, e.g. "blade".
  const std::string& subsystem_word() const { return subsystem_word_; }

  /// Runs the body of one node, whose predecessors must have run.
  void run_node(NodeId node) const noexcept {
    bodies_[body_of_[static_cast<std::size_t>(node.index)]]();
  }

 private:
  friend class StepGraphBuilder;
  StepGraph() = default;

  // Nodes that repeat another share its body: a graph of many passes stays small in cache.
  std::vector<std::function<void()>> bodies_;
  std::vector<std::uint32_t> body_of_;  // per node, its place in bodies_
  CompressedRows<NodeId> successors_;   // per node
  CompressedRows<NodeId> predecessors_;
  std::vector<NodeId> serial_order_;
  std::vector<Node> nodes_;
  std::vector<Part> parts_;
  std::string subsystem_word_;
};

/// Collects parts and nodes in the order of the algorithm, then builds the graph.
class SPOKE_EXPORT StepGraphBuilder {
 public:
  /// `subsystem_word`: what a subsystem is called in the names of nodes, e.g. "blade".
  explicit StepGraphBuilder(std::string subsystem_word = "subsystem");

  /// Adds a part. Its memory must outlive the graph and stay where it is; ranges of different parts
  /// must not overlap (see bytes_of()). The ranges serve check_declarations() of
  /// graph/declaration_check.h; no edge is derived from them. `record_size`: see Part.
  PartId add_part(std::string name, std::vector<std::span<std::byte>> memory,
                  std::size_t record_size = 0);

  /// Adds a node that runs `body`, a copyable, nothrow `void()`. It sees every part as left by the
  /// nodes added before it. Throws InputError at a part this builder does not know.
  template <class Body>
  NodeId add_node(NodeLabel label, Reads reads, Writes writes, Body&& body) {
    static_assert(std::is_nothrow_invocable_v<std::decay_t<Body>&>,
                  "the body of a node takes no argument and is noexcept");
    return add_declared_node({std::move(label), std::move(reads.parts), std::move(writes.parts)},
                             std::forward<Body>(body));
  }

  /// Adds a node that does in pass `pass` what `node` does: with its body and declaration, and its
  /// label but for the pass.
  NodeId repeat_node(NodeId node, int pass);

  /// Added so far.
  int node_count() const { return static_cast<int>(nodes_.size()); }

  /// Builds the graph of everything added; the builder is empty afterwards.
  StepGraph build();

 private:
  NodeId add_declared_node(Node node, std::function<void()> body);

  std::string subsystem_word_;
  std::vector<Part> parts_;
  std::vector<Node> nodes_;
  std::vector<std::function<void()>> bodies_;
  std::vector<std::uint32_t> body_of_;
};

/// Whether of every two nodes that access one part, one of them writing, the one added first comes
/// first along the edges. Computed from edges and declarations alone, not from how the edges were
/// derived. True of every graph a builder makes.
SPOKE_EXPORT bool conflicts_are_ordered(const StepGraph& graph);

}  // namespace spoke::graph
