#pragma once

// What a mesh file says, by the numbers that it gives to its nodes; and the mesh made of it.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "models/solid_body.h"

namespace spoke::solid {

/// Finds numbers in a list of them.
class LabelIndex {
 public:
  /// Numbers of 1 or more, in any order. Of equal ones the first is found.
  explicit LabelIndex(const std::vector<int>& labels);
  /// Returns the index of a number in the list; -1: it is not there.
  int find(int label) const;
  /// Returns the index of a number that is in the list a second time; -1: there is none.
  int repeated() const { return repeated_; }
  /// Returns the indices of the list in ascending order of their numbers.
  const std::vector<int>& ascending() const { return order_; }
  /// Returns the position in ascending() of the first number that is not less.
  std::size_t lower_bound(int label) const;

 private:
  const std::vector<int>& labels_;
  std::vector<int> order_;
  std::vector<int> dense_;  // index by number, if these have few gaps
  int repeated_ = -1;
};

/// Throws InputError if a number is in the list twice, with the line of the second; `item`: "node".
void check_repeated(const LabelIndex& index, const std::vector<int>& labels,
                    const std::vector<int>& lines, const char* item, const std::string& file);

/// A set of nodes as a file has it.
struct FileSet {
  std::string name;
  std::vector<int> nodes;  ///< numbers, in any order and repeated as it comes
  std::vector<spatial::SolidFace> faces;
  std::vector<int> face_lines;
};

/// A mass at a node.
struct FileMass {
  int node = 0;       ///< number of its node
  double mass = 0.0;  ///< in the file's unit
  int line = 0;
};
/// A line of a named group.
struct FileLine {
  std::array<int, 2> ends{};  ///< numbers of its first two nodes
  int line = 0;
};

/// Nodes, elements and sets as a file has them. Elements and sets name nodes by their numbers.
struct MeshParts {
  std::vector<int> labels;
  std::vector<spatial::Vector> nodes;
  std::vector<int> node_lines;
  std::vector<spatial::SolidElement> elements;
  std::vector<FileSet> sets;     ///< names differ
  std::vector<FileLine> lines;   ///< that must lie on volumes: of groups that may be meant as beams
  std::vector<FileMass> masses;  ///< several at one node add up
  std::vector<std::string> left_out;  ///< as in spatial::SolidMesh
  std::string material_fault;         ///< likewise
};

/// Makes a mesh: its nodes are those that elements use, or all if there are no elements, in
/// ascending order of their numbers; places times `length_scale`. Throws InputError, so of faces
/// and lines in sets and of masses at other nodes.
std::shared_ptr<spatial::SolidMesh> assemble_mesh(MeshParts&& parts, const std::string& file,
                                                  double length_scale);

}  // namespace spoke::solid
