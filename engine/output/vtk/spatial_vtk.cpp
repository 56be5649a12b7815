// Makes points, lines and faces of a deformed scene, in the inertial frame.

#include "engine/output/vtk/spatial_vtk.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/output/scene/deformed.h"
#include "engine/output/scene/make_scene.h"
#include "engine/output/vtk/vtk_text.h"

namespace spoke {
namespace {

using scene::Place;
using scene::Vector;

constexpr int kSides = 16;  // points of the outline of a section

/// The points and cells of a file.
struct Mesh {
  std::vector<Vector> points, displacements, velocities;  ///< inertial axes
  struct Cell {
    std::vector<std::size_t> corners;
    /// From 1; element 0 for rigid bodies, body 0 for rods of loops, all 0 for plates of anchors.
    int subsystem = 0, body = 0, element = 0;
    ElementForces forces;
  };
  std::vector<Cell> lines, faces;
};

/// Fills a mesh.
class MeshMaker {
 public:
  MeshMaker(const Simulation& simulation, const scene::Scene& scene, const scene::Frame& frame,
            const scene::FrameReader& reader)
      : scene_(scene), frame_(frame), reader_(reader), deformed_(scene, frame) {
    carriers_.resize(static_cast<std::size_t>(scene.groups));
    const HubFrame hub = simulation.hub_frame();
    carriers_[0] = {hub.position, hub.rotation, hub.velocity, hub.angular_velocity};
    for (const scene::Carrier& carrier : scene.carriers)
      carriers_[static_cast<std::size_t>(carrier.group)] =
          carrier.anchor < 0 ? simulation.mount_frame() : simulation.anchor_frame(carrier.anchor);
    if (scene.support >= 0)
      carriers_[static_cast<std::size_t>(scene.base_group)] = simulation.base_frame();
    for (std::size_t r = 1; r < scene.hubs.size(); ++r) carry_on(scene.hubs[r]);
  }

  Mesh make() && {
    for (std::size_t k = 0; k < scene_.nodes.size(); ++k)
      add_point({static_cast<int>(k), 0.0, scene_.nodes[k].p});
    for (const scene::Strip& strip : scene_.strips) {
      add_lines(strip);
      add_surface(strip);
    }
    for (const scene::Solid& solid : scene_.solids)
      if (solid.node >= 0 || solid.group > 0) add_solid(solid);
    for (const scene::LoopMark& loop : scene_.loops)
      if (loop.kind == name_of(LoopKind::distance)) add_rod(loop);
    return std::move(mesh_);
  }

 private:
  /// Where a node is and how it moves, in the frame of the hub.
  struct NodeMotion {
    Vector p, velocity, angular_velocity;
  };
  /// Returns the motion of a node; subsystems have theirs in the frame of what carries them.
  NodeMotion node(int k) const {
    const scene::NodeSource& source = scene_.sources[static_cast<std::size_t>(k)];
    const TreeNode& node = reader_.body_of(source).nodes[static_cast<std::size_t>(source.node)];
    const int root = scene_.roots[static_cast<std::size_t>(source.subsystem)];
    if (root == 0) return {node.p, node.velocity, node.angular_velocity};
    const spatial::Placement& base = frame_.groups[static_cast<std::size_t>(root)];
    return {base.position + base.rotation * node.p, base.rotation * node.velocity,
            base.rotation * node.angular_velocity};
  }
  /// Sets the motion of the frame of a hub besides the first.
  void carry_on(const scene::HubFrame& hub) {
    const NodeMotion motion = node(hub.node);
    const spatial::Placement& group = frame_.groups[static_cast<std::size_t>(hub.group)];
    const spatial::Placement first{frame_.hub.position, frame_.hub.rotation};
    const spatial::Placement placed = first * group;
    carriers_[static_cast<std::size_t>(hub.group)] = {placed.position, placed.rotation,
                                                      first.rotation * motion.velocity,
                                                      first.rotation * motion.angular_velocity};
  }
  static Vector cross(const Vector& w, const Vector& r) {
    return {w.y() * r.z() - w.z() * r.y(), w.z() * r.x() - w.x() * r.z(),
            w.x() * r.y() - w.y() * r.x()};
  }
  /// Returns the velocity of a point that is fixed to a node.
  static Vector velocity_at(const NodeMotion& node, const Vector& p) {
    return node.velocity + cross(node.angular_velocity, p - node.p);
  }

