// Reads .inp files keyword by keyword.

#include "models/solid/inp_reader.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "models/count_text.h"
#include "models/solid/inp_keywords.h"
#include "models/solid/inp_lines.h"
#include "models/solid/inp_materials.h"
#include "models/solid/inp_properties.h"
#include "models/solid/inp_sets.h"
#include "models/solid/surface.h"

namespace spoke::solid {
namespace {

using spatial::SolidElement;
using spatial::SolidFace;
using spatial::SolidMaterial;

/// Part of a *SURFACE: a face of an element or of those of a set, or nodes.
struct SurfaceEntry {
  int surface;
  int element;  // its number; 0: `set` is meant
  int set;
  int face;  // from 1; 0: the element is a face itself
  int line;
};
struct Surface {
  std::string name;
  bool is_of_nodes;
};

class InpReader {
 public:
  InpReader(std::string_view text, const std::string& file, bool any_elements)
      : lines_(text, file), file_(file), any_elements_(any_elements) {}

  MeshParts read(std::optional<SolidMaterial>* material) {
    if (lines_.next_data()) lines_.refuse("is no keyword, expected *NODE or another");
    while (lines_.next_keyword(keyword_)) read_keyword();
    resolve();
    if (any_elements_) parts_.elements.clear();
    if (material != nullptr) *material = materials_.find();
    parts_.material_fault = materials_.find_fault();
    return std::move(parts_);
  }

