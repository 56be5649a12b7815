// Files of meshes, after the manuals of gmsh and Abaqus.

#include "tests/models/solid/mesh_texts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

namespace spoke::test {
namespace {

using spatial::ElementKind;
using spatial::SolidElement;
using spatial::SolidFace;
using spatial::SolidMesh;

int label_of(const SolidMesh& mesh, int node) {
  return mesh.labels.empty() ? node + 1 : mesh.labels[static_cast<std::size_t>(node)];
}

// The edges of gmsh's elements in the order of their mid nodes (gmsh's manual, "Node ordering").
constexpr std::array<std::pair<int, int>, 6> kTetEdgesOfGmsh{
    {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}}};
constexpr std::array<std::pair<int, int>, 12> kHexEdgesOfGmsh{{{0, 1},
                                                               {0, 3},
                                                               {0, 4},
                                                               {1, 2},
                                                               {1, 5},
                                                               {2, 3},
                                                               {2, 6},
                                                               {3, 7},
                                                               {4, 5},
                                                               {4, 7},
                                                               {5, 6},
                                                               {6, 7}}};

/// Returns numbers of an element's nodes in gmsh's order: the mid node of an edge is the one that
/// is there.
std::vector<int> in_gmsh_order(const SolidMesh& mesh, const SolidElement& element) {
  const auto place = [&](int n) -> spatial::Vector {
    return mesh.nodes[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(n)])];
  };
  const bool is_tet = element.kind == ElementKind::tet4 || element.kind == ElementKind::tet10;
  const int corners = is_tet ? 4 : 8;
  std::vector<int> labels;
  for (int n = 0; n < corners; ++n)
    labels.push_back(label_of(mesh, element.nodes[static_cast<std::size_t>(n)]));
  if (count_nodes(element.kind) == corners) return labels;
  const auto add = [&](const auto& edges) {
    for (const auto& [a, b] : edges) {
      const auto middle = (0.5 * (place(a) + place(b))).eval();
      const auto distance = [&](int m) { return (place(m) - middle).norm(); };
      int nearest = corners;
      for (int n = corners; n < count_nodes(element.kind); ++n) {
        if (distance(n) < distance(nearest)) nearest = n;
      }
      labels.push_back(label_of(mesh, element.nodes[static_cast<std::size_t>(nearest)]));
    }
  };
  if (is_tet)
    add(kTetEdgesOfGmsh);
  else
    add(kHexEdgesOfGmsh);
  return labels;
}

int gmsh_type(ElementKind kind) {
  return kind == ElementKind::tet4    ? 4
         : kind == ElementKind::tet10 ? 11
         : kind == ElementKind::hex8  ? 5
                                      : 17;
}
int gmsh_type(const SolidFace& face) {
  return face.count == 3 ? 2 : face.count == 6 ? 9 : face.count == 4 ? 3 : 16;
}

/// Writes numbers as words or bytes.
class Out {
 public:
  explicit Out(MshForm form) : form_(form) { text_.precision(17); }

  bool is_binary() const { return form_ != MshForm::text; }
  void line(const std::string& text) { text_ << text << '\n'; }
  void end() { text_ << (is_binary() ? "" : "\n"); }  // of an item
  void integer(int value) { put(static_cast<std::int32_t>(value)); }
  void size(std::size_t value) { put(static_cast<std::uint64_t>(value)); }
  void number(double value) { put(value); }
  std::string text() const { return text_.str(); }

  void header(const std::string& version) {
    line("$MeshFormat");
    line(version + (is_binary() ? " 1 8" : " 0 8"));
    if (is_binary()) {
      integer(1);
      line("");
    }
    line("$EndMeshFormat");
  }
  void names(const SolidMesh& mesh) {
    line("$PhysicalNames");
    line(std::to_string(mesh.sets.size() + 1));
    for (std::size_t s = 0; s < mesh.sets.size(); ++s)
      line("2 " + std::to_string(s + 1) + " \"" + mesh.sets[s].name + '"');
    line("3 100 \"BODY\"");
    line("$EndPhysicalNames");
  }

