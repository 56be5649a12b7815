// Repeats parts of shipped models.

#include "bench/growth_models.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "bench/box_mesh.h"
#include "bench/paper_rotor.h"

namespace spoke::bench {
namespace {

constexpr int kElements = 4, kBodies = 4;
constexpr double kCell = 0.1;  // m

BoxSize size_of_bar(int cells) {
  return {{cells, 2, 2}, {kCell * cells, 2.0 * kCell, 2.0 * kCell}};
}

Scenario read_model(const char* file) {
  Scenario scenario = read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / file);
  scenario.sensors.clear();
  return scenario;
}

Scenario make_chain(const char* file, const RotorSize& size) {
  Scenario scenario = sized_rotor(file, size, false);
  scenario.sensors.clear();
  return scenario;
}

}  // namespace

Scenario chain_in_space(int bodies) {
  return make_chain("spatial_wu_haug.toml", {1, bodies, kElements});
}

Scenario chain_in_plane(int bodies) {
  return make_chain("paper_rotor.toml", {1, bodies, kElements});
}

Scenario rotor_in_space(int blades) {
  return make_chain("spatial_wu_haug.toml", {blades, kBodies, kElements});
}

Scenario sprung_rotor(int blades, int bodies, int springs) {
  Scenario scenario = make_chain("spatial_wu_haug.toml", {blades, bodies, kElements});
  for (spatial::Blade& blade : scenario.space->blades) {
    const double length = blade.beam.length;
    for (int k = 0; k < springs; ++k) {
      Loop& spring = blade.loops.emplace_back();
      spring.name = "spring_" + std::to_string(k + 1);
      spring.kind = LoopKind::distance;
      spring.from.station = length * (k + 1) / springs;
      spring.to.carrier = LoopPlace::Carrier::hub;
      spring.to.point = spatial::Vector(0.0, 0.0, 1.0);
      spring.stiffness = {1.0};  // N/m
    }
  }
  return scenario;
}

Scenario nodal_bar(int cells) {
  Scenario scenario = read_model("four_bar.toml");
  const auto plane_at = [](double x) {
    return spatial::PlaneNodes{spatial::Vector(x, 0.0, 0.0), spatial::Vector::UnitX(), 1e-6};
  };
  spatial::SolidBody body;
  body.mesh = std::make_shared<const spatial::SolidMesh>(make_box_mesh(size_of_bar(cells)));
  body.material = spatial::SolidMaterial{7e10, 0.33, 2700.0};
  body.interfaces.push_back({"root", plane_at(0.0), spatial::InterfaceKind::rigid, {}});
  body.coordinates = spatial::SolidCoordinates::nodal;
  spatial::Model model;
  model.hub.drive = ConstantSpeed{5.0};
  spatial::Subsystem& subsystem = model.subsystems.emplace_back();
  subsystem.name = "bar";
  subsystem.bodies = {{"bar", std::move(body)}};
  spatial::SubsystemJoint& joint = subsystem.joints.emplace_back();
  joint.parent = "hub";
  joint.child = "bar";
  joint.joint.kind = spatial::JointKind::fixed;
  scenario.space = std::move(model);
  scenario.integration.step = 1e-3;
  return scenario;
}

int count_unknowns(int cells) {
  const BoxSize size = size_of_bar(cells);
  int nodes = 1;
  for (const int along : size.cells) nodes *= 2 * along + 1;
  return 3 * nodes;
}

}  // namespace spoke::bench
