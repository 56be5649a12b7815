#pragma once

// The step graph: nodes, the parts they read and write, and the edges that follow.

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
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
  int index = -1;  ///< place in the order of insertion
  /// Orders handles by index.
  friend auto operator<=>(const NodeId&, const NodeId&) = default;
};

/// A node's coordinates: its task, its subsystem and body, and its pass (0-based, -1 = none). No
/// two nodes of a pass have the same ones.
struct NodeLabel {
  std::string stage;   ///< task of the node
  int subsystem = -1;  ///< index of its subsystem; -1: none
  int body = -1;       ///< index of its body within the subsystem
  int pass = -1;       ///< pass, if there are several
  std::string item{};  ///< name of what else of the subsystem it is for; empty: nothing
};

/// What subsystems and their bodies are called in the names of nodes: by number, counted from 1,
/// where they have no names.
struct SPOKE_EXPORT NodeNames {
  std::string word = "subsystem";                ///< for a subsystem
  std::vector<std::string> subsystems;           ///< names by index
  std::vector<std::vector<std::string>> bodies;  ///< names by index, of subsystems by index

  std::string of_subsystem(int subsystem) const;       ///< "front_left", or "subsystem 2"
  std::string of_body(int subsystem, int body) const;  ///< "upper arm", or "body 3"
};

/// Returns a node's name for people: "subsystem 2 / body 3 / inverse", "subsystem 2 / rod / loop
/// columns" for one of an item, or "hub solve" for a node of no subsystem and no body; one of
/// several passes ends in " (pass 4)".
SPOKE_EXPORT std::string name_of(const NodeLabel& label, const NodeNames& names = {});
/// Returns it with another word for a subsystem.
inline std::string name_of(const NodeLabel& label, std::string_view subsystem_word) {
  return name_of(label, NodeNames{std::string(subsystem_word), {}, {}});
}

/// A part of the step's data: one or several ranges of memory under one name.
struct Part {
  std::string name;                          ///< for people
  std::vector<std::span<std::byte>> memory;  ///< ranges of memory
  std::size_t record_size = 0;  ///< bytes of a record, if each node accesses one of many; 0: all
};

/// A node as it was declared. `reads` and `writes` are sorted and free of repetitions; a part that
/// is updated in place is in both.
struct Node {
  NodeLabel label;             ///< its coordinates
  std::vector<PartId> reads;   ///< parts that it needs
  std::vector<PartId> writes;  ///< parts that it changes
};

/// One integration step as a graph of nodes, immutable. Its edges follow from the declared reads
/// and writes in the order of insertion, and are transitively reduced. StepGraphBuilder makes it;
/// an Executor runs it (graph/executor.h).
class SPOKE_EXPORT StepGraph {
 public:
  int node_count() const { return static_cast<int>(nodes_.size()); }  ///< nodes of all passes
  /// Returns the number of edges, implied ones left out.
  int edge_count() const { return static_cast<int>(successors_.size()); }

  /// Returns all nodes in the order of insertion, which is a topological order.
  std::span<const Node> nodes() const;
  /// Returns one of the nodes.
  const Node& node(NodeId id) const { return nodes_[static_cast<std::size_t>(id.index)]; }
  /// Returns the parts that nodes read and write, in the order of addition.
  std::span<const Part> parts() const;
  /// Returns one of the parts.
  const Part& part(PartId id) const { return (*parts_)[static_cast<std::size_t>(id.index)]; }

  /// Returns the nodes that wait for `node`, ascending, without implied edges.
  std::span<const NodeId> successors(NodeId node) const {
    return successors_.row(static_cast<std::size_t>(node.index));
  }
  /// Returns the nodes that `node` waits for, ascending, without implied edges.
  std::span<const NodeId> predecessors(NodeId node) const {
    return predecessors_.row(static_cast<std::size_t>(node.index));
  }

  /// Returns a topological order for one thread, depth first: a node is followed by the nodes it
  /// made ready, so that one subsystem is worked on while its data are in cache.
  std::span<const NodeId> serial_order() const;

  /// Returns the name of the node for people, e.g. "subsystem 2 / body 3 / inverse".
  std::string name_of(NodeId node) const;
  /// Returns the word for a subsystem in the names of nodes that have no name of their own.
  const std::string& subsystem_word() const { return names_->word; }
  /// Returns what subsystems and bodies are called in the names of nodes.
  const std::shared_ptr<const NodeNames>& names() const { return names_; }

