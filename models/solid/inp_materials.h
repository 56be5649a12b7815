#pragma once

// Materials of an .inp file, and which of them the body is of.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "models/solid/inp_lines.h"
#include "models/solid_body.h"

namespace spoke::solid {

/// Takes *MATERIAL and what follows it, and the materials of sections.
class InpMaterials {
 public:
  void open(const std::string& name, int line) { materials_.push_back({name, line}); }
  // Read the data of a keyword that belongs to the last material. Throw InputError.
  void read_elastic(const InpKeyword& keyword, InpLines& lines);
  void read_density(const InpKeyword& keyword, InpLines& lines);
  /// Takes the material of a section of volumes.
  void use(const std::string& name) { used_.insert(in_capitals(name)); }

  /// Returns the material of all sections, or else the only one; none unless it is one, isotropic
  /// and constant.
  std::optional<spatial::SolidMaterial> find() const;
  /// Returns what keeps the body from being of one material as the file has it: "has 2 materials, A
  /// (line 3) and B (line 9)"; empty: nothing, or there is no material.
  std::string find_fault() const;

 private:
  struct Material {
    std::string name;
    int line = 0;
    int elastic_lines = 0;
    int elastic_line = 0;  ///< that of *ELASTIC
    std::string type{};    ///< of *ELASTIC, if not isotropic
    spatial::SolidMaterial values{};
  };
  Material& last(const InpKeyword& keyword, const InpLines& lines);
  /// Returns the materials in use: those of the sections, or else all.
  std::vector<const Material*> in_use() const;

  std::vector<Material> materials_;
  std::set<std::string> used_;  // names in capitals
};

}  // namespace spoke::solid
