// A body from a finite-element mesh that a program makes itself: a bar of hexahedra with 20 nodes,
// clamped at one end, sags under its weight.

#include <spoke/spoke.h>

#include <cmath>
#include <cstdio>
#include <memory>

constexpr double length = 1.0, width = 0.04, height = 0.02;                      // m
constexpr double youngs_modulus = 2e11, poissons_ratio = 0.0, density = 7850.0;  // steel
constexpr int elements = 16;
constexpr double gravity = 9.81;

/// Makes the mesh: every whole section has 8 nodes, corners first, every middle one 4.
std::shared_ptr<const spoke::spatial::SolidMesh> make_bar() {
  spoke::spatial::SolidMesh mesh;
  const double y[] = {-0.5, 0.5, 0.5, -0.5, 0.0, 0.5, 0.0, -0.5};
  const double z[] = {-0.5, -0.5, 0.5, 0.5, -0.5, 0.0, 0.5, 0.0};
  for (int section = 0; section <= 2 * elements; ++section)
    for (int n = 0; n < (section % 2 == 0 ? 8 : 4); ++n)
      mesh.nodes.emplace_back(0.5 * section * length / elements, width * y[n], height * z[n]);
  for (int e = 0; e < elements; ++e) {
    spoke::spatial::SolidElement element{spoke::spatial::ElementKind::hex20};
    const int first = 12 * e, second = first + 12;  // sections at its two ends
    for (std::size_t n = 0; n < 4; ++n) {
      const int node = static_cast<int>(n);
      element.nodes[n] = first + node;  // corners
      element.nodes[4 + n] = second + node;
      element.nodes[8 + n] = first + 4 + node;  // middles of the sections' sides
      element.nodes[12 + n] = second + 4 + node;
      element.nodes[16 + n] = first + 8 + node;  // middles of the edges along the bar
    }
    mesh.elements.push_back(element);
  }
  mesh.sets = {{"ROOT", {}, {}}, {"TIP", {}, {}}};
  for (int n = 0; n < 8; ++n) {
    mesh.sets[0].nodes.push_back(n);
    mesh.sets[1].nodes.push_back(12 * elements + n);
  }
  return std::make_shared<const spoke::spatial::SolidMesh>(mesh);
}

int main() {
  spoke::spatial::SolidBody bar;
  bar.mesh = make_bar();
  bar.material = {youngs_modulus, poissons_ratio, density};
  bar.modes = 6;
  bar.damping = {0.1};
  bar.interfaces = {{.name = "root", .nodes = "ROOT"}, {.name = "tip", .nodes = "TIP"}};

  spoke::spatial::Subsystem arm{.name = "arm"};
  arm.bodies = {{"bar", bar}};
  arm.joints = {{.child = "bar"}};  // fixed to the hub

  spoke::Scenario scenario;
  scenario.space.emplace();
  scenario.space->hub.drive = spoke::FixedDrive{};
  scenario.space->gravity = {0.0, 0.0, -gravity};
  scenario.space->gravity_ramp = 0.5;
  scenario.space->subsystems = {arm};
  scenario.integration.duration = 1.5;
  scenario.integration.step = 0.002;

  spoke::Simulation simulation(scenario);
  simulation.run_until(1.5);
  const double tip = simulation.sensor("arm.tip.z");
  // A beam: rho A g L^4/(8 E I).
  const double beam =
      -1.5 * density * gravity * std::pow(length, 4) / (youngs_modulus * height * height);
  std::printf("the tip stands at %.6f m; a beam sags by %.6f m\n", tip, beam);
  return std::abs(tip / beam - 1.0) < 0.003 ? 0 : 1;
}
