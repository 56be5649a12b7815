// Arrays of properties by station, and tables of point masses.

#include "models/reader/blade_sections.h"

#include <algorithm>
#include <array>

#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

constexpr std::array<std::string_view, 4> kMaterial{"density", "area", "second_moment",
                                                    "youngs_modulus"};

bool has_material(const TomlSection& section) {
  return std::any_of(kMaterial.begin(), kMaterial.end(),
                     [&](std::string_view key) { return section.has(key); });
}

TomlSection sections_of(const TomlSection& blade) {
  return blade.section("sections", keys::keys_of(keys::kBladeSectionsRows));
}

}  // namespace

bool is_material(std::string_view key) {
  return std::find(kMaterial.begin(), kMaterial.end(), key) != kMaterial.end();
}

const TomlSection& material_of(const TomlSection& own, const TomlSection& common) {
  const bool is_own = own.has("sections") || (common.has("sections") && has_material(own));
  const TomlSection& material = is_own ? own : common;
  if (!material.has("sections")) return material;
  for (const std::string_view key : kMaterial)
    if (material.has(key))
      material.fail(
          key, "given along with " + sections_of(material).path() + ", expected only one of them");
  return material;
}

BladeSections read_sections(const TomlSection& blade) {
  const TomlSection section = sections_of(blade);
  BladeSections sections;
  sections.station = section.increasing_numbers("station", kStation);
  visit_properties(
      sections, [&](std::string_view key, std::vector<double>& values, const Quantity& quantity) {
        values = section.numbers(key, quantity);
      });
  return sections;
}

void check_sections(const TomlSection& section, const Blade& blade) {
  const SectionsFault fault = find_sections_fault(blade);
  if (!fault.key.empty()) sections_of(section).fail(fault.key, fault.text);
}

std::vector<PointMass> read_point_masses(const TomlSection& section, const Blade& blade) {
  std::vector<PointMass> points;
  const std::vector<TomlSection> tables =
      section.sections("point_mass", keys::keys_of(keys::kPointMassRows));
  if (tables.size() > kMostPointMasses)
    section.fail("point_mass", "are " + std::to_string(tables.size()) +
                                   " tables, expected at most " + std::to_string(kMostPointMasses));
  for (const TomlSection& table : tables) {
    PointMass point;
    point.position = table.number("position", place_on(blade));
    keys::read(table, keys::kPointMassRows, &point);
    points.push_back(point);
  }
  return points;
}

}  // namespace spoke
