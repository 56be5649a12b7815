// From the numbers of a mesh file to indices of nodes.

#include "models/solid/mesh_parts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "models/solid/mesh_text.h"

namespace spoke::solid {
namespace {

using spatial::SolidElement;
using spatial::SolidFace;

/// Translates numbers of nodes of an element into indices of the list.
void find_nodes(std::span<int> nodes, const LabelIndex& index, const std::string& file, int line) {
  for (int& node : nodes) {
    const int found = index.find(node);
    if (found < 0)
      refuse_mesh(file, line,
                  "an element names node " + std::to_string(node) +
                      ", which the file does not have, expected the number of a node");
    node = found;
  }
}

[[noreturn]] void refuse_loose(const std::string& file, int line, const std::string& what,
                               const char* kind) {
  refuse_mesh(file, line,
              what + " has a node of no volume element, expected places of the body: " + kind +
                  " are not built");
}

/// Refuses lines that are not on volumes.
void check_lines(const std::vector<FileLine>& lines, const LabelIndex& index,
                 const std::vector<int>& place, const std::string& file) {
  for (const FileLine& line : lines) {
    std::array<int, 2> ends = line.ends;
    find_nodes(ends, index, file, line.line);
    for (const int node : ends)
      if (place[static_cast<std::size_t>(node)] < 0)
        refuse_loose(file, line.line, "a line of a physical group", "beams");
  }
}

/// Makes point masses, whose nodes must be those of elements.
std::vector<spatial::SolidNodeMass> make_masses(const std::vector<FileMass>& masses,
                                                const LabelIndex& index,
                                                const std::vector<int>& place,
                                                const std::string& file, double length_scale) {
  std::vector<spatial::SolidNodeMass> made;
  for (const FileMass& mass : masses) {
    std::array<int, 1> node{mass.node};
    find_nodes(node, index, file, mass.line);
    const int at = place[static_cast<std::size_t>(node[0])];
    if (at < 0)
      refuse_mesh(file, mass.line,
                  "a point mass is at node " + std::to_string(mass.node) +
                      ", which no volume element has, expected a node of one (or a rigid body on "
                      "an interface)");
    if (length_scale != 1.0)
      refuse_mesh(file, mass.line,
                  "a point mass is in a file with scale.length, so that its unit is not known, "
                  "expected a file in SI units (or a rigid body on an interface)");
    made.push_back({at, mass.mass});
  }
  return made;
}

/// Makes a set of indices of the mesh from one of indices of the list.
spatial::SolidNodeSet make_set(FileSet&& set, const LabelIndex& index,
                               const std::vector<int>& place, const std::string& file) {
  spatial::SolidNodeSet made;
  made.name = std::move(set.name);
  for (const int label : set.nodes) {
    const int found = index.find(label);
    if (found >= 0 && place[static_cast<std::size_t>(found)] >= 0)
      made.nodes.push_back(place[static_cast<std::size_t>(found)]);
  }
  for (std::size_t f = 0; f < set.faces.size(); ++f) {
    SolidFace face = set.faces[f];
    const std::span nodes(face.nodes.data(), static_cast<std::size_t>(face.count));
    find_nodes(nodes, index, file, set.face_lines[f]);
    for (int& node : nodes) node = place[static_cast<std::size_t>(node)];
    if (std::any_of(nodes.begin(), nodes.end(), [](int node) { return node < 0; }))
      refuse_loose(file, set.face_lines[f], "a face of the set " + show_text(made.name), "shells");
    made.nodes.insert(made.nodes.end(), nodes.begin(), nodes.end());
    made.faces.push_back(face);
  }
  std::sort(made.nodes.begin(), made.nodes.end());
  made.nodes.erase(std::unique(made.nodes.begin(), made.nodes.end()), made.nodes.end());
  return made;
}

}  // namespace

LabelIndex::LabelIndex(const std::vector<int>& labels) : labels_(labels), order_(labels.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  const auto label_of = [&](int at) { return labels_[static_cast<std::size_t>(at)]; };
  if (!std::is_sorted(labels.begin(), labels.end()))
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return label_of(a) < label_of(b); });
  for (std::size_t k = 1; k < order_.size() && repeated_ < 0; ++k)
    if (label_of(order_[k]) == label_of(order_[k - 1])) repeated_ = order_[k];
  if (labels.empty()) return;
  const auto largest = static_cast<std::size_t>(label_of(order_.back()));
  if (largest > 4 * labels.size() + 1000) return;
  dense_.assign(largest + 1, -1);
  for (std::size_t k = order_.size(); k-- > 0;)
    dense_[static_cast<std::size_t>(label_of(order_[k]))] = order_[k];
}

std::size_t LabelIndex::lower_bound(int label) const {
  const auto found = std::lower_bound(
      order_.begin(), order_.end(), label,
      [&](int at, int searched) { return labels_[static_cast<std::size_t>(at)] < searched; });
  return static_cast<std::size_t>(found - order_.begin());
}

int LabelIndex::find(int label) const {
  if (!dense_.empty()) {
    const auto at = static_cast<std::size_t>(label);
    return label >= 0 && at < dense_.size() ? dense_[at] : -1;
  }
  const std::size_t at = lower_bound(label);
  if (at == order_.size() || labels_[static_cast<std::size_t>(order_[at])] != label) return -1;
  return order_[at];
}

void check_repeated(const LabelIndex& index, const std::vector<int>& labels,
                    const std::vector<int>& lines, const char* item, const std::string& file) {
  if (index.repeated() < 0) return;
  const auto again = static_cast<std::size_t>(index.repeated());
  refuse_mesh(file, lines[again],
              std::string(item) + ' ' + std::to_string(labels[again]) +
                  " is there a second time, expected each number once");
}

std::shared_ptr<spatial::SolidMesh> assemble_mesh(MeshParts&& parts, const std::string& file,
                                                  double length_scale) {
  const LabelIndex index(parts.labels);
  check_repeated(index, parts.labels, parts.node_lines, "node", file);
  auto mesh = std::make_shared<spatial::SolidMesh>();
  mesh->file = file;
  mesh->elements = std::move(parts.elements);
  // Index in the mesh by that of the list; -1: it is left out.
  std::vector<int> place(parts.labels.size(), mesh->elements.empty() ? 0 : -1);
  for (SolidElement& element : mesh->elements) {
    const std::span nodes(element.nodes.data(),
                          static_cast<std::size_t>(count_nodes(element.kind)));
    find_nodes(nodes, index, file, element.line);
    for (const int node : nodes) place[static_cast<std::size_t>(node)] = 0;
  }
  for (const int at : index.ascending()) {
    int& node = place[static_cast<std::size_t>(at)];
    if (node < 0) continue;
    node = static_cast<int>(mesh->nodes.size());
    mesh->nodes.push_back(length_scale * parts.nodes[static_cast<std::size_t>(at)]);
    mesh->labels.push_back(parts.labels[static_cast<std::size_t>(at)]);
  }
  for (SolidElement& element : mesh->elements)
    for (int n = 0; n < count_nodes(element.kind); ++n) {
      int& node = element.nodes[static_cast<std::size_t>(n)];
      node = place[static_cast<std::size_t>(node)];
    }
  for (FileSet& set : parts.sets)
    mesh->sets.push_back(make_set(std::move(set), index, place, file));
  check_lines(parts.lines, index, place, file);
  mesh->masses = make_masses(parts.masses, index, place, file, length_scale);
  mesh->left_out = std::move(parts.left_out);
  mesh->material_fault = std::move(parts.material_fault);
  return mesh;
}

}  // namespace spoke::solid
