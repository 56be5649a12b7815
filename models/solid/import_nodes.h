#pragma once

// The places of nodes that matrices of other programs belong to.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

/// A table of nodes, in the order of its file.
class NodeTable {
 public:
  /// Reads a table: of an .inp or .msh file its nodes and sets, else of lines "x y z" or
  /// "label x y z". Lengths are multiplied by `length_scale`. Throws InputError, its text
  /// "file:line: what is wrong, what is expected".
  NodeTable(const std::string& file, double length_scale);

  int size() const { return static_cast<int>(mesh_.nodes.size()); }
  /// Nodes, labels and sets; no elements.
  const spatial::SolidMesh& mesh() const { return mesh_; }
  int label(int node) const { return mesh_.labels[static_cast<std::size_t>(node)]; }
  /// Returns the index of a node; -1: there is none of this label.
  int find(std::int64_t label) const;
  /// Returns the nodes in the order of their labels.
  std::vector<int> by_label() const;
  /// Returns the table of some of its nodes; `used` by node.
  std::shared_ptr<const spatial::SolidMesh> select(const std::vector<char>& used) const;

 private:
  spatial::SolidMesh mesh_;
  std::unordered_map<std::int64_t, int> index_;
};

}  // namespace spoke::solid
