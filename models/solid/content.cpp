#include "models/solid/content.h"

#include <array>
#include <fstream>
#include <string>

#include "models/support/hash_bytes.h"

namespace spoke::solid {
namespace {

/// A hash of values in their order.
class ContentHash {
 public:
  void add(const void* first, std::size_t size) { value_ = hash_bytes(first, size, value_); }
  void add(double number) { add(&number, sizeof number); }
  void add(std::size_t number) {
    const auto wide = static_cast<std::uint64_t>(number);
    add(&wide, sizeof wide);
  }
  /// Adds the numbers, and how many they are.
  template <class Integers>
  void add_all(const Integers& numbers, std::size_t count) {
    add(count);
    for (std::size_t i = 0; i < count; ++i) add(static_cast<std::size_t>(numbers[i]));
  }
  void add_text(const std::string& text) {
    add(text.size());
    add(text.data(), text.size());
  }
  void add_file(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    std::array<char, 65536> piece;
    while (file.read(piece.data(), piece.size()), file.gcount() > 0)
      add(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = hash_bytes(nullptr, 0);
};

void add_mesh(const spatial::SolidMesh& mesh, ContentHash& hash) {
  hash.add(mesh.nodes.size());
  for (const spatial::Vector& node : mesh.nodes)
    for (const double value : node) hash.add(value);
  for (const spatial::SolidElement& element : mesh.elements) {
    hash.add(static_cast<std::size_t>(element.kind));
    hash.add_all(element.nodes, static_cast<std::size_t>(count_nodes(element.kind)));
  }
  for (const auto& [node, mass] : mesh.masses) {
    hash.add(static_cast<std::size_t>(node));
    hash.add(mass);
  }
  for (const spatial::SolidNodeSet& set : mesh.sets) {
    hash.add_text(set.name);
    hash.add_all(set.nodes, set.nodes.size());
    for (const spatial::SolidFace& face : set.faces)
      hash.add_all(face.nodes, static_cast<std::size_t>(face.count));
  }
}

void add_files(const spatial::SolidMatrices& matrices, ContentHash& hash) {
  for (const std::string& name : {matrices.mass, matrices.stiffness, matrices.nodes})
    hash.add_file(name);
  for (const std::string& name : matrices.own) hash.add_file(name);
  for (const std::string& name : matrices.translation) hash.add_file(name);
}

}  // namespace

std::uint64_t hash_content(const spatial::SolidBody& body) {
  ContentHash hash;
  if (body.matrices)
    add_files(*body.matrices, hash);
  else if (body.mesh)
    add_mesh(*body.mesh, hash);
  return hash.value();
}

}  // namespace spoke::solid