  /// Adds a point that is fixed to the hub, the mount or an anchor.
  void add_carried_point(const Place& place) {
    const MarkerMotion& motion = carriers_[static_cast<std::size_t>(place.group)];
    const Vector r = motion.rotation * place.p;
    mesh_.points.emplace_back(motion.position + r);
    mesh_.displacements.emplace_back(Vector::Zero());
    mesh_.velocities.emplace_back(motion.velocity + cross(motion.angular_velocity, r));
  }
  /// Adds a point that is fixed to a node, to an element at its outer end, or to what is no body.
  void add_point(const Place& place) {
    if (place.node < 0) return add_carried_point(place);
    const Vector p = deformed_.at(place).position;
    const spatial::Placement& group = frame_.groups[static_cast<std::size_t>(
        scene_.nodes[static_cast<std::size_t>(place.node)].group)];
    const Vector u = p - (group.position + group.rotation * place.p);
    const Vector v = velocity_at(node(place.xi > 0.0 ? place.node + 1 : place.node), p);
    mesh_.points.emplace_back(frame_.hub.position + frame_.hub.rotation * p);
    mesh_.displacements.emplace_back(frame_.hub.rotation * u);
    mesh_.velocities.emplace_back(frame_.hub.rotation * v);
  }

  Mesh::Cell cell_of(const scene::Strip& strip, int k) const {
    const scene::NodeSource& source = scene_.sources[static_cast<std::size_t>(strip.first + k)];
    return {{},
            source.subsystem + 1,
            source.body + 1,
            source.node + 1,
            reader_.body_of(source).forces[static_cast<std::size_t>(source.node)]};
  }
  void add_lines(const scene::Strip& strip) {
    for (int k = 0; k + 1 < strip.nodes; ++k) {
      mesh_.lines.push_back(cell_of(strip, k));
      const auto first = static_cast<std::size_t>(strip.first + k);
      mesh_.lines.back().corners = {first, first + 1};
    }
  }
  void add_surface(const scene::Strip& strip) {
    std::size_t last = 0;
    int element = -1;
    for (const scene::Ring& ring : strip.rings) {
      const bool is_end = &ring == &strip.rings.back();
      if (ring.at.xi > 0.0 && !is_end) continue;
      const std::size_t first = mesh_.points.size();
      for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        Place at = ring.at;
        at.p += ring.half_y * std::cos(angle) * ring.y + ring.half_z * std::sin(angle) * ring.z;
        add_point(at);
      }
      if (element >= 0)
        for (int i = 0; i < kSides; ++i) {
          const auto a = static_cast<std::size_t>(i),
                     b = static_cast<std::size_t>((i + 1) % kSides);
          mesh_.faces.push_back(cell_of(strip, element));
          mesh_.faces.back().corners = {last + a, last + b, first + b, first + a};
        }
      last = first;
      ++element;
    }
  }
  void add_solid(const scene::Solid& solid) {
    const std::size_t first = mesh_.points.size();
    for (const Vector& vertex : solid.vertices) add_point({solid.node, 0.0, vertex, solid.group});
    for (const std::vector<int>& face : solid.faces) {
      Mesh::Cell cell;
      cell.subsystem = solid.subsystem + 1;
      if (solid.node >= 0)
        cell.body = scene_.sources[static_cast<std::size_t>(solid.node)].body + 1;
      for (const int corner : face)
        cell.corners.push_back(first + static_cast<std::size_t>(corner));
      mesh_.faces.push_back(std::move(cell));
    }
  }

  void add_rod(const scene::LoopMark& loop) {
    const std::size_t first = mesh_.points.size();
    add_point(loop.from);
    add_point(loop.to);
    mesh_.lines.push_back({{first, first + 1}, loop.subsystem + 1, 0, 0, {}});
  }

