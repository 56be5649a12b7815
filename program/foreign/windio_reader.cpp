// WindIO's axes of sections are BeamDyn's; grids are shares of the arc length of the reference
// axis; angles are in rad.

#include "program/foreign/windio_reader.h"

#include <cmath>
#include <numbers>

#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/section_check.h"
#include "program/foreign/windio_aerodynamics.h"
#include "program/foreign/windio_entry.h"
#include "program/foreign/windio_turbine.h"

namespace spoke::foreign {
namespace {

/// `unit`: of the twist [rad].
std::vector<KeyPoint> read_axis(const Entry& axis, const Entry& twist_table, double unit) {
  const Course x = read_course(axis.at("x")), y = read_course(axis.at("y")),
               z = read_course(axis.at("z")), twist = read_course(twist_table);
  std::vector<KeyPoint> points;
  for (const double place : unite_grids({&x.grid, &y.grid, &z.grid, &twist.grid})) {
    KeyPoint point;
    point.x = z.at(place);
    const double sweep = y.at(place), angle = unit * twist.at(place);
    point.sweep = sweep == 0.0 ? 0.0 : -sweep;
    point.prebend = x.at(place);
    point.twist = angle == 0.0 ? 0.0 : -angle;
    point.from = "axis at " + describe(place) + ", " + axis.from();
    if (points.empty() && is_at_root(point)) point.x = point.sweep = point.prebend = 0.0;
    if (points.empty() && (point.x != 0.0 || point.sweep != 0.0 || point.prebend != 0.0))
      axis.refuse("does not begin at the root, expected 0 for x, y and z");
    if (!points.empty() && !(point.x > points.back().x))
      axis.at("z").refuse("is " + describe(point.x) + " at " + describe(place) +
                          ", expected more than at the place before, " + describe(points.back().x));
    points.push_back(point);
  }
  return points;
}

/// Reads matrices by their upper triangles, or by all entries.
std::vector<SectionMatrix> read_matrices(const Entry& table, std::size_t count, bool is_mass,
                                         double& asymmetry) {
  std::vector<SectionMatrix> matrices;
  const Entry values = table.at("values");
  const std::vector<Entry> rows = values.elements();
  check_count(values, rows.size(), count);
  for (const Entry& row : rows) {
    const std::vector<double> entries = row.numbers();
    constexpr std::size_t all = 36, upper_triangle = 21;
    if (entries.size() != all && entries.size() != upper_triangle)
      row.refuse("has " + std::to_string(entries.size()) +
                 " numbers, expected the 21 of the upper triangle, row by row, or 36");
    SectionMatrix matrix;
    std::size_t next = 0;
    for (int r = 0; r < 6; ++r)
      for (int c = entries.size() == all ? 0 : r; c < 6; ++c) {
        matrix(r, c) = entries[next++];
        if (entries.size() != all) matrix(c, r) = matrix(r, c);
      }
    const std::string fault =
        is_mass ? check_mass(matrix, asymmetry) : check_stiffness(matrix, asymmetry);
    if (!fault.empty()) row.refuse(fault);
    matrices.push_back(matrix);
  }
  return matrices;
}

std::vector<FoundSection> read_sections(const Entry& table, double& asymmetry) {
  const Entry stiffness = table.at("stiff_matrix"), mass = table.at("inertia_matrix");
  const std::vector<double> grid = read_grid(stiffness), mass_grid = read_grid(mass);
  if (grid != mass_grid) mass.at("grid").refuse("differs, expected that of stiff_matrix");
  const auto K = read_matrices(stiffness, grid.size(), false, asymmetry);
  const auto M = read_matrices(mass, grid.size(), true, asymmetry);
  const auto stiffness_rows = stiffness.at("values").elements();
  std::vector<FoundSection> sections;
  for (std::size_t i = 0; i < grid.size(); ++i)
    sections.push_back({grid[i], K[i], M[i],
                        "section " + std::to_string(i + 1) + ", " + stiffness_rows[i].from()});
  return sections;
}

/// Reads an array for each of grid; where it may be missing, that is zeros.
std::vector<double> read_array(const Entry& table, const std::string& key, std::size_t count,
                               bool may_be_missing) {
  if (may_be_missing && !table.has(key)) return std::vector<double>(count, 0.0);
  const Entry entry = table.at(key);
  std::vector<double> values = entry.numbers();
  check_count(entry, values.size(), count);
  return values;
}

/// Reads K11 to K66 of version 2.
std::vector<SectionMatrix> read_stiffnesses(const Entry& table, std::size_t count) {
  std::vector<SectionMatrix> all(count);
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) {
      const std::string key = 'K' + std::to_string(r + 1) + std::to_string(c + 1);
      const std::vector<double> values = read_array(table, key, count, r != c);
      for (std::size_t i = 0; i < count; ++i) all[i](r, c) = all[i](c, r) = values[i];
    }
  return all;
}

/// Reads masses, centres and inertias about the reference axis of version 2.
std::vector<SectionMatrix> read_masses(const Entry& table, std::size_t count) {
  const auto array = [&](const char* key, bool may_be_missing) {
    return read_array(table, key, count, may_be_missing);
  };
  const auto mass = array("mass", false), x = array("cm_x", true), y = array("cm_y", true),
             edge = array("i_edge", false), flap = array("i_flap", false),
             product = array("i_cp", true);
  std::vector<SectionMatrix> all(count, SectionMatrix::Zero());
  for (std::size_t i = 0; i < count; ++i) {
    SectionMatrix& m = all[i];
    m(0, 0) = m(1, 1) = m(2, 2) = mass[i];
    m(0, 5) = m(5, 0) = -mass[i] * y[i];
    m(1, 5) = m(5, 1) = mass[i] * x[i];
    m(2, 3) = m(3, 2) = mass[i] * y[i];
    m(2, 4) = m(4, 2) = -mass[i] * x[i];
    m(3, 3) = edge[i];
    m(4, 4) = flap[i];
    m(5, 5) = edge[i] + flap[i];
    m(3, 4) = m(4, 3) = -product[i];
  }
  return all;
}

std::vector<FoundSection> read_sections_of_version_2(const Entry& table, double& asymmetry) {
  const Entry stiffness = table.at("stiffness_matrix"), mass = table.at("inertia_matrix");
  const std::vector<double> grid = read_grid(stiffness);
  if (grid != read_grid(mass)) mass.at("grid").refuse("differs, expected that of stiffness_matrix");
  auto K = read_stiffnesses(stiffness, grid.size());
  auto M = read_masses(mass, grid.size());
  std::vector<FoundSection> sections;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::string name = "section " + std::to_string(i + 1);
    if (const auto fault = check_stiffness(K[i], asymmetry); !fault.empty())
      stiffness.refuse(name + ' ' + fault);
    if (const auto fault = check_mass(M[i], asymmetry); !fault.empty())
      mass.refuse(name + ' ' + fault);
    sections.push_back({grid[i], K[i], M[i], name + ", " + stiffness.from()});
  }
  return sections;
}

