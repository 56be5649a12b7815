// Writes the nodes of solids as points, and their elements as cells of an unstructured grid.

#include "engine/output/vtk/solid_vtk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string_view>

#include "engine/output/vtk/vtk_text.h"
#include "models/space/rotation_vector.h"

namespace spoke {
namespace {

using spatial::Vector;

constexpr std::string_view kThree = "NumberOfComponents=\"3\"";

/// VTK's number of a kind of cells. Its order of nodes is that of Abaqus.
int vtk_type(spatial::ElementKind kind) {
  switch (kind) {
    case spatial::ElementKind::tet4:
      return 10;
    case spatial::ElementKind::tet10:
      return 24;
    case spatial::ElementKind::hex8:
      return 12;
    case spatial::ElementKind::hex20:
      return 25;
  }
  return 0;
}
constexpr int kVertex = 1;  // VTK's number of a point as a cell

/// A cell: an element of a mesh, or a node where the elements are not known.
struct SolidCell {
  int subsystem = 0, body = 0, element = 0;  ///< from 1
  int type = kVertex;
  std::vector<int> points;
};

/// Motion of a node, in inertial axes.
struct NodeMotion {
  Vector p, displacement, velocity;
};

/// Returns the motion of a node of a solid. `frame`: of the solid's frame; x: place at rest; u, v:
/// displacement and its rate, all in that frame.
NodeMotion move_node(const HubPose& hub, const TreeNode& frame, const Vector& x, const Vector& u,
                     const Vector& v) {
  const Vector arm = frame.R * (x + u);
  const spatial::Tensor rest = space::exponential(frame.rotation).axes.transpose() * frame.R;
  const Vector before = frame.p - frame.displacement + rest * x;
  const Vector p = frame.p + arm;
  const Vector velocity = frame.velocity + frame.angular_velocity.cross(arm) + frame.R * v;
  return {hub.position + hub.rotation * p, hub.rotation * (p - before), hub.rotation * velocity};
}

void add_cells(const std::vector<SolidCell>& cells, VtkText& file) {
  const auto integers = [&](std::string_view type, std::string_view name, auto value) {
    file.array(type, name, "", [&] {
      for (const SolidCell& cell : cells) file.add(value(cell));
    });
  };
  file.line("<CellData>");
  integers("Int32", "tree", [](const SolidCell& cell) { return cell.subsystem; });
  integers("Int32", "body", [](const SolidCell& cell) { return cell.body; });
  integers("Int32", "element", [](const SolidCell& cell) { return cell.element; });
  file.line("</CellData>\n<Cells>");
  file.array("Int64", "connectivity", "", [&] {
    for (const SolidCell& cell : cells)
      for (const int point : cell.points) file.add(point);
  });
  std::size_t end = 0;
  integers("Int64", "offsets", [&end](const SolidCell& cell) { return end += cell.points.size(); });
  integers("UInt8", "types", [](const SolidCell& cell) { return cell.type; });
  file.line("</Cells>");
}

/// Adds the cells of a solid, whose first point is `first`.
void list_cells(const space::SolidConstants& solid, SolidCell cell, int first,
                std::vector<SolidCell>& cells) {
  if (solid.mesh)
    for (const spatial::SolidElement& element : solid.mesh->elements) {
      ++cell.element;
      cell.type = vtk_type(element.kind);
      cell.points.assign(element.nodes.begin(), element.nodes.begin() + count_nodes(element.kind));
      for (int& point : cell.points) point += first;
      cells.push_back(cell);
    }
  if (cell.element > 0) return;
  for (int k = 0; k < static_cast<int>(solid.nodes.size()); ++k) {
    cell.points = {first + k};
    cells.push_back(cell);
  }
}

/// Returns the number that a node has in the file of its mesh.
int label_of(const space::SolidConstants& solid, std::size_t node) {
  if (!solid.mesh || solid.mesh->labels.empty()) return static_cast<int>(node) + 1;
  return solid.mesh->labels[node];
}

}  // namespace

SolidVtk::SolidVtk(const Simulation& simulation) {
  if (!simulation.scenario().space) return;
  const spatial::Model& model = *simulation.scenario().space;
  shapes_.resize(model.blades.size() + model.subsystems.size());
  read_shapes(simulation);
  std::map<const void*, std::shared_ptr<const space::NodeRecovery>> recoveries;
  int first = 0;
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    for (std::size_t j = 0; j < shapes_[i].bodies.size(); ++j) {
      const auto& constants = shapes_[i].bodies[j].solid;
      if (!constants) continue;
      auto& recovery = recoveries[constants.get()];
      if (!recovery) recovery = std::make_shared<space::NodeRecovery>(*constants);
      solids_.push_back({static_cast<int>(i), static_cast<int>(j), constants, recovery, first});
      first += recovery->size();
    }
}

void SolidVtk::read_shapes(const Simulation& simulation) {
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    simulation.calc_shape(static_cast<int>(i), shapes_[i]);
}

int SolidVtk::count_points() const {
  return solids_.empty() ? 0 : solids_.back().first + solids_.back().recovery->size();
}

std::string SolidVtk::make(const Simulation& simulation) {
  read_shapes(simulation);
  const HubPose hub = simulation.hub_pose();
  const MarkerMotion carrier = simulation.base_frame();
  const HubPose base{carrier.position, carrier.rotation};
  const int support =
      simulation.scenario().space->support ? static_cast<int>(shapes_.size()) - 1 : -1;
  std::vector<NodeMotion> nodes;
  std::vector<SolidCell> cells;
  for (const Solid& solid : solids_) {
    const TreeBodyShape& shape = shape_of(solid);
    const double *q = shape.coordinates.data(), *v = shape.velocities.data();
    for (int k = 0; k < solid.recovery->size(); ++k)
      nodes.push_back(move_node(solid.subsystem == support ? base : hub, shape.nodes.front(),
                                solid.constants->nodes[static_cast<std::size_t>(k)],
                                solid.recovery->displacement(k, q),
                                solid.recovery->displacement(k, v)));
    list_cells(*solid.constants, {solid.subsystem + 1, solid.body + 1, 0, kVertex, {}}, solid.first,
               cells);
  }
  VtkText file;
  file.line("<?xml version=\"1.0\"?>");
  file.line(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>");
  file.begin_field_data(simulation.time(), simulation.scenario().title,
                        "points m, displacement m, velocity m/s, von_mises Pa, TimeValue s");
  file.line("</FieldData>");
  file.line("<Piece NumberOfPoints=\"" + std::to_string(count_points()) + "\" NumberOfCells=\"" +
            std::to_string(cells.size()) + "\">");
  const auto vectors = [&](std::string_view name, Vector NodeMotion::*vector) {
    file.array("Float64", name, kThree, [&] {
      for (const NodeMotion& node : nodes) file.add(node.*vector);
    });
  };
  file.line("<PointData Vectors=\"displacement\">");
  vectors("displacement", &NodeMotion::displacement);
  vectors("velocity", &NodeMotion::velocity);
  const bool has_stress = std::any_of(solids_.begin(), solids_.end(), [](const Solid& solid) {
    return solid.recovery->has_stress();
  });
  if (has_stress)
    file.array("Float64", "von_mises", "", [&] {
      for (const Solid& solid : solids_)
        for (int k = 0; k < solid.recovery->size(); ++k)
          file.add(solid.recovery->has_stress()
                       ? solid.recovery->von_mises(k, shape_of(solid).coordinates.data())
                       : 0.0);
    });
  file.array("Int32", "node", "", [&] {
    for (const Solid& solid : solids_)
      for (std::size_t k = 0; k < solid.constants->nodes.size(); ++k)
        file.add(label_of(*solid.constants, k));
  });
  file.line("</PointData>\n<Points>");
  vectors("points", &NodeMotion::p);
  file.line("</Points>");
  add_cells(cells, file);
  file.line("</Piece>\n</UnstructuredGrid>\n</VTKFile>");
  return file.take();
}

}  // namespace spoke