 private:
  template <class Value>
  void put(Value value) {
    if (!is_binary()) {
      text_ << value << ' ';
      return;
    }
    std::array<char, sizeof(Value)> bytes;
    std::copy_n(reinterpret_cast<const char*>(&value), sizeof(Value), bytes.begin());
    if (form_ == MshForm::swapped_binary) std::reverse(bytes.begin(), bytes.end());
    text_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  MshForm form_;
  std::ostringstream text_;
};

/// An element of gmsh: its type, the number of its physical group and the dimension of that; 0:
/// none.
struct Written {
  int type, group, dimension;
  std::vector<int> labels;
};

std::vector<Written> elements_of(const SolidMesh& mesh) {
  std::vector<Written> all;
  all.push_back({15, 0, 0, {label_of(mesh, 0)}});
  for (std::size_t s = 0; s < mesh.sets.size(); ++s)
    for (const SolidFace& face : mesh.sets[s].faces) {
      Written written{gmsh_type(face), static_cast<int>(s + 1), 2, {}};
      for (int n = 0; n < face.count; ++n)
        written.labels.push_back(label_of(mesh, face.nodes[static_cast<std::size_t>(n)]));
      all.push_back(written);
    }
  for (const SolidElement& element : mesh.elements)
    all.push_back({gmsh_type(element.kind), 100, 3, in_gmsh_order(mesh, element)});
  return all;
}

void write_place(Out& out, const spatial::Vector& x) {
  for (const double value : x) out.number(value);
}

}  // namespace

std::string write_msh22(const SolidMesh& mesh, MshForm form) {
  Out out(form);
  out.header("2.2");
  out.names(mesh);
  out.line("$Nodes");
  out.line(std::to_string(mesh.nodes.size()));
  for (int n = static_cast<int>(mesh.nodes.size()); n-- > 0;) {
    out.integer(label_of(mesh, n));
    write_place(out, mesh.nodes[static_cast<std::size_t>(n)]);
    out.end();
  }
  out.line(out.is_binary() ? "\n$EndNodes" : "$EndNodes");
  const std::vector<Written> elements = elements_of(mesh);
  out.line("$Elements");
  out.line(std::to_string(elements.size()));
  int number = 0;
  for (const Written& element : elements) {
    if (!out.is_binary()) out.integer(++number);
    out.integer(element.type);
    if (out.is_binary()) out.integer(1);  // one element follows
    out.integer(2);
    if (out.is_binary()) out.integer(++number);
    out.integer(element.group);
    out.integer(element.group + 1);
    for (const int label : element.labels) out.integer(label);
    out.end();
  }
  out.line(out.is_binary() ? "\n$EndElements" : "$EndElements");
  return out.text();
}