/// Where a version has what the blade is made of.
struct BladeTables {
  Entry axis, twist;
  std::vector<FoundSection> sections;
};

BladeTables read_tables_of_version_1(const Entry& blade, double& asymmetry) {
  const Entry table = blade.at("elastic_properties_mb").at("six_x_six");
  const Entry shape = blade.has("outer_shape_bem") ? blade.at("outer_shape_bem") : table;
  return {(table.has("reference_axis") ? table : shape).at("reference_axis"),
          (table.has("twist") ? table : shape).at("twist"), read_sections(table, asymmetry)};
}

BladeTables read_tables_of_version_2(const Entry& blade, double& asymmetry, FoundModel& model) {
  const Entry table = blade.at("structure").at("elastic_properties");
  if (table.has("structural_damping")) {
    const Entry mu = table.at("structural_damping").at("mu");
    model.damping = {mu.numbers(), {}, mu.from()};
    constexpr std::size_t factors = 6;
    for (const double factor : model.damping.mu)
      if (factor < 0.0) mu.refuse("is " + describe(factor) + ", expected numbers of 0 or more (s)");
    if (model.damping.mu.size() != factors)
      mu.refuse("has " + std::to_string(model.damping.mu.size()) + " elements, expected 6");
  }
  return {blade.at("reference_axis"), blade.at("outer_shape").at("twist"),
          read_sections_of_version_2(table, asymmetry)};
}

bool is_version_2(const Entry& root) {
  return root.has("windIO_version") && root.at("windIO_version").text().starts_with('2');
}

/// Whether the rotor stands upwind of the tower.
bool is_rotor_upwind(const Entry& root) {
  if (!root.has("assembly") || !root.at("assembly").has("rotor_orientation")) return true;
  return !is_same_word(root.at("assembly").at("rotor_orientation").text(), "downwind");
}

