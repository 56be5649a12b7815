#include "tests/engine/solids/solid_models.h"

#include <memory>
#include <utility>

#include "models/solid/order_coordinates.h"

namespace spoke::test {
namespace {

using spatial::InterfaceKind;
using spatial::JointKind;
using spatial::SolidFrame;
using spatial::Vector;

spatial::SubsystemJoint make_joint(const std::string& parent, const std::string& child,
                                   JointKind kind, const Vector& offset) {
  spatial::SubsystemJoint joint;
  joint.parent = parent;
  joint.child = child;
  joint.joint.kind = kind;
  joint.joint.offset = offset;
  joint.joint.axes[0] = Vector(0.1, 0.3, 1.0);
  for (spatial::JointCoordinate& coordinate : joint.joint.coordinates) coordinate.stiffness = 8.0;
  return joint;
}

spatial::Beam make_beam() {
  spatial::Beam beam;
  beam.length = 0.6;
  beam.bodies = 1;
  beam.elements = 2;
  beam.sections.station = {0.0, 0.6};
  beam.sections.mass_per_length = {2.0, 2.0};
  beam.sections.axial_stiffness = {1e5, 1e5};
  beam.sections.lag_stiffness = beam.sections.flap_stiffness = {60.0, 60.0};
  beam.sections.torsion_stiffness = {50.0, 50.0};
  beam.sections.flap_inertia = beam.sections.lag_inertia = {2e-3, 2e-3};
  return beam;
}

}  // namespace

spatial::SolidBody make_bar(const GridMesh& grid, const spatial::SolidMaterial& material,
                            InterfaceKind root, InterfaceKind tip) {
  spatial::SolidBody body;
  body.mesh = std::make_shared<const spatial::SolidMesh>(make_grid_mesh(grid));
  body.material = material;
  body.interfaces.push_back({"root", "X0", root, {}});
  body.interfaces.push_back({"tip", "X1", tip, {}});
  return body;
}

GridMesh slender_grid() {
  GridMesh grid;
  grid.cells = {4, 1, 1};
  grid.lengths = {1.0, 0.1, 0.1};
  grid.shift = {0.0, -0.05, -0.05};
  return grid;
}

spatial::SolidMaterial rubber() { return {1e7, 0.3, 1000.0}; }

spatial::Model make_solid_trees(HubSupport support, spatial::SolidCoordinates coordinates) {
  spatial::Model model;
  model.hub.support = support;
  model.hub.mass = 30.0;
  model.hub.inertia = Vector(4.0, 5.0, 6.0).asDiagonal();
  if (support == HubSupport::free) {
    model.hub.velocity = Vector(0.3, -0.2, 0.5);
    model.hub.angular_velocity = Vector(0.5, -0.4, 2.0);
  } else {
    model.hub.drive = FreeDrive{2.0};
  }
  spatial::SolidBody arm = make_bar(slender_grid(), rubber());
  arm.interfaces.push_back({"side",
                            spatial::BoxNodes{Vector(0.3, -0.06, 0.04), Vector(0.7, 0.06, 0.06)},
                            InterfaceKind::average,
                            {}});
  arm.coordinates = coordinates;
  const bool is_reduced = coordinates == spatial::SolidCoordinates::reduced;
  if (is_reduced) arm.modes = 6;
  spatial::SolidBody outer =
      make_bar(slender_grid(), rubber(), InterfaceKind::average, InterfaceKind::average);
  outer.coordinates = coordinates;
  if (is_reduced) outer.modes = 5;
  spatial::SolidBody flying = make_bar(slender_grid(), rubber());
  flying.frame = SolidFrame::mean_axis;
  flying.modes = 7;

  spatial::Subsystem tree;
  tree.name = "tree";
  tree.bodies = {{"arm", arm},
                 {"outer", outer},
                 {"boom", make_beam()},
                 {"mass", spatial::RigidBody{3.0, Vector(0.1, 0.0, 0.05),
                                             Vector(0.02, 0.03, 0.04).asDiagonal()}}};
  tree.joints = {make_joint("hub", "arm", JointKind::revolute, Vector(0.3, 0.0, 0.0)),
                 make_joint("arm", "outer", JointKind::spherical, Vector(0.02, 0.0, 0.0)),
                 make_joint("arm", "boom", JointKind::revolute, Vector(0.0, 0.0, 0.0)),
                 make_joint("outer", "mass", JointKind::fixed, Vector(0.0, 0.0, 0.0))};
  tree.joints[1].interface = "tip";
  tree.joints[2].interface = "side";
  spatial::Subsystem pair;
  pair.name = "pair";
  pair.bodies = {{"flying", flying}, {"arm", arm}};
  pair.joints = {make_joint("hub", "flying", JointKind::spherical, Vector(-0.3, 0.0, 0.1)),
                 make_joint("flying", "arm", JointKind::revolute, Vector(0.0, 0.01, 0.0))};
  pair.joints[0].joint.orientation = Vector(0.0, 0.0, 3.0);
  pair.joints[0].joint.coordinates[1].initial_speed = 0.5;
  model.subsystems = {tree, pair};
  return model;
}

System<Space> cut_solids(System<Space> system, int slices) {
  for (Subsystem<Space>& subsystem : system.subsystems)
    for (TreeBody<Space>& member : subsystem.bodies) {
      if (!member.body->solid() || !member.body->solid()->constants->nodal()) continue;
      space::Body body = *member.body;
      auto& solid = std::get<space::Solid>(body.shape);
      space::SolidConstants constants = *solid.constants;
      solid::order_coordinates(constants, slices);
      set_derived(constants);
      solid.constants = std::make_shared<const space::SolidConstants>(std::move(constants));
      member.body = std::make_shared<const space::Body>(std::move(body));
    }
  return system;
}

}  // namespace spoke::test
