#include "models/solid/inp_properties.h"

namespace spoke::solid {

std::string parameter_of(const InpKeyword& keyword, const char* parameter, const InpLines& lines) {
  const std::string* value = keyword.find(parameter);
  if (value == nullptr || value->empty())
    lines.refuse(keyword.line, '*' + keyword.name + " has no " + parameter + ", expected " +
                                   parameter + " = ...");
  return *value;
}

void InpProperties::read_section(const InpKeyword& keyword, const InpLines& lines) {
  properties_.push_back({keyword, parameter_of(keyword, "ELSET", lines)});
}

void InpProperties::read_masses(const InpKeyword& keyword, InpLines& lines) {
  const std::string* type = keyword.find("TYPE");
  if (type != nullptr && !in_capitals(*type).starts_with("ISO"))
    lines.refuse(keyword.line, "has masses of type " + show_text(*type) +
                                   ", expected ISOTROPIC, the same along all axes");
  const std::string set = parameter_of(keyword, "ELSET", lines);
  if (!lines.next_data()) lines.refuse(keyword.line, "has no mass, expected one");
  const double mass = lines.number(lines.items()[0], "a mass");
  if (!(mass >= 0.0)) lines.refuse("is a mass below zero, expected 0 or more");
  properties_.push_back({keyword, set, mass});
}

void InpProperties::check_role(const Property& property, const InpElementTable& table,
                               std::size_t at, const InpLines& lines) {
  const InpRole expected = property.is_mass() ? InpRole::mass : InpRole::volume;
  if (table.places[at].role == expected) return;
  lines.refuse(property.keyword.line,
               '*' + property.keyword.name + " is of element " + std::to_string(table.labels[at]) +
                   " (line " + std::to_string(table.lines[at]) + "), expected elements of " +
                   (property.is_mass() ? "type MASS" : "volumes only"));
}

std::vector<FileMass> InpProperties::take_masses(const InpElementTable& table,
                                                 const LabelIndex& elements, const InpSets& sets,
                                                 const InpLines& lines) const {
  std::vector<FileMass> masses;
  std::vector<char> has_mass(table.labels.size(), 0);
  for (const Property& property : properties_) {
    const int set = sets.find(property.set);
    if (set < 0)
      lines.refuse(property.keyword.line,
                   '*' + property.keyword.name + " is of the set " + show_text(property.set) +
                       ", which the file does not have, expected one of elements");
    for (const int label : sets.sets()[static_cast<std::size_t>(set)].members) {
      const auto at = static_cast<std::size_t>(elements.find(label));
      check_role(property, table, at, lines);
      if (!property.is_mass()) continue;
      has_mass[at] = 1;
      masses.push_back(
          {table.faces[table.places[at].index].nodes[0], property.mass, table.lines[at]});
    }
  }
  for (std::size_t at = 0; at < table.labels.size(); ++at)
    if (table.places[at].role == InpRole::mass && has_mass[at] == 0)
      lines.refuse(table.lines[at], "element " + std::to_string(table.labels[at]) +
                                        " of type MASS has no mass, expected *MASS of its set");
  return masses;
}

}  // namespace spoke::solid
