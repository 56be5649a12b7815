// Finds the shipped scenarios, and adds variations.

#include "tests/engine/laws/zoo.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <utility>

#include "tests/shipped.h"

namespace spoke::test {
namespace {

/// Lets the free hinges of joints relax.
void make_relaxing(Scenario& scenario) {
  for (spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (spatial::SubsystemJoint& joint : subsystem.joints)
      for (spatial::JointCoordinate& coordinate : joint.joint.coordinates)
        if (joint.joint.kind != spatial::JointKind::spherical && !coordinate.motion)
          coordinate.relaxation = {200.0, 0.02};
}

/// Holds the panel on a cross-coupled bearing, and the antenna on one whose matrices depend on its
/// speed.
void put_on_bearings(Scenario& scenario) {
  const auto make = [](double xx, double xy, double yx, double yy) {
    return Eigen::Matrix2d{{xx, xy}, {yx, yy}};
  };
  Loop panel;
  panel.name = "panel_bearing";
  panel.kind = LoopKind::bearing;
  panel.from.name = "panel";
  panel.from.station = 2.0;
  panel.to.carrier = LoopPlace::Carrier::hub;
  panel.to.point = {3.6, 2.2, 0.0};
  panel.axes[0] = {0.0, 1.0, 0.0};
  panel.matrices = BearingMatrices{{}, {make(200, 60, -60, 150)}, {make(4, 1, -1, 3)}};
  Loop antenna = panel;
  antenna.name = "antenna_bearing";
  antenna.from = {.name = "antenna", .point = {0.25, 0.0, 0.0}};
  antenna.to = {.name = "boom", .station = 6.0, .point = {0.25, 0.0, 0.0}};
  antenna.axes[0] = {1.0, 0.0, 0.0};
  antenna.matrices = BearingMatrices{{-1.0, 0.0, 2.0},
                                     {make(30, 5, 0, 20), make(20, -5, 5, 30), make(40, 0, 9, 40)},
                                     {make(1, 0, 0, 1), make(2, 1, -1, 2), make(1, 0, 0, 3)}};
  scenario.space->subsystems.at(0).loops = {panel, antenna};
}

/// Gives solids the coordinates of all nodes.
void make_nodal(Scenario& scenario) {
  for (spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (spatial::Body& body : subsystem.bodies)
      if (auto* solid = std::get_if<spatial::SolidBody>(&body.shape)) {
        solid->coordinates = spatial::SolidCoordinates::nodal;
        solid->modes.reset();
        solid->damping.clear();
      }
}

/// Gives drag to all beams and rigid bodies, in wind that blows across them.
void put_in_wind(Scenario& scenario) {
  spatial::Air& air = scenario.space->air.emplace();
  air.wind.velocity = {12.0, 5.0, -3.0};
  for (spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (spatial::Body& body : subsystem.bodies) {
      if (const auto* beam = std::get_if<spatial::Beam>(&body.shape))
        body.drag = spatial::BodyDrag{
            .station = {0.0, beam->length}, .diameter = {0.1, 0.05}, .coefficient = {1.0, 1.2}};
      else if (std::holds_alternative<spatial::RigidBody>(body.shape))
        body.drag = spatial::BodyDrag{.area = {0.02, 0.03, 0.05}, .point = {0.0, 0.02, 0.05}};
    }
}

/// Puts a turbine into wind, whose blades pass the tower.
void put_past_tower(Scenario& scenario) {
  const Scenario in_wind = read_shipped("nrel_5mw_in_wind");
  spatial::Model& model = *scenario.space;
  model.air = in_wind.space->air;
  model.air->wind = Wind{};
  model.air->wind.velocity = {9.0, 0.0, 0.0};
  model.air->attached_flow = spatial::AttachedFlow::unsteady;
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    model.blades[i].aerodynamics = in_wind.space->blades[i].aerodynamics;
  for (spatial::Body& body : model.subsystems.back().bodies)
    if (const auto* beam = std::get_if<spatial::Beam>(&body.shape)) {
      body.drag = spatial::BodyDrag{
          .station = {0.0, beam->length}, .diameter = {6.0, 3.87}, .coefficient = {0.5, 0.5}};
      body.drag->potential = spatial::TowerPotential::bak;
      body.drag->shadow = spatial::TowerShadow::powles;
    }
}

/// Ties each blade to the next one by a damper and a spring, and couples their hinges.
void tie_ring(Scenario& scenario) {
  std::vector<spatial::Blade>& blades = scenario.space->blades;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    Loop damper;
    damper.name = "damper";
    damper.kind = LoopKind::distance;
    damper.from = {.station = 0.7, .point = {0.0, 0.2, 0.0}};
    damper.to = {
        .carrier = LoopPlace::Carrier::elsewhere, .station = 0.7, .point = {0.0, -0.2, 0.0}};
    damper.to.blade = static_cast<int>((i + 1) % blades.size()) + 1;
    damper.stiffness = {2000.0};
    damper.damping = {300.0};
    blades[i].loops = {damper};
    Coupling linkage{"linkage", {{blades[i].joints[0].joint.name, 1, 1.0}}, 200.0, 5.0};
    linkage.joints.push_back(linkage.joints[0]);
    linkage.joints[1].ratio = -1.0;
    linkage.joints[1].blade = damper.to.blade;
    blades[i].couplings = {linkage};
  }
}

/// Ties blades as a ring, and the first one across the axle to what the rotor stands on.
void tie_blades(Scenario& scenario) {
  tie_ring(scenario);
  Loop spring;
  spring.name = "spring";
  spring.from.station = 1.5;
  spring.to = {.carrier = LoopPlace::Carrier::elsewhere, .name = "cabin", .point = {0.0, 0.0, 1.5}};
  spring.to.subsystem = "support";
  spring.stiffness = {20.0, 20.0, 20.0};
  spring.damping = {5.0, 5.0, 5.0};
  scenario.space->blades[0].loops.push_back(spring);
}

/// Puts a rotor with a hinged vane on a soft boom that turns with the first rotor.
void put_rotor_on_rotor(Scenario& scenario) {
  spatial::Model& model = *scenario.space;
  const auto add = [&model](spatial::Body body, int rotor, const spatial::Joint& joint) {
    spatial::Subsystem made;
    made.name = body.name;
    made.rotor = rotor;
    made.joints.emplace_back().child = body.name;
    made.joints.back().joint = joint;
    made.bodies.push_back(std::move(body));
    model.subsystems.insert(model.subsystems.end() - 1, std::move(made));  // before the support
  };
  spatial::Joint joint;
  joint.offset = {0.0, 0.0, 0.05};
  add({"boom", model.blades[0].beam}, 0, joint);
  spatial::Rotor& top = model.rotors.emplace_back();
  top.hub.name = "top";
  top.hub.mass = 0.002;
  top.hub.inertia = 1e-7 * spatial::Tensor::Identity();
  top.hub.drive = ConstantSpeed{60.0};
  top.axle.subsystem = top.axle.body = "boom";
  joint.kind = spatial::JointKind::revolute;
  joint.name = "vane";
  joint.axes[0] = spatial::Vector::UnitY();
  joint.coordinates[0].initial = 0.05;
  add({"vane", spatial::RigidBody{0.003, {0.03, 0.002, 0.0}, 2e-6 * spatial::Tensor::Identity()}},
      count_rotors(model) - 1, joint);
}

/// Gives each rotor three equal blades in place of its own.
void take_three_blades(Scenario& scenario) {
  std::vector<spatial::Blade> blades;
  for (const spatial::Blade& blade : scenario.space->blades) {
    if (!blades.empty() && blades.back().rotor == blade.rotor) continue;
    for (int k = 0; k < 3; ++k) {
      blades.push_back(blade);
      blades.back().azimuth = 2.0 * std::numbers::pi * k / 3.0;
    }
  }
  scenario.space->blades = std::move(blades);
}

}  // namespace

Scenario ZooModel::read(int steps) const {
  Scenario scenario = read_shipped(file);
  if (vary) vary(scenario);
  scenario.integration.duration = steps * scenario.integration.step;
  return scenario;
}

std::vector<ZooModel> list_zoo() {
  std::vector<ZooModel> zoo{
      {"articulated_rotor, a ring of dampers", "articulated_rotor", tie_ring},
      {"articulated_rotor, hub by a torque", "articulated_rotor",
       [](Scenario& s) { s.space->hub.drive = TorqueDrive{Curve(1000.0)}; }},
      {"free_hub_satellite, strains of second order", "free_hub_satellite",
       [](Scenario& s) {
         for (Blade& blade : s.rotor.blades) blade.strain = BeamStrain::nonlinear;
       }},
      {"helicopter_on_gear, blades tied", "helicopter_on_gear", tie_blades},
      {"nrel_5mw_turbine, with a drive train", "nrel_5mw_turbine",
       [](Scenario& s) {
         s.space->hub.inertia = 115926.0 * spatial::Tensor::Identity();
         s.space->support->axle.train = spatial::DriveTrain{867.637e6, 6.215e6, 97.0, 534.116};
       }},
      {"nrel_5mw_turbine, past its tower", "nrel_5mw_turbine", put_past_tower},
      {"quadcopter, a rotor on a rotor", "quadcopter", put_rotor_on_rotor},
      {"quadcopter, of three blades", "quadcopter", take_three_blades},
      {"solid_blade_rotor, nodal", "solid_blade_rotor", make_nodal},
      {"tree_of_bodies, in the wind", "tree_of_bodies", put_in_wind},
      {"tree_of_bodies, on bearings", "tree_of_bodies", put_on_bearings},
      {"tree_of_bodies, relaxing", "tree_of_bodies", make_relaxing},
      {"tree_of_bodies, with a spin", "tree_of_bodies",
       [](Scenario& s) {
         for (spatial::Subsystem& subsystem : s.space->subsystems)
           for (spatial::Body& body : subsystem.bodies)
             if (auto* rigid = std::get_if<spatial::RigidBody>(&body.shape))
               rigid->spin = {0.2, -0.3, 0.5};
       }},
      {"wu_haug_rotor, free hub", "wu_haug_rotor",
       [](Scenario& s) {
         s.rotor.hub.support = HubSupport::free;
         s.rotor.hub.mass = 5.0;
         s.rotor.hub.inertia = 1.0;
         s.rotor.hub.drive = TorqueDrive{Curve(20.0), 0.05};
       }},
  };
  for (const auto& entry : std::filesystem::directory_iterator(SPOKE_MODELS_DIR)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".toml" && name != "large_rotor")
      zoo.push_back({name, name, {}});
  }
  std::sort(zoo.begin(), zoo.end(),
            [](const ZooModel& a, const ZooModel& b) { return a.name < b.name; });
  return zoo;
}

}  // namespace spoke::test
