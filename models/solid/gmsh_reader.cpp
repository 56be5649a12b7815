// Reads gmsh's formats 2 and 4.1, section by section.

#include "models/solid/gmsh_reader.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <utility>

#include "models/solid/gmsh_elements.h"
#include "models/solid/mesh_text.h"

namespace spoke::solid {
namespace {

using spatial::SolidElement;
using spatial::SolidFace;

constexpr const char* kWanted =
    "expected tetrahedra of 4 or 10 nodes, hexahedra of 8 or 20, and faces, lines and points";

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& file) : text_(text, file) {}

  MeshParts read() {
    if (!text_.find_word() || text_.word("$MeshFormat") != "$MeshFormat")
      text_.refuse("does not begin with $MeshFormat, expected a mesh of gmsh (.msh)");
    read_format();
    end_section("MeshFormat");
    while (text_.find_word()) read_section();
    take_sets();
    return std::move(parts_);
  }

 private:
  using Group = std::pair<int, int>;  // dimension and number of a physical group

  // Numbers, of words or bytes.
  template <class Integer>
  std::int64_t integer(std::int64_t least, std::int64_t most, const char* what) {
    if (!is_binary_) return text_.integer(least, most, what);
    const auto value = text_.binary<Integer>(is_swapped_, what);
    if (std::cmp_less(value, least) || std::cmp_greater(value, most))
      text_.refuse("is " + std::to_string(value) + ", expected " + what + ", an integer from " +
                   std::to_string(least) + " to " + std::to_string(most));
    return static_cast<std::int64_t>(value);
  }
  int small(int least, int most, const char* what) {  // gmsh's int
    return static_cast<int>(integer<std::int32_t>(least, most, what));
  }
  int label(const char* what) { return small(1, INT_MAX, what); }
  int long_label(const char* what) {  // of format 4.1: gmsh's size_t
    return static_cast<int>(integer<std::uint64_t>(1, INT_MAX, what));
  }
  double number(const char* what) {
    if (!is_binary_) return text_.number(what);
    const auto value = text_.binary<double>(is_swapped_, what);
    if (!std::isfinite(value))
      text_.refuse(std::string("is not finite, expected ") + what + ", a finite number");
    return value;
  }
  /// Refuses more items than the rest of the file can hold.
  std::size_t check_count(std::int64_t count, std::size_t bytes_each, const std::string& items) {
    const std::size_t most = text_.bytes_left() / bytes_each + 1;
    if (std::cmp_greater(count, most))
      text_.refuse("announces " + std::to_string(count) + ' ' + items + ", expected at most " +
                   std::to_string(most) + " in the rest of the file");
    return static_cast<std::size_t>(count);
  }
  std::size_t long_count(std::size_t bytes_each, const std::string& items) {
    const std::string what = "the number of " + items;
    return check_count(integer<std::uint64_t>(0, INT64_MAX, what.c_str()), bytes_each, items);
  }
  std::size_t text_count(std::size_t bytes_each, const std::string& items) {  // always of words
    const std::string what = "the number of " + items;
    return check_count(text_.integer(0, INT64_MAX, what.c_str()), bytes_each, items);
  }
  int line() const { return is_binary_ ? 0 : text_.line(); }
  /// Whether an item that began in this line ends in it.
  bool is_one_line(int begun) {
    return is_binary_ || (text_.line() == begun && text_.is_at_line_end());
  }
  void check_node_line(int begun, int tag) {
    if (!is_one_line(begun))
      text_.refuse(begun, "node " + std::to_string(tag) +
                              " is not all of one line, expected three coordinates");
  }
  void check_element_line(int begun, int tag, const GmshElement& kind) {
    if (!is_one_line(begun))
      text_.refuse(begun, "element " + std::to_string(tag) + ", a " + kind.name +
                              ", is not all of one line, expected its nodes in this line");
  }

  void read_format() {
    const double version = text_.number("the format's version");
    is_flat_ = version >= 2.0 && version < 3.0;
    if (!is_flat_ && version != 4.1)
      text_.refuse("is of gmsh's format " + std::to_string(version).substr(0, 3) +
                   ", expected 2.2 or 4.1 (gmsh -format msh41)");
    is_binary_ = text_.integer(0, 1, "0 (ASCII) or 1 (binary)") == 1;
    text_.integer(8, 8, "the size of a number in bytes");
    if (!is_binary_) return;
    text_.rest_of_line();
    const auto one = text_.binary<std::int32_t>(false, "the integer 1");
    is_swapped_ = one == 0x01000000;
    if (one != 1 && !is_swapped_)
      text_.refuse("is binary, of an order of bytes that is not known, expected the integer 1");
  }

  void end_section(const std::string& name) {
    const std::string_view word = text_.word(("$End" + name).c_str());
    if (word != "$End" + name) text_.refuse("is " + show_text(word) + ", expected $End" + name);
  }