std::string write_msh41(const SolidMesh& mesh, MshForm form) {
  Out out(form);
  out.header("4.1");
  out.names(mesh);
  out.line("$Entities");
  for (const std::size_t count : {std::size_t{1}, std::size_t{0}, mesh.sets.size(), std::size_t{1}})
    out.size(count);
  out.end();
  const auto entity = [&](int tag, int bounds, int group) {
    out.integer(tag);
    for (int b = 0; b < bounds; ++b) out.number(0.5 * b);
    out.size(group == 0 ? 0 : 1);
    if (group != 0) out.integer(group);
    if (bounds == 6) out.size(1);
    if (bounds == 6) out.integer(-1);
    out.end();
  };
  entity(1, 3, 0);
  for (std::size_t s = 0; s < mesh.sets.size(); ++s)
    entity(static_cast<int>(s + 5), 6, static_cast<int>(s + 1));
  entity(9, 6, 100);
  out.line(out.is_binary() ? "\n$EndEntities" : "$EndEntities");

  // Two blocks of nodes, the first with parameters.
  out.line("$Nodes");
  const std::size_t all = mesh.nodes.size(), first = all / 2;
  for (const std::size_t value : {std::size_t{2}, all, std::size_t{1}, all}) out.size(value);
  out.end();
  const auto block = [&](std::size_t begin, std::size_t count, int parametric) {
    for (const int value : {parametric == 1 ? 2 : 3, 9, parametric}) out.integer(value);
    out.size(count);
    out.end();
    const auto node = [&](std::size_t k) { return static_cast<int>(all - 1 - begin - k); };
    for (std::size_t k = 0; k < count; ++k) {
      out.size(static_cast<std::size_t>(label_of(mesh, node(k))));
      out.end();
    }
    for (std::size_t k = 0; k < count; ++k) {
      write_place(out, mesh.nodes[static_cast<std::size_t>(node(k))]);
      for (int p = 0; p < 2 * parametric; ++p) out.number(0.25);
      out.end();
    }
  };
  block(0, first, 1);
  block(first, all - first, 0);
  out.line(out.is_binary() ? "\n$EndNodes" : "$EndNodes");

  // One block for each element: all that a reader must cope with.
  const std::vector<Written> elements = elements_of(mesh);
  out.line("$Elements");
  for (const std::size_t value :
       {elements.size(), elements.size(), std::size_t{1}, elements.size()})
    out.size(value);
  out.end();
  std::size_t number = 0;
  for (const Written& element : elements) {
    const int tag = element.dimension == 0 ? 1 : element.dimension == 2 ? element.group + 4 : 9;
    for (const int value : {element.dimension, tag, element.type}) out.integer(value);
    out.size(1);
    out.end();
    out.size(++number);
    for (const int label : element.labels) out.size(static_cast<std::size_t>(label));
    out.end();
  }
  out.line(out.is_binary() ? "\n$EndElements" : "$EndElements");
  return out.text();
}

std::string write_inp(const SolidMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "*Heading\n a mesh\n** nodes\n*NODE\n";
  for (int n = static_cast<int>(mesh.nodes.size()); n-- > 0;) {
    const auto& x = mesh.nodes[static_cast<std::size_t>(n)];
    out << label_of(mesh, n) << ", " << x[0] << ", " << x[1] << ", " << x[2] << '\n';
  }
  int number = 0;
  std::vector<std::pair<int, int>> numbers;  // of the sets' faces, first and last
  for (const spatial::SolidNodeSet& set : mesh.sets) {
    numbers.emplace_back(number + 1, 0);
    for (const SolidFace& face : set.faces) {
      out << "*ELEMENT, TYPE=M3D" << face.count << "\n" << ++number;
      for (int n = 0; n < face.count; ++n)
        out << ", " << label_of(mesh, face.nodes[static_cast<std::size_t>(n)]);
      out << '\n';
    }
    numbers.back().second = number;
  }
  for (const SolidElement& element : mesh.elements) {
    out << "*element, type=C3D" << count_nodes(element.kind) << ", Elset=BODY\n" << ++number;
    for (int n = 0; n < count_nodes(element.kind); ++n) {
      out << (n == 15 ? ",\n   " : ", ");
      out << label_of(mesh, element.nodes[static_cast<std::size_t>(n)]);
    }
    out << '\n';
  }
  for (std::size_t s = 0; s < mesh.sets.size(); ++s)
    out << "*ELSET, ELSET=" << mesh.sets[s].name << ", GENERATE\n"
        << numbers[s].first << ", " << numbers[s].second << ", 1\n";
  out << "*MATERIAL, NAME=ALU\n*ELASTIC\n7.e10, .33\n*DENSITY\n2.7D+3,\n";
  return out.str();
}

void number_with_gaps(SolidMesh& mesh) {
  mesh.labels.clear();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    mesh.labels.push_back(static_cast<int>(3 * n + 7));
}

}  // namespace spoke::test
