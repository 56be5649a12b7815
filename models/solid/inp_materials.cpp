#include "models/solid/inp_materials.h"

#include <cstddef>
#include <iterator>

#include "models/count_text.h"

namespace spoke::solid {

using spatial::SolidMaterial;

InpMaterials::Material& InpMaterials::last(const InpKeyword& keyword, const InpLines& lines) {
  if (materials_.empty())
    lines.refuse(keyword.line, '*' + keyword.name +
                                   " belongs to no material, expected "
                                   "*MATERIAL before it");
  return materials_.back();
}

void InpMaterials::read_elastic(const InpKeyword& keyword, InpLines& lines) {
  Material& material = last(keyword, lines);
  material.elastic_line = keyword.line;
  const std::string* type = keyword.find("TYPE");
  if (type != nullptr && !in_capitals(*type).starts_with("ISO")) material.type = in_capitals(*type);
  while (material.type.empty() && lines.next_data()) {
    const auto& items = lines.items();
    if (items.size() < 2)
      lines.refuse("has " + counted(std::ssize(items), "item") +
                   ", expected Young's modulus and Poisson's ratio");
    material.values.youngs_modulus = lines.number(items[0], "Young's modulus");
    material.values.poissons_ratio = lines.number(items[1], "Poisson's ratio");
    ++material.elastic_lines;  // several: it depends on temperature
  }
}

void InpMaterials::read_density(const InpKeyword& keyword, InpLines& lines) {
  Material& material = last(keyword, lines);
  if (!lines.next_data()) lines.refuse(keyword.line, "has no density, expected one");
  material.values.density = lines.number(lines.items()[0], "a density");
}

std::vector<const InpMaterials::Material*> InpMaterials::in_use() const {
  std::vector<const Material*> found;
  for (const Material& material : materials_)
    if (used_.empty() || used_.count(in_capitals(material.name)) > 0) found.push_back(&material);
  return found;
}

std::optional<SolidMaterial> InpMaterials::find() const {
  const std::vector<const Material*> found = in_use();
  if (found.size() != 1 || !find_fault().empty() || found[0]->elastic_lines == 0)
    return std::nullopt;
  return found[0]->values;
}

std::string InpMaterials::find_fault() const {
  const std::vector<const Material*> found = in_use();
  const auto at = [](int line) { return " (line " + std::to_string(line) + ')'; };
  if (found.size() > 1) {
    std::string text = "has " + std::to_string(found.size()) + " materials, ";
    for (std::size_t k = 0; k < found.size(); ++k)
      text += (k == 0                 ? ""
               : k + 1 < found.size() ? ", "
                                      : " and ") +
              show_text(found[k]->name) + at(found[k]->line);
    return text;
  }
  if (found.empty()) return {};
  const Material& material = *found[0];
  const std::string of = "has a material, " + show_text(material.name) + ", whose *ELASTIC ";
  if (!material.type.empty())
    return of + "is of type " + show_text(material.type) + at(material.elastic_line) +
           ", not isotropic";
  if (material.elastic_lines > 1) return of + "depends on temperature" + at(material.elastic_line);
  return {};
}

}  // namespace spoke::solid