  void read_section() {
    const int begun = text_.line();
    const std::string section(text_.word("a section"));
    if (section.size() < 2 || section[0] != '$' || section.starts_with("$End"))
      text_.refuse("is " + show_text(section) + ", expected the beginning of a section ($Nodes)");
    const std::string name = section.substr(1);
    if (is_binary_ && name != "PhysicalNames") text_.rest_of_line();
    if (name == "PhysicalNames")
      read_names();
    else if (name == "Nodes")
      is_flat_ ? read_flat_nodes() : read_node_blocks();
    else if (name == "Elements")
      is_flat_ ? read_flat_elements() : read_element_blocks();
    else if (name == "Entities")
      read_entities();
    else if (name == "PartitionedEntities")
      text_.refuse(begun, "the mesh is partitioned, expected one in one piece");
    else if (!text_.skip_behind("$End" + name))
      text_.refuse(begun, section.size() > 40
                              ? "a section does not end, expected its $End"
                              : show_text(section) + " does not end, expected $End" + name);
    if (name == "PhysicalNames" || name == "Nodes" || name == "Elements" || name == "Entities")
      end_section(name);
  }

  void read_names() {
    const std::size_t count = text_count(5, "names");
    for (std::size_t k = 0; k < count; ++k) {
      const auto dimension = static_cast<int>(text_.integer(0, 3, "a dimension"));
      const auto tag = static_cast<int>(text_.integer(1, INT_MAX, "the number of a group"));
      names_[{dimension, tag}] = text_.quoted("that of a physical group");
    }
  }