  const scene::Scene& scene_;
  const scene::Frame& frame_;
  const scene::FrameReader& reader_;
  scene::Deformed deformed_;
  std::vector<MarkerMotion> carriers_;  ///< hub, mount, anchors and base, by group
  Mesh mesh_;
};

void add_field_data(const Simulation& simulation, const HubPose& hub, VtkText& file) {
  file.begin_field_data(simulation.time(), simulation.scenario().title,
                        "points m, displacement m, velocity m/s, axial_force N, shear_force N, "
                        "torque N m, bending_moment N m, hub_position m, TimeValue s");
  file.array("Float64", "hub_position", "NumberOfComponents=\"3\" NumberOfTuples=\"1\"",
             [&] { file.add(hub.position); });
  file.array("Float64", "hub_axes", "NumberOfComponents=\"9\" NumberOfTuples=\"1\"", [&] {
    for (int row = 0; row < 3; ++row) file.add(Vector(hub.rotation.row(row)));
  });
  file.line("</FieldData>");
}

void add_points(const Mesh& mesh, VtkText& file) {
  const auto vectors = [&](std::string_view name, const std::vector<Vector>& values) {
    file.array("Float64", name, "NumberOfComponents=\"3\"", [&] {
      for (const Vector& v : values) file.add(v);
    });
  };
  file.line("<PointData Vectors=\"displacement\">");
  vectors("displacement", mesh.displacements);
  vectors("velocity", mesh.velocities);
  file.line("</PointData>\n<Points>");
  vectors("points", mesh.points);
  file.line("</Points>");
}

/// Adds an array of cells: VTK expects lines before faces.
template <class Value>
void add_cell_array(std::string_view type, std::string_view name, const Mesh& mesh, Value value,
                    VtkText& file) {
  file.array(type, name, "", [&] {
    for (const Mesh::Cell& cell : mesh.lines) file.add(value(cell));
    for (const Mesh::Cell& cell : mesh.faces) file.add(value(cell));
  });
}

void add_cell_data(const Mesh& mesh, VtkText& file) {
  const auto integers = [&](std::string_view name, auto value) {
    add_cell_array("Int32", name, mesh, value, file);
  };
  const auto forces = [&](std::string_view name, double ElementForces::*force) {
    const auto value = [force](const Mesh::Cell& cell) { return cell.forces.*force; };
    add_cell_array("Float64", name, mesh, value, file);
  };
  file.line("<CellData Scalars=\"axial_force\">");
  integers("tree", [](const Mesh::Cell& cell) { return cell.subsystem; });
  integers("body", [](const Mesh::Cell& cell) { return cell.body; });
  integers("element", [](const Mesh::Cell& cell) { return cell.element; });
  forces("axial_force", &ElementForces::axial);
  forces("shear_force", &ElementForces::shear);
  forces("torque", &ElementForces::torsion);
  forces("bending_moment", &ElementForces::bending);
  file.line("</CellData>");
}

void add_cells(std::string_view kind, const std::vector<Mesh::Cell>& cells, VtkText& file) {
  file.line(std::string("<").append(kind).append(">"));
  file.array("Int64", "connectivity", "", [&] {
    for (const Mesh::Cell& cell : cells)
      for (const std::size_t corner : cell.corners) file.add(corner);
  });
  file.array("Int64", "offsets", "", [&] {
    std::size_t end = 0;
    for (const Mesh::Cell& cell : cells) file.add(end += cell.corners.size());
  });
  file.line(std::string("</").append(kind).append(">"));
}

}  // namespace

SpatialVtk::SpatialVtk(const Scenario& scenario)
    : scene_(scene::make_scene(scenario, std::numeric_limits<std::size_t>::max() / 2)),
      reader_(scene_) {}

std::string SpatialVtk::make(const Simulation& simulation) {
  reader_.read(simulation, frame_);
  const Mesh mesh = MeshMaker(simulation, scene_, frame_, reader_).make();
  VtkText file;
  file.line("<?xml version=\"1.0\"?>");
  file.line("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>");
  add_field_data(simulation, frame_.hub, file);
  std::string piece = "<Piece";
  const auto count = [&piece](std::string_view name, std::size_t number) {
    piece.append(" ").append(name).append("=\"").append(std::to_string(number)).append("\"");
  };
  count("NumberOfPoints", mesh.points.size());
  count("NumberOfLines", mesh.lines.size());
  count("NumberOfPolys", mesh.faces.size());
  file.line(piece.append(">"));
  add_points(mesh, file);
  add_cell_data(mesh, file);
  add_cells("Lines", mesh.lines, file);
  add_cells("Polys", mesh.faces, file);
  file.line("</Piece>\n</PolyData>\n</VTKFile>");
  return file.take();
}

}  // namespace spoke
