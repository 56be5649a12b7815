// A rotor on what carries it, built in code: three rods on lag hinges turn on soft springs, which
// is ground resonance if the springs are unlucky; then the same rotor at the tip of a mast that
// bends.

#include <spoke/spoke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace spatial = spoke::spatial;

namespace {

constexpr double speed = 25.0, rod = 20.0, length = 5.0;  // rad/s, kg, m
constexpr double stiffness = 1e7;                         // of the mast in bending, N m^2

/// Returns a scenario of the rotor alone, its axle held in space; `damper`: of its hinges [N m s].
spoke::Scenario make_rotor(double damper) {
  spoke::Scenario scenario;
  spatial::Model& model = scenario.space.emplace();
  model.hub.mass = 100.0;
  model.hub.inertia = 5.0 * spatial::Tensor::Identity();
  model.hub.drive = spoke::ConstantSpeed{speed};
  for (int i = 0; i < 3; ++i) {
    const double inertia = rod * length * length / 12.0;
    spatial::Subsystem blade{.name = "blade" + std::to_string(i + 1)};
    blade.azimuth = 2.0 * std::numbers::pi * i / 3;
    blade.bodies = {
        {"rod",
         spatial::RigidBody{rod,
                            {length / 2, 0.0, 0.0},
                            spatial::Tensor(Eigen::Vector3d(0.2, inertia, inertia).asDiagonal())}}};
    spatial::SubsystemJoint hinge{.child = "rod"};
    hinge.joint.name = "lag";
    hinge.joint.kind = spatial::JointKind::revolute;
    hinge.joint.offset = {0.3, 0.0, 0.0};
    hinge.joint.axes[0] = {0.0, 0.0, 1.0};
    hinge.joint.coordinates[0] = {.stiffness = 400.0, .damping = damper};
    blade.joints = {hinge};
    model.subsystems.push_back(blade);
  }
  // A push sideways, 0.2 s long.
  model.hub_loads = {{.frame = spatial::LoadFrame::inertial,
                      .force = {10.0, 10.0, 0.0},
                      .factor = spoke::Curve({0.0, 0.1, 0.2}, {0.0, 1.0, 0.0})}};
  scenario.integration.step = 0.002;
  scenario.integration.duration = 6.0;
  return scenario;
}

/// Returns the largest lag of all blades from one time to another [rad].
double find_largest_lag(spoke::Simulation& simulation, double end) {
  const std::size_t lag[] = {simulation.sensor_index("blade1.lag"),
                             simulation.sensor_index("blade2.lag"),
                             simulation.sensor_index("blade3.lag")};
  double largest = 0.0;
  simulation.run_until(end, [&](double, std::span<const double> sensors) {
    for (const std::size_t blade : lag) largest = std::max(largest, std::abs(sensors[blade]));
  });
  return largest;
}

/// Returns by which factor the lag grows in a second on springs.
double find_growth(double damper) {
  spoke::Scenario scenario = make_rotor(damper);
  spatial::suspend({.stiffness = {2.0e5, 1.4e5},  // N/m along x and y; the rest is held
                    .damping = {1500.0, 1500.0},
                    .mass = 500.0,
                    .inertia = 100.0 * spatial::Tensor::Identity()},
                   *scenario.space);
  spoke::Simulation simulation(scenario);
  find_largest_lag(simulation, 4.0);
  const double before = find_largest_lag(simulation, 5.0);
  return find_largest_lag(simulation, 6.0) / before;
}

/// Returns by how much the tip of a mast of 10 m yields to a force on the hub [m].
double find_deflection(double force) {
  spoke::Scenario scenario = make_rotor(100.0);
  spatial::Model& model = *scenario.space;
  model.hub.drive = spoke::FixedDrive{};
  model.hub_loads = {
      {.frame = spatial::LoadFrame::inertial, .force = {0.0, force, 0.0}, .ramp = 5.0}};
  spatial::Beam mast{.length = 10.0, .bodies = 2};
  mast.sections.station = {0.0, 10.0};
  mast.sections.mass_per_length = {50.0, 50.0};
  mast.sections.axial_stiffness = {1e9, 1e9};
  mast.sections.flap_stiffness = mast.sections.lag_stiffness = {stiffness, stiffness};
  mast.sections.torsion_stiffness = {stiffness, stiffness};
  spatial::Subsystem tree{.name = std::string(spatial::kSupportName)};
  tree.bodies = {{"mast", mast}};
  spatial::SubsystemJoint foot{
      .parent = std::string(spatial::base_name(spatial::SupportBase::ground)), .child = "mast"};
  foot.joint.orientation = {0.0, -std::numbers::pi / 2, 0.0};  // x of a beam is up
  tree.joints = {foot};
  model.subsystems.push_back(tree);  // the support is the last one
  model.support =
      spatial::Support{.axle = {.body = "mast", .orientation = {0.0, std::numbers::pi / 2, 0.0}}};
  spoke::Simulation simulation(scenario);
  simulation.run_until(INFINITY);
  return simulation.sensor("hub.y");
}

}  // namespace

int main() {
  // By Coleman and Feingold's equations the motion grows by the factor 3.81 a second.
  const double grows = find_growth(0.0), settles = find_growth(2000.0);
  std::printf(
      "a second later the lag is %.2f times as large, with dampers on the hinges %.2f times\n",
      grows, settles);
  constexpr double force = 1000.0;
  const double deflection = find_deflection(force), formula = force * 1e3 / (3.0 * stiffness);
  std::printf("the mast yields by %.5f m, by the formula %.5f m\n", deflection, formula);
  const bool is_fine = std::abs(grows / 3.81 - 1.0) < 0.05 && settles < 1.0 &&
                       std::abs(deflection / formula - 1.0) < 0.01;
  return is_fine ? 0 : 1;
}