/// `unit`: of the cone angle [rad].
void read_rotor(const Entry& root, double unit, FoundModel& model) {
  const bool is_upwind = is_rotor_upwind(root);
  if (root.has("assembly") && root.at("assembly").has("number_of_blades")) {
    const Entry count = root.at("assembly").at("number_of_blades");
    model.blade_count = {count.number(), count.from()};
    if (!(count.number() >= 1.0 && count.number() <= 1000.0) ||
        count.number() != std::floor(count.number()))
      count.refuse("is " + describe(count.number()) + ", expected a whole number from 1 to 1000");
  }
  if (!root.at("components").has("hub")) return;
  const Entry hub = root.at("components").at("hub");
  if (hub.has("diameter")) {
    const Entry diameter = hub.at("diameter");
    if (!(diameter.number() >= 0.0))
      diameter.refuse("is " + describe(diameter.number()) + ", expected 0 or more (m)");
    model.hub_radius = {0.5 * diameter.number(), diameter.from() + ", half of it"};
  }
  if (hub.has("cone_angle")) {
    const Entry cone = hub.at("cone_angle");
    const double angle = unit * cone.number();
    model.precone = {is_upwind ? -angle : angle, cone.from() + ", away from the tower"};
  }
  model.has_rotor = true;
}

void read_gravity(const Entry& root, bool has_tower, FoundModel& model) {
  if (!root.has("environment") || !root.at("environment").has("gravity")) return;
  const Entry gravity = root.at("environment").at("gravity");
  model.gravity = {gravity.number(), gravity.from() + (has_tower ? "" : ", down across the axis")};
  if (!(gravity.number() >= 0.0))
    gravity.refuse("is " + describe(gravity.number()) + ", expected 0 or more (m/s^2)");
}

/// `unit`: of the twist [rad].
void read_blade(const BladeTables& tables, double unit, FoundModel& model) {
  const Entry& axis = tables.axis;
  const BladeAxis curve(read_axis(axis, tables.twist, unit));
  BeamTable beam = merge_stations(curve, tables.sections);
  beam.length = {curve.points().back().x, "z of " + axis.from()};
  beam.remarks.emplace_back(
      "Stations are those of the reference axis and of the sections, whose "
      "grid is a share of the arc length; sweep is -y, prebend x, twist of "
      "the other sign.");
  model.blade = std::move(beam);
}

/// What the model has not of the file.
void note_missing_parts(const std::string& file, bool has_turbine, bool has_air,
                        FoundModel& model) {
  const std::string control =
      model.laws ? ""
                 : "gains of control and the torque of the generator, which are not in an ontology "
                   "(the drive holds the speed; a DISCON.IN of ROSCO besides has them); ";
  if (has_turbine)
    model.leave_out(Loss::part, file + ": " + control +
                                    "monopile, floater, moorings (the foot of the tower is held)");
  else
    model.leave_out(Loss::part, file +
                                    ": tower, nacelle, generator and control; the hub is held, its "
                                    "mass is not in the file");
  model.leave_out(Loss::detail, file + ": " + (has_air ? "shapes of the aerofoils" : "airfoils") +
                                    ", layers of the blades and their materials");
}

}  // namespace

void read_windio(const SourceFile& source, FoundModel& model) {
  try {
    const Entry root(YAML::Load(source.text), source.name, "", 0);
    if (root.has("name")) model.title = root.at("name").text();
    const Entry blade = root.at("components").at("blade");
    const bool is_new = is_version_2(root);
    const double unit = is_new ? std::numbers::pi / 180.0 : 1.0;
    double asymmetry = 0.0;  // entries of full matrices only
    const BladeTables tables = is_new ? read_tables_of_version_2(blade, asymmetry, model)
                                      : read_tables_of_version_1(blade, asymmetry);
    read_blade(tables, unit, model);
    const bool has_air = has_windio_aerodynamics(root, is_new);
    const bool has_turbine = !is_new && has_windio_turbine(root);
    if (has_air) read_windio_aerodynamics(root, is_new, tables.axis, tables.twist, model);
    read_rotor(root, unit, model);
    read_gravity(root, has_turbine, model);
    if (has_turbine) read_windio_turbine(root, is_rotor_upwind(root), model);
    note_missing_parts(source.name, has_turbine, has_air, model);
  } catch (const YAML::Exception& error) {
    refuse(source.name, error.mark.is_null() ? 0 : error.mark.line + 1,
           "is no YAML: " + printable(error.msg) + ", expected an ontology of WindIO");
  }
}

}  // namespace spoke::foreign
