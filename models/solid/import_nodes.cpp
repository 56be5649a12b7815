// Reads tables of nodes.

#include "models/solid/import_nodes.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "models/solid/import_text.h"
#include "models/solid/parse_mesh.h"
#include "spoke/error.h"

namespace spoke::solid {
namespace {

constexpr int kLargestLabel = 2'000'000'000;

/// Reads lines "x y z" or "label x y z"; those that begin with #, %, ! or * are comments.
spatial::SolidMesh read_plain_table(const std::string& file, double length_scale) {
  constexpr std::string_view kExpected =
      "expected \"x y z\" in every line of the table, or \"label x y z\" in every line";
  NumberText text(file, "nodes");
  spatial::SolidMesh mesh;
  mesh.file = file;
  std::size_t columns = 0;
  while (text.next()) {
    if (std::string_view("#%!*").find(text.line().front()) != std::string_view::npos) continue;
    const std::size_t count = text.fields().size();
    if (columns == 0 && (count == 3 || count == 4)) columns = count;
    if (count != columns)
      text.fail("has " + std::to_string(count) + (count == 1 ? " field, " : " fields, ") +
                std::string(kExpected));
    std::int64_t label = std::ssize(mesh.nodes) + 1;
    if (columns == 4) label = text.whole(0);
    if (label < 1 || label > kLargestLabel)
      text.fail("the label " + std::to_string(label) + " is out of range, expected 1 to " +
                std::to_string(kLargestLabel));
    const std::size_t x = columns - 3;
    mesh.nodes.emplace_back(spatial::Vector(text.real(x), text.real(x + 1), text.real(x + 2)) *
                            length_scale);
    mesh.labels.push_back(static_cast<int>(label));
  }
  return mesh;
}

/// Errors of a mesh's file get the key that names it.
spatial::SolidMesh read_mesh_nodes(const std::string& file, double length_scale) {
  try {
    return *read_node_mesh(file, length_scale);
  } catch (const InputError& error) {
    throw InputError(error.what(), {.file = file, .line = error.place().line, .key = "nodes"});
  }
}

spatial::SolidMesh read_nodes(const std::string& file, double length_scale) {
  const std::string ending = in_small_letters(std::filesystem::path(file).extension().string());
  if (ending == ".inp" || ending == ".msh") return read_mesh_nodes(file, length_scale);
  if (ending == ".frd")
    fail_in_file(file, 0, "nodes",
                 "results of CalculiX hold six digits of the nodes' places, which are too few, "
                 "expected its .inp file");
  return read_plain_table(file, length_scale);
}

/// Keeps what a set has of nodes that stay; `now` is their new index, or -1.
spatial::SolidNodeSet select_set(const spatial::SolidNodeSet& set, const std::vector<int>& now) {
  const auto index = [&](int node) { return now[static_cast<std::size_t>(node)]; };
  spatial::SolidNodeSet kept{.name = set.name};
  for (const int node : set.nodes)
    if (index(node) >= 0) kept.nodes.push_back(index(node));
  for (spatial::SolidFace face : set.faces) {
    bool is_whole = true;
    for (int corner = 0; corner < face.count; ++corner) {
      int& node = face.nodes[static_cast<std::size_t>(corner)];
      node = index(node);
      is_whole = is_whole && node >= 0;
    }
    if (is_whole) kept.faces.push_back(face);
  }
  return kept;
}

}  // namespace

NodeTable::NodeTable(const std::string& file, double length_scale)
    : mesh_(read_nodes(file, length_scale)) {
  if (mesh_.nodes.empty()) fail_in_file(file, 0, "nodes", "has no nodes, expected their places");
  for (int node = 0; node < size(); ++node) {
    if (!index_.emplace(label(node), node).second)
      fail_in_file(file, 0, "nodes",
                   "has two nodes of label " + std::to_string(label(node)) +
                       ", expected one line for each node");
  }
}

int NodeTable::find(std::int64_t label) const {
  const auto found = index_.find(label);
  return found == index_.end() ? -1 : found->second;
}

std::vector<int> NodeTable::by_label() const {
  std::vector<int> order(mesh_.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return label(a) < label(b); });
  return order;
}

std::shared_ptr<const spatial::SolidMesh> NodeTable::select(const std::vector<char>& used) const {
  auto mesh = std::make_shared<spatial::SolidMesh>();
  mesh->file = mesh_.file;
  std::vector<int> now(mesh_.nodes.size(), -1);
  for (std::size_t node = 0; node < now.size(); ++node) {
    if (used[node] == 0) continue;
    now[node] = static_cast<int>(mesh->nodes.size());
    mesh->nodes.push_back(mesh_.nodes[node]);
    mesh->labels.push_back(mesh_.labels[node]);
  }
  for (const spatial::SolidNodeSet& set : mesh_.sets) mesh->sets.push_back(select_set(set, now));
  return mesh;
}

}  // namespace spoke::solid