  void read_entities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = long_count(is_binary_ ? 36 : 10, "entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::size_t k = 0; k < counts[static_cast<std::size_t>(dimension)]; ++k) {
        const int tag = small(-INT_MAX, INT_MAX, "the number of an entity");
        for (int b = 0; b < (dimension == 0 ? 3 : 6); ++b) number("a bound of an entity");
        std::vector<int>& groups = groups_of_[{dimension, tag}];
        const std::size_t physical = long_count(is_binary_ ? 4 : 2, "physical groups");
        for (std::size_t p = 0; p < physical; ++p)
          groups.push_back(std::abs(small(-INT_MAX, INT_MAX, "the number of a physical group")));
        if (dimension == 0) continue;
        const std::size_t bounding = long_count(is_binary_ ? 4 : 2, "bounding entities");
        for (std::size_t b = 0; b < bounding; ++b)
          small(-INT_MAX, INT_MAX, "the number of an entity");
      }
  }

  void add_node(int tag, const spatial::Vector& place, int at) {
    parts_.labels.push_back(tag);
    parts_.nodes.push_back(place);
    parts_.node_lines.push_back(at);
  }
  spatial::Vector read_place() {
    spatial::Vector place;
    for (double& x : place) x = number("a node's coordinate");
    return place;
  }

  void read_flat_nodes() {
    const std::size_t count = text_count(is_binary_ ? 28 : 8, "nodes");
    if (is_binary_) text_.rest_of_line();
    reserve_nodes(count);
    for (std::size_t k = 0; k < count; ++k) {
      const int tag = label("a node's number");
      const int at = line();
      add_node(tag, read_place(), at);
      check_node_line(at, tag);
    }
  }

  void read_node_blocks() {
    const std::size_t blocks = long_count(is_binary_ ? 20 : 8, "blocks of nodes");
    reserve_nodes(long_count(is_binary_ ? 32 : 8, "nodes"));
    for (int k = 0; k < 2; ++k) integer<std::uint64_t>(0, INT64_MAX, "the number of a node");
    std::vector<int> tags;
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = small(0, 3, "the dimension of an entity");
      small(-INT_MAX, INT_MAX, "the number of an entity");
      const int parameters = small(0, 1, "0 or 1 (parametric)") == 1 ? dimension : 0;
      tags.assign(long_count(is_binary_ ? 32 : 8, "nodes"), 0);
      for (int& tag : tags) tag = long_label("a node's number");
      for (const int tag : tags) {
        const spatial::Vector place = read_place();
        const int at = line();
        for (int p = 0; p < parameters; ++p) number("a node's parameter");
        add_node(tag, place, at);
        check_node_line(at, tag);
      }
    }
  }

  void reserve_nodes(std::size_t count) {
    parts_.labels.reserve(count);
    parts_.nodes.reserve(count);
    parts_.node_lines.reserve(count);
  }

  const GmshElement& check_type(int type, int at) {
    const GmshElement* kind = find_gmsh_element(type);
    if (kind == nullptr)
      text_.refuse(at, "has an element of type " + std::to_string(type) + ", " + kWanted);
    if (!kind->is_read) text_.refuse(at, std::string("has a ") + kind->name + ", " + kWanted);
    return *kind;
  }

  void read_flat_elements() {
    const std::size_t count = text_count(8, "elements");
    if (is_binary_) text_.rest_of_line();
    std::vector<int> groups(1);
    for (std::size_t k = 0; k < count;) {
      // Binary: a header for several elements.
      int tag = is_binary_ ? 0 : label("an element's number");
      const int at = line();
      const int type = small(1, INT_MAX, "an element's type");
      const GmshElement& kind = check_type(type, at);
      const std::size_t follow =
          is_binary_ ? check_count(small(1, INT_MAX, "a number of elements"), 8, "elements") : 1;
      const int tags = small(0, 1000, "an element's number of tags");
      for (std::size_t e = 0; e < follow; ++e, ++k) {
        if (is_binary_) tag = label("an element's number");
        groups[0] = 0;
        for (int t = 0; t < tags; ++t) {
          const int value = small(-INT_MAX, INT_MAX, "an element's tag");
          if (t == 0) groups[0] = std::abs(value);
        }
        read_element(type, kind, groups, at, [&] { return label("a node's number"); });
        check_element_line(at, tag, kind);
      }
    }
  }

  void read_element_blocks() {
    const std::size_t blocks = long_count(is_binary_ ? 20 : 8, "blocks of elements");
    long_count(is_binary_ ? 16 : 4, "elements");
    for (int k = 0; k < 2; ++k) integer<std::uint64_t>(0, INT64_MAX, "the number of an element");
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = small(0, 3, "the dimension of an entity");
      const int entity = small(-INT_MAX, INT_MAX, "the number of an entity");
      const int type = small(1, INT_MAX, "the type of elements");
      const GmshElement& kind = check_type(type, line());
      const std::size_t count = long_count(is_binary_ ? 16 : 4, "elements");
      const auto groups = groups_of_.find({dimension, entity});
      static const std::vector<int> kNone;
      for (std::size_t k = 0; k < count; ++k) {
        const int tag = long_label("an element's number");
        const int at = line();
        read_element(type, kind, groups == groups_of_.end() ? kNone : groups->second, at,
                     [&] { return long_label("a node's number"); });
        check_element_line(at, tag, kind);
      }
    }
  }

  template <class Label>
  void read_element(int type, const GmshElement& kind, const std::vector<int>& groups, int at,
                    const Label& read_label) {
    std::array<int, 20> nodes{};
    for (int n = 0; n < kind.nodes; ++n) nodes[static_cast<std::size_t>(n)] = read_label();
    if (kind.dimension == 3) {
      const spatial::ElementKind made = kind_of_gmsh(type);
      parts_.elements.push_back({made, in_abaqus_order(made, nodes), at});
    }
    for (const int group : groups) {
      if (group == 0) continue;
      FileSet& set = sets_[{kind.dimension, group}];
      if (kind.dimension == 1) parts_.lines.push_back({{nodes[0], nodes[1]}, at});
      if (kind.dimension != 2) {
        set.nodes.insert(set.nodes.end(), nodes.begin(), nodes.begin() + kind.nodes);
        continue;
      }
      SolidFace face{kind.nodes, {}};
      std::copy_n(nodes.begin(), kind.nodes, face.nodes.begin());
      set.faces.push_back(face);
      set.face_lines.push_back(at);
    }
  }

  /// Takes over the groups as sets: those of one name and dimension together; of one name and
  /// several dimensions that of faces, else of volumes.
  void take_sets() {
    std::map<std::string, std::pair<int, std::size_t>> known;  // dimension and index
    for (const int dimension : {2, 3, 1, 0})
      for (auto& [group, set] : sets_) {
        if (group.first != dimension) continue;
        const auto named = names_.find(group);
        set.name = named == names_.end() ? std::to_string(group.second) : named->second;
        const auto [before, is_new] = known.try_emplace(set.name, dimension, parts_.sets.size());
        if (is_new) {
          parts_.sets.push_back(std::move(set));
        } else if (before->second.first == dimension) {
          FileSet& all = parts_.sets[before->second.second];
          all.nodes.insert(all.nodes.end(), set.nodes.begin(), set.nodes.end());
          all.faces.insert(all.faces.end(), set.faces.begin(), set.faces.end());
          all.face_lines.insert(all.face_lines.end(), set.face_lines.begin(), set.face_lines.end());
        }
      }
    drop_repeated_elements();
  }

  /// Format 2 has elements of several physical volumes once for each.
  void drop_repeated_elements() {
    int volumes = 0;
    for (const auto& [group, set] : sets_) volumes += group.first == 3 ? 1 : 0;
    if (!is_flat_ || volumes < 2) return;
    std::vector<std::size_t> order(parts_.elements.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto nodes = [&](std::size_t k) -> const auto& { return parts_.elements[k].nodes; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return nodes(a) < nodes(b); });
    std::vector<char> is_again(order.size(), 0);
    for (std::size_t k = 1; k < order.size(); ++k)
      is_again[order[k]] = nodes(order[k]) == nodes(order[k - 1]) ? 1 : 0;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < is_again.size(); ++k)
      if (is_again[k] == 0) parts_.elements[kept++] = parts_.elements[k];
    parts_.elements.resize(kept);
  }

  MeshText text_;
  bool is_flat_ = false;  // format 2
  bool is_binary_ = false;
  bool is_swapped_ = false;
  MeshParts parts_;
  std::map<Group, std::string> names_;
  std::map<Group, std::vector<int>> groups_of_;  // of an entity: dimension and number
  std::map<Group, FileSet> sets_;
};

}  // namespace

MeshParts read_gmsh(std::string_view text, const std::string& file) {
  return GmshReader(text, file).read();
}

}  // namespace spoke::solid