 private:
  void read_keyword() {
    const std::string& key = keyword_.key;
    if (key == "NODE") return read_nodes();
    if (key == "ELEMENT") return read_elements();
    if (key == "NSET") return read_set(nodes_, "NSET");
    if (key == "ELSET") return read_set(elements_, "ELSET");
    if (key == "SURFACE") return read_surface();
    if (key == "MATERIAL") return materials_.open(parameter_of("NAME"), keyword_.line);
    if (key == "ELASTIC") return materials_.read_elastic(keyword_, lines_);
    if (key == "DENSITY") return materials_.read_density(keyword_, lines_);
    if (key == "SOLIDSECTION" && !any_elements_) {
      materials_.use(parameter_of("MATERIAL"));
      return properties_.read_section(keyword_, lines_);
    }
    if (key == "MASS" && !any_elements_) return properties_.read_masses(keyword_, lines_);
    if (key == "INSTANCE") return read_instance();
    if (key == "PART" && ++parts_read_ > 1)
      lines_.refuse(keyword_.line, "is a second part, expected one");
    if (key == "ASSEMBLY") is_in_assembly_ = true;
    if (key == "ENDASSEMBLY") is_in_assembly_ = false;
    if (key == "ENDINSTANCE") is_in_instance_ = false;
    if (key == "STEP") is_in_step_ = true;
    if (key == "ENDSTEP") is_in_step_ = false;
    if (key == "INCLUDE")
      lines_.refuse(keyword_.line, "includes another file, expected its text in this place");
    for (const char* refused : {"SYSTEM", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY"})
      if (key == refused)
        lines_.refuse(keyword_.line, '*' + keyword_.name +
                                         " is not supported, expected nodes and elements "
                                         "one by one");
    pass_over();
  }

  std::string parameter_of(const char* parameter) const {
    return solid::parameter_of(keyword_, parameter, lines_);
  }
  /// Whether nodes and numbers belong to the assembly and not to the mesh: points of reference.
  bool is_outside() const { return is_in_assembly_ && !is_in_instance_; }

  void read_nodes() {
    if (keyword_.find("SYSTEM") != nullptr && in_capitals(*keyword_.find("SYSTEM")) != "R")
      lines_.refuse(keyword_.line, "has nodes in a system of its own, expected x, y and z");
    if (is_outside()) return;
    const std::string* set = keyword_.find("NSET");
    if (set != nullptr) nodes_.open(*set);
    while (lines_.next_data()) {
      const auto& items = lines_.items();
      if (items.size() < 2 || items.size() > 7)
        lines_.refuse("has " + counted(std::ssize(items), "item") +
                      ", expected a node's number, x, y, z");
      parts_.labels.push_back(lines_.label(items[0], "a node's number"));
      parts_.node_lines.push_back(lines_.line());
      spatial::Vector& place = parts_.nodes.emplace_back(spatial::Vector::Zero());
      for (std::size_t a = 0; a < 3 && a + 1 < items.size(); ++a)
        place[static_cast<Eigen::Index>(a)] = lines_.number(items[a + 1], "a node's coordinate");
      if (set != nullptr) nodes_.add_number(parts_.labels.back(), lines_.line());
    }
  }

  void read_elements() {
    const std::string type = in_capitals(parameter_of("TYPE"));
    const InpElement kind = find_inp_element(type);
    if (any_elements_ && kind.role != InpRole::volume && kind.role != InpRole::face) {
      has_passed_over_ = true;
      return;
    }
    if (kind.role == InpRole::unknown)
      lines_.refuse(keyword_.line,
                    "has elements of type " + show_text(type) +
                        ", expected C3D4, C3D10, C3D8 or C3D20, or faces (CPS3, CPS6, CPS4, CPS8)");
    const std::string* set = keyword_.find("ELSET");
    if (set != nullptr) elements_.open(*set);
    std::array<int, 20> nodes{};
    while (lines_.next_data()) {
      const int line = lines_.line();
      int count = kind.nodes;
      const int label = read_element(type, kind.role == InpRole::line, count, nodes);
      table_.labels.push_back(label);
      table_.lines.push_back(line);
      if (set != nullptr) elements_.add_number(label, line);
      if (kind.role == InpRole::volume) {
        table_.places.push_back({kind.role, parts_.elements.size()});
        parts_.elements.push_back({kind.kind, nodes, line});
      } else {  // places by up to 8 nodes
        table_.places.push_back({kind.role, table_.faces.size()});
        SolidFace& face = table_.faces.emplace_back(SolidFace{count, {}});
        std::copy_n(nodes.begin(), count, face.nodes.begin());
      }
    }
  }

  /// Reads an element, which goes on in the next line if its line ends in a comma; returns its
  /// number. Has it `count` nodes, or `or_less` of them, `count` becomes their number.
  int read_element(const std::string& type, bool or_less, int& count, std::array<int, 20>& nodes) {
    const int line = lines_.line();
    int label = 0;
    int found = 0;
    for (bool goes_on = true; goes_on;) {
      for (const std::string_view item : lines_.items()) {
        if (label == 0)
          label = lines_.label(item, "an element's number");
        else if (found++ < count)
          nodes[static_cast<std::size_t>(found - 1)] = lines_.label(item, "a node's number");
      }
      goes_on = found < count && lines_.goes_on() && lines_.next_data();
    }
    if (or_less && found > 1) count = std::min(count, found);
    if (found != count)
      lines_.refuse(line, "element " + std::to_string(label) + " of type " + show_text(type) +
                              " has " + counted(found, "node") + ", expected " +
                              std::to_string(count) + " (lines that go on end in a comma)");
    return label;
  }

  void read_set(InpSets& sets, const char* parameter) {
    sets.open(parameter_of(parameter));
    const bool is_generated = keyword_.find("GENERATE") != nullptr;
    const bool is_outside_mesh = is_outside() && keyword_.find("INSTANCE") == nullptr;
    while (lines_.next_data()) {
      const auto& items = lines_.items();
      if (is_generated) {
        if (items.size() < 2 || items.size() > 3)
          lines_.refuse("has " + counted(std::ssize(items), "item") +
                        ", expected the first number, the last and the step");
        const int first = lines_.label(items[0], "the first number");
        const int last = lines_.label(items[1], "the last number");
        const int step = items.size() < 3 ? 1 : lines_.label(items[2], "the step of the numbers");
        if (last < first) lines_.refuse("has its last number before its first, expected it after");
        if (!is_outside_mesh) sets.add_range(first, last, step, lines_.line());
        continue;
      }
      for (const std::string_view item : items)
        if (!item.empty()) add_to_set(sets, item, is_outside_mesh);
    }
  }

  /// Puts a number or the name of an earlier set into a set; names of an instance stand before a
  /// dot.
  void add_to_set(InpSets& sets, std::string_view item, bool is_outside_mesh) {
    std::string_view inner = item;
    if (is_in_assembly_) inner.remove_prefix(std::min(item.rfind('.') + 1, item.size()));
    std::int64_t number = 0;
    if (read_number(inner, number)) {
      const int label = lines_.label(inner, "a number");
      if (!is_outside_mesh || inner.size() < item.size()) sets.add_number(label, lines_.line());
      return;
    }
    const int other = sets.find(std::string(inner));
    if (other < 0)
      lines_.refuse("is " + show_text(item) + ", expected a number or the name of an earlier set");
    sets.add_set(other, lines_.line());
  }

  void read_surface() {
    const std::string* type = keyword_.find("TYPE");
    const std::string kind = type == nullptr ? "ELEMENT" : in_capitals(*type);
    if (kind != "ELEMENT" && kind != "NODE") return;
    const int surface = static_cast<int>(surfaces_.size());
    surfaces_.push_back({parameter_of("NAME"), kind == "NODE"});
    const InpSets& sets = kind == "NODE" ? nodes_ : elements_;
    while (lines_.next_data()) {
      const auto& items = lines_.items();
      std::string_view inner = items[0];
      if (is_in_assembly_) inner.remove_prefix(std::min(inner.rfind('.') + 1, inner.size()));
      SurfaceEntry entry{surface, 0, -1, 0, lines_.line()};
      std::int64_t number = 0;
      if (read_number(inner, number)) {
        entry.element = lines_.label(inner, "the number of one");
      } else {
        entry.set = sets.find(std::string(inner));
        if (entry.set < 0)
          lines_.refuse("is " + show_text(items[0]) + ", expected a number or the name of a set");
      }
      const std::string face = items.size() < 2 ? "" : in_capitals(items[1]);
      if (face.size() == 2 && face[0] == 'S' && face[1] >= '1' && face[1] <= '6')
        entry.face = face[1] - '0';
      else if (kind == "ELEMENT" && !face.empty() && face != "SPOS" && face != "SNEG")
        lines_.refuse("is of face " + show_text(face) + ", expected S1 to S6");
      surface_entries_.push_back(entry);
    }
  }

  /// Refuses what makes another body, and notes what is left out, once each.
  void pass_over() {
    const auto [meaning, instead] = find_inp_meaning(keyword_.key, is_in_step_);
    // The density of a section of surfaces.
    const bool is_heavy = keyword_.key == "SURFACESECTION" && keyword_.find("DENSITY") != nullptr;
    if (any_elements_ || (meaning == InpMeaning::harmless && !is_heavy)) return;
    if (meaning == InpMeaning::not_built || is_heavy)
      lines_.refuse(keyword_.line, '*' + keyword_.name +
                                       " is not built, expected a mesh without (" +
                                       (is_heavy ? "*MASS at its nodes" : instead) + ')');
    if (!told_.insert(keyword_.key).second) return;
    const std::string shown = show_text('*' + keyword_.name);  // in quotes
    parts_.left_out.push_back(shown.substr(1, shown.size() - 2) + " (line " +
                              std::to_string(keyword_.line) + ')');
  }

  void read_instance() {
    if (++instances_read_ > 1)
      lines_.refuse(keyword_.line, "is a second instance of a part, expected one");
    is_in_instance_ = true;
    while (lines_.next_data())
      for (const std::string_view item : lines_.items())
        if (lines_.number(item, "a number of the instance's place") != 0.0)
          lines_.refuse("moves the instance, expected one where its part is");
  }

  void resolve() {
    const LabelIndex nodes(parts_.labels);
    const LabelIndex elements(table_.labels);
    check_repeated(nodes, parts_.labels, parts_.node_lines, "node", file_);
    check_repeated(elements, table_.labels, table_.lines, "element", file_);
    nodes_.resolve(nodes, parts_.labels, false, "node", file_);
    elements_.resolve(elements, table_.labels, has_passed_over_, "element", file_);
    if (!any_elements_)
      parts_.masses = properties_.take_masses(table_, elements, elements_, lines_);
    take_surfaces(elements);
    for (const bool with_faces : {true, false}) {
      for (const InpSets::Set& set : elements_.sets()) take_element_set(set, elements, with_faces);
      for (const InpSets::Set& set : nodes_.sets())
        if (with_faces && is_new(set.name)) parts_.sets.push_back({set.name, set.members, {}, {}});
    }
  }

  /// Whether no set has this name yet. Surfaces come first, then element sets with faces, node sets
  /// and element sets of volumes.
  bool is_new(const std::string& name) { return taken_.insert(in_capitals(name)).second; }

  void take_surfaces(const LabelIndex& elements) {
    std::vector<FileSet> made(surfaces_.size());
    for (const SurfaceEntry& entry : surface_entries_) {
      FileSet& set = made[static_cast<std::size_t>(entry.surface)];
      if (surfaces_[static_cast<std::size_t>(entry.surface)].is_of_nodes) {
        if (entry.set < 0) {
          set.nodes.push_back(entry.element);
        } else {
          const auto& members = nodes_.sets()[static_cast<std::size_t>(entry.set)].members;
          set.nodes.insert(set.nodes.end(), members.begin(), members.end());
        }
      } else if (entry.set < 0) {
        add_surface_face(entry, entry.element, elements, set);
      } else {
        for (const int label : elements_.sets()[static_cast<std::size_t>(entry.set)].members)
          add_surface_face(entry, label, elements, set);
      }
    }
    for (std::size_t s = 0; s < made.size(); ++s) {
      made[s].name = surfaces_[s].name;
      if (is_new(made[s].name)) parts_.sets.push_back(std::move(made[s]));
    }
  }

  void add_surface_face(const SurfaceEntry& entry, int label, const LabelIndex& elements,
                        FileSet& set) {
    const int at = elements.find(label);
    if (at < 0) {
      if (has_passed_over_) return;
      lines_.refuse(entry.line, "names element " + std::to_string(label) +
                                    ", which the file does not have, expected the number of one");
    }
    const auto [role, place] = table_.places[static_cast<std::size_t>(at)];
    if (role == InpRole::face) {
      set.faces.push_back(table_.faces[place]);
    } else {
      if (role != InpRole::volume)
        lines_.refuse(entry.line, "names element " + std::to_string(label) +
                                      ", which has no faces, expected one of a volume or a face");
      const auto faces = faces_of(parts_.elements[place]);
      if (entry.face < 1 || entry.face > static_cast<int>(faces.size()))
        lines_.refuse(entry.line, "names no face of element " + std::to_string(label) +
                                      ", expected S1 to S" + std::to_string(faces.size()));
      set.faces.push_back(faces[static_cast<std::size_t>(entry.face - 1)]);
    }
    set.face_lines.push_back(table_.lines[static_cast<std::size_t>(at)]);
  }

  template <class Nodes>
  static void add_nodes(const Nodes& nodes, int count, FileSet& set) {
    set.nodes.insert(set.nodes.end(), nodes.begin(), nodes.begin() + count);
  }

  void take_element_set(const InpSets::Set& set, const LabelIndex& elements, bool with_faces) {
    FileSet made{set.name, {}, {}, {}};
    for (const int label : set.members) {
      const auto at = static_cast<std::size_t>(elements.find(label));
      const auto [role, place] = table_.places[at];
      if (role == InpRole::face) {
        made.faces.push_back(table_.faces[place]);
        made.face_lines.push_back(table_.lines[at]);
      } else if (!with_faces && role == InpRole::volume) {
        add_nodes(parts_.elements[place].nodes, count_nodes(parts_.elements[place].kind), made);
      } else if (!with_faces) {
        add_nodes(table_.faces[place].nodes, table_.faces[place].count, made);
      }
    }
    if (with_faces == made.faces.empty()) return;
    if (is_new(set.name)) parts_.sets.push_back(std::move(made));
  }

  InpLines lines_;
  const std::string& file_;
  bool any_elements_;  // only nodes and sets count: all other things are passed over
  InpKeyword keyword_;
  MeshParts parts_;
  InpElementTable table_;
  bool has_passed_over_ = false;
  InpSets nodes_;
  InpSets elements_;
  std::vector<Surface> surfaces_;
  std::vector<SurfaceEntry> surface_entries_;
  InpMaterials materials_;
  InpProperties properties_;
  std::set<std::string> told_;   // keywords
  std::set<std::string> taken_;  // names of sets
  int parts_read_ = 0;
  int instances_read_ = 0;
  bool is_in_assembly_ = false, is_in_instance_ = false, is_in_step_ = false;
};

}  // namespace

MeshParts read_inp(std::string_view text, const std::string& file,
                   std::optional<spatial::SolidMaterial>* material) {
  return InpReader(text, file, false).read(material);
}

MeshParts read_inp_nodes(std::string_view text, const std::string& file) {
  return InpReader(text, file, true).read(nullptr);
}

}  // namespace spoke::solid