  /// Runs the body of one node, whose predecessors must have run.
  void run_node(NodeId node) const noexcept {
    bodies_[body_of_[static_cast<std::size_t>(node.index)]]();
  }

 private:
  friend class StepGraphBuilder;
  StepGraph() = default;

  // Nodes that repeat another node share its body: a graph of many passes stays small in cache.
  std::vector<std::function<void()>> bodies_;
  std::vector<std::uint32_t> body_of_;  // place of each node's body in bodies_
  CompressedRows<NodeId> successors_;   // per node
  CompressedRows<NodeId> predecessors_;
  std::vector<NodeId> serial_order_;
  std::vector<Node> nodes_;
  std::shared_ptr<const std::vector<Part>> parts_;
  std::shared_ptr<const NodeNames> names_;
};

/// Collects parts and nodes in the order of the algorithm, then builds the graph.
class SPOKE_EXPORT StepGraphBuilder {
 public:
  /// `subsystem_word`: the word for a subsystem in the names of nodes.
  explicit StepGraphBuilder(std::string subsystem_word = "subsystem");
  /// `names`: what subsystems and bodies are called, shared with the graphs.
  explicit StepGraphBuilder(std::shared_ptr<const NodeNames> names);

  /// Adds a part, whose name no other one has. Its memory must outlive the graph and stay where it
  /// is; ranges of different parts must not overlap (see bytes_of()). The ranges serve
  /// check_declarations(); no edge is derived from them. `record_size`: see Part.
  PartId add_part(std::string name, std::vector<std::span<std::byte>> memory,
                  std::size_t record_size = 0);
  /// Takes parts that graphs share, in the place of parts of its own: their handles are their
  /// places, and some may have one name. Precondition: no part was added, and none will be.
  void share_parts(std::shared_ptr<const std::vector<Part>> parts);

  /// Adds a node that runs `body`, a copyable, nothrow `void()`. It sees every part as left by the
  /// nodes added before it. Throws InputError at a part this builder does not know.
  template <class Body>
  NodeId add_node(NodeLabel label, Reads reads, Writes writes, Body&& body) {
    static_assert(std::is_nothrow_invocable_v<std::decay_t<Body>&>,
                  "the body of a node takes no argument and is noexcept");
    return add_declared_node({std::move(label), std::move(reads.parts), std::move(writes.parts)},
                             std::forward<Body>(body));
  }

  /// Adds a node that updates parts in place, and writes others or none.
  template <class Body>
  NodeId add_node(NodeLabel label, Reads reads, Updates updates, Writes writes, Body&& body) {
    add_to(reads.parts, updates.parts);
    add_to(writes.parts, updates.parts);
    return add_node(std::move(label), std::move(reads), std::move(writes),
                    std::forward<Body>(body));
  }
  template <std::same_as<Updates> Changes, class Body>  // braces alone mean writes
  NodeId add_node(NodeLabel label, Reads reads, Changes updates, Body&& body) {
    return add_node(std::move(label), std::move(reads), std::move(updates), Writes{},
                    std::forward<Body>(body));
  }

  /// Adds a node that repeats `node` in pass `pass`: with its body, declaration and label except
  /// for the pass.
  NodeId repeat_node(NodeId node, int pass);

  /// Returns the number of nodes added so far.
  int node_count() const { return static_cast<int>(nodes_.size()); }

  /// Builds the graph of everything added; the builder is empty afterwards. Throws InputError if
  /// two parts have one name, or two nodes of a pass one label; the builder then stays as it is.
  StepGraph build();

 private:
  NodeId add_declared_node(Node node, std::function<void()> body);
  const std::vector<Part>& parts() const { return shared_ ? *shared_ : parts_; }

  std::shared_ptr<const NodeNames> names_;
  std::vector<Part> parts_;
  std::shared_ptr<const std::vector<Part>> shared_;  ///< in their place; null: none
  std::vector<Node> nodes_;
  std::vector<std::function<void()>> bodies_;
  std::vector<std::uint32_t> body_of_;
};

/// Returns whether, of every two nodes that access one part, one of them writing, the one added
/// first comes first along the edges. It is computed from edges and declarations alone, not
/// from how the edges were derived. It holds for every graph that a builder makes.
SPOKE_EXPORT bool conflicts_are_ordered(const StepGraph& graph);

}  // namespace spoke::graph
