// Writes points, lines and arrays as VTK's XML, and the list of files.

#include "engine/output/vtk/vtk_series.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>

#include "engine/output/vtk/vtk_text.h"
#include "engine/results.h"
#include "models/error.h"
#include "models/plane/plane.h"

namespace spoke {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndex = "blades.pvd";

std::string file_name(std::size_t number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "blades_%06zu.vtp", number);
  return text.data();
}
std::string solid_file_name(std::size_t number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "solids_%06zu.vtu", number);
  return text.data();
}

/// Whether file_name() or solid_file_name() makes such a name.
bool is_of_series(std::string_view name) {
  if (name == kIndex) return true;
  const bool is_solid = name.starts_with("solids_") && name.ends_with(".vtu");
  const bool is_file = name.starts_with("blades_") && name.ends_with(".vtp");
  if (name.size() < 17 || !(is_solid || is_file)) return false;
  const std::string_view number = name.substr(7, name.size() - 11);
  return std::all_of(number.begin(), number.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

using Shapes = std::vector<BladeShape>;

void add_field_data(const Simulation& simulation, VtkText& file) {
  const HubMotion hub = simulation.hub();
  file.begin_field_data(simulation.time(), simulation.scenario().title,
                        "points m, displacement m, velocity m/s, axial_force N, hub_position m, "
                        "hub_angle rad, TimeValue s");
  file.array("Float64", "hub_position", "NumberOfComponents=\"3\" NumberOfTuples=\"1\"",
             [&] { file.add(Position(hub.position.head<kPosition>())); });
  file.number_array("hub_angle", hub.position[kRotation]);
  file.line("</FieldData>");
}

/// Calls visit(node) for the nodes of all subsystems.
template <class Visit>
void each_node(const Shapes& shapes, Visit visit) {
  for (const BladeShape& shape : shapes)
    for (const ShapeNode& node : shape.nodes) visit(node);
}

/// Calls visit(subsystem, element of the subsystem) for the elements of all subsystems.
template <class Visit>
void each_element(const Shapes& shapes, Visit visit) {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t e = 0; e < shapes[i].axial_forces.size(); ++e) visit(i, e);
}

void add_points(const Simulation& simulation, const Shapes& shapes, VtkText& file) {
  const Twist hub = simulation.hub().position;
  const Position origin = hub.head<kPosition>();
  const plane::Rotation R = plane::Rotation::from_angle(hub[kRotation]);
  constexpr std::string_view kVector = "NumberOfComponents=\"3\"";
  file.line("<PointData Vectors=\"displacement\">");
  file.array("Float64", "displacement", kVector, [&] {
    each_node(shapes, [&](const ShapeNode& node) { file.add(R * node.displacement); });
  });
  file.array("Float64", "velocity", kVector, [&] {
    each_node(shapes, [&](const ShapeNode& node) { file.add(R * node.velocity); });
  });
  file.line("</PointData>");
  file.line("<Points>");
  file.array("Float64", "points", kVector, [&] {
    each_node(shapes, [&](const ShapeNode& node) { file.add(Position(origin + R * node.p)); });
  });
  file.line("</Points>");
}

void add_cells(const Shapes& shapes, VtkText& file) {
  const auto integers = [&](std::string_view name, auto value) {
    file.array("Int32", name, "", [&] {
      each_element(shapes, [&](std::size_t i, std::size_t e) {
        file.add(static_cast<int>(value(i, static_cast<int>(e))));
      });
    });
  };
  file.line("<CellData Scalars=\"axial_force\">");
  integers("blade", [](std::size_t i, int) { return i + 1; });
  integers("body", [&](std::size_t i, int e) { return e / shapes[i].elements + 1; });
  integers("element", [&](std::size_t i, int e) { return e % shapes[i].elements + 1; });
  file.array("Float64", "axial_force", "", [&] {
    each_element(shapes,
                 [&](std::size_t i, std::size_t e) { file.add(shapes[i].axial_forces[e]); });
  });
  file.line("</CellData>");
  file.line("<Lines>");
  file.array("Int64", "connectivity", "", [&] {
    std::size_t first = 0;  // first point of a subsystem
    for (const BladeShape& shape : shapes) {
      for (std::size_t e = 0; e < shape.axial_forces.size(); ++e) {
        file.add(first + e);
        file.add(first + e + 1);
      }
      first += shape.nodes.size();
    }
  });
  int cells = 0;
  file.array("Int64", "offsets", "", [&] {
    each_element(shapes, [&](std::size_t, std::size_t) { file.add(2 * ++cells); });
  });
  file.line("</Lines>");
}

[[noreturn]] void refuse(const fs::path& folder, const std::error_code& error) {
  throw InputError(folder.string() + ": cannot be the folder of results: " + error.message());
}

}  // namespace

std::string make_planar_vtk(const Simulation& simulation, Shapes& shapes) {
  shapes.resize(simulation.scenario().rotor.blades.size());
  std::size_t points = 0, lines = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    simulation.calc_shape(static_cast<int>(i), shapes[i]);
    points += shapes[i].nodes.size();
    lines += shapes[i].axial_forces.size();
  }
  VtkText file;
  file.line("<?xml version=\"1.0\"?>");
  file.line("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>");
  add_field_data(simulation, file);
  file.line("<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfLines=\"" +
            std::to_string(lines) + "\">");
  add_points(simulation, shapes, file);
  add_cells(shapes, file);
  file.line("</Piece>\n</PolyData>\n</VTKFile>");
  return file.take();
}

std::vector<std::string> find_vtk_series(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  if (!fs::is_directory(folder, error)) return names;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (std::string name = entry->path().filename().string(); is_of_series(name))
      names.push_back(std::move(name));
  if (error) refuse(folder, error);
  return names;
}

void remove_vtk_series(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  for (const std::string& name : find_vtk_series(folder))
    if (!error) fs::remove(folder / name, error);
  if (error) refuse(folder, error);
  if (fs::is_empty(folder, error)) fs::remove(folder, error);
}

VtkSeries::VtkSeries(const Simulation& simulation, fs::path folder) : folder_(std::move(folder)) {
  if (simulation.scenario().space) {
    spatial_.emplace(simulation.scenario());
    solids_.emplace(simulation);
    if (!solids_->are_there()) solids_.reset();
  }
  remove_vtk_series(folder_);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) refuse(folder_, error);
}

void VtkSeries::write(const Simulation& simulation) {
  write_file(folder_ / file_name(times_.size()),
             spatial_ ? spatial_->make(simulation) : make_planar_vtk(simulation, shapes_));
  if (solids_) write_file(folder_ / solid_file_name(times_.size()), solids_->make(simulation));
  times_.push_back(simulation.time());
}

void VtkSeries::close() {
  VtkText file;
  file.line("<?xml version=\"1.0\"?>");
  file.line("<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">");
  file.line("<Collection>");
  for (std::size_t k = 0; k < times_.size(); ++k) {
    std::array<char, 32> time;
    const auto end = std::to_chars(time.data(), time.data() + time.size(), times_[k]).ptr;
    const auto add = [&](const char* part, const std::string& name) {
      file.line("<DataSet timestep=\"" + std::string(time.data(), end) + "\" part=\"" + part +
                "\" file=\"" + name + "\"/>");
    };
    add("0", file_name(k));
    if (solids_) add("1", solid_file_name(k));
  }
  file.line("</Collection>\n</VTKFile>");
  write_file(folder_ / kIndex, file.take());
}

}  // namespace spoke
