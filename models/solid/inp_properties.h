#pragma once

// Elements of an .inp file, and what sections and *MASS say of those of a set.

#include <cstddef>
#include <string>
#include <vector>

#include "models/solid/inp_elements.h"
#include "models/solid/inp_lines.h"
#include "models/solid/inp_sets.h"
#include "models/solid/mesh_parts.h"

namespace spoke::solid {

/// Elements in the order of the file.
struct InpElementTable {
  struct Place {
    InpRole role;
    std::size_t index;  ///< of the volume in MeshParts, or of others in `faces`
  };
  std::vector<int> labels;
  std::vector<int> lines;
  std::vector<Place> places;
  std::vector<spatial::SolidFace> faces;  ///< faces, and the nodes of lines and masses
};

/// Returns a parameter that the keyword must have. Throws InputError.
std::string parameter_of(const InpKeyword& keyword, const char* parameter, const InpLines& lines);

/// Takes *SOLID SECTION and *MASS.
class InpProperties {
 public:
  // Throw InputError.
  void read_section(const InpKeyword& keyword, const InpLines& lines);
  void read_masses(const InpKeyword& keyword, InpLines& lines);

  /// Returns the point masses, once sets and elements are known. Throws InputError of sections that
  /// make structures of others than volumes, and of MASS elements without a mass.
  std::vector<FileMass> take_masses(const InpElementTable& table, const LabelIndex& elements,
                                    const InpSets& sets, const InpLines& lines) const;

 private:
  struct Property {
    InpKeyword keyword;
    std::string set;
    double mass = 0.0;  ///< of each element
    bool is_mass() const { return keyword.key == "MASS"; }
  };
  static void check_role(const Property& property, const InpElementTable& table, std::size_t at,
                         const InpLines& lines);

  std::vector<Property> properties_;
};

}  // namespace spoke::solid
