// Tests that sensors obey the laws of mechanics, whatever formulation and integrator.

#include "engine/simulation/sensors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "tests/approx.h"
#include "tests/engine/load_rotors.h"
#include "tests/engine/serial.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

using Quantity = SensorQuantity;
using Values = std::map<std::string, double>;

Sensor make_sensor(Quantity quantity, const std::string& name, SensorFrame frame,
                   std::optional<double> position = {}) {
  Sensor sensor;
  sensor.quantity = quantity;
  sensor.name = name;
  sensor.frame = frame;
  sensor.position = position;
  return sensor;
}

Values values_of(const Simulation& simulation) {
  Values values;
  for (std::size_t i = 0; i < simulation.sensor_names().size(); ++i)
    values[simulation.sensor_names()[i]] = simulation.sensor_values()[i];
  return values;
}

/// Returns the planar vector of three sensors in a row.
Twist vector_of(const Values& values, const std::string& name, const char* third) {
  return {values.at(name + ".x"), values.at(name + ".y"), values.at(name + "." + third)};
}

double cross(const Position& a, const Position& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Way {
  Formulation formulation;
  IntegrationMethod method;
};
const std::vector<Way> kWays{{Formulation::structured, IntegrationMethod::generalized_alpha},
                             {Formulation::structured, IntegrationMethod::rk4},
                             {Formulation::subsystem, IntegrationMethod::generalized_alpha},
                             {Formulation::subsystem, IntegrationMethod::rk4},
                             {Formulation::augmented, IntegrationMethod::generalized_alpha},
                             {Formulation::augmented, IntegrationMethod::rk4}};

/// Sensors at three neighbouring steps.
struct Neighbours {
  Values before, now, after;
  double step = 0.0;

  /// Returns the central difference of a vector.
  Twist rate(const std::string& name, const char* third) const {
    return (vector_of(after, name, third) - vector_of(before, name, third)) / (2.0 * step);
  }
};

Neighbours run_to(double t, const Scenario& scenario, Formulation formulation) {
  Simulation simulation(scenario, serial(formulation));
  simulation.run_until(t);
  Neighbours values;
  values.step = simulation.step_size();
  values.before = values_of(simulation);
  simulation.step();
  values.now = values_of(simulation);
  simulation.step();
  values.after = values_of(simulation);
  return values;
}

/// Makes two blades that hardly deform.
Scenario rigid_scenario() {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.3, 1e-3);
  scenario.integration.spectral_radius = 0.0;
  scenario.integration.iterations = 6;  // stiff: a tolerance of places is none of forces
  for (Blade& blade : scenario.rotor.blades) blade.youngs_modulus = 1e16;
  return scenario;
}

}  // namespace

TEST_CASE("a rigid blade bears the centrifugal force and the inertia of what is outboard") {
  Scenario scenario = rigid_scenario();
  for (const double x : {0.0, 0.25, 1.0, 1.7})
    scenario.sensors.push_back(
        make_sensor(Quantity::section_force, "at" + std::to_string(x), SensorFrame::section, x));
  Simulation simulation(scenario, serial(Formulation::structured));
  for (const double t : {0.06, 0.3}) {  // on the way up, and at full speed
    simulation.run_until(t);
    const HubMotion hub = simulation.hub();
    const double w = hub.velocity[kRotation], alpha = hub.acceleration[kRotation];
    const double density = 0.1, end = 2.1;  // kg/m; m from the axis
    for (const double x : {0.0, 0.25, 1.0, 1.7}) {
      const double r = 0.1 + x, first = density * (end * end - r * r) / 2.0;
      const double second =
          density * ((end * end * end - r * r * r) / 3.0 - r * (end * end - r * r) / 2.0);
      for (const char* blade : {"blade1.at", "blade2.at"}) {
        const Twist load = vector_of(values_of(simulation), blade + std::to_string(x), "moment");
        CHECK(load[0] == approx(w * w * first).epsilon(1e-5));
        CHECK(std::abs(load[1] + alpha * first) < 1e-5 * (std::abs(alpha) + 1.0) * first);
        CHECK(std::abs(load[2] + alpha * second) < 1e-5 * (std::abs(alpha) + 1.0) * second);
      }
    }
  }
}

TEST_CASE("a hanging blade bears the weight outboard, a horizontal one its moment too") {
  Scenario scenario = rigid_scenario();
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.damping.stiffness_factor = 1e-2;
  scenario.rotor.gravity = Position{0.0, -9.81};
  scenario.rotor.blades[0].azimuth = -std::numbers::pi / 2.0;
  scenario.rotor.blades[1].azimuth = 0.0;
  scenario.sensors = {make_sensor(Quantity::section_force, "mid", SensorFrame::section, 0.6),
                      make_sensor(Quantity::section_force, "root", SensorFrame::inertial, 0.0)};
  scenario.sensors[1].name = "foot";
  Simulation simulation(scenario, serial(Formulation::structured));
  simulation.run_until(0.3);
  const Values values = values_of(simulation);
  const double weight = 0.1 * 9.81;  // N/m
  CHECK(values.at("blade1.mid.x") == approx(1.4 * weight).epsilon(1e-6));
  CHECK(std::abs(values.at("blade1.mid.y")) < 1e-6);
  CHECK(values.at("blade1.root.x") == approx(2.0 * weight).epsilon(1e-6));
  CHECK(values.at("blade2.mid.y") == approx(-1.4 * weight).epsilon(1e-6));
  CHECK(values.at("blade2.mid.moment") == approx(-1.4 * 0.7 * weight).epsilon(1e-6));
  CHECK(values.at("blade2.root.y") == approx(-2.0 * weight).epsilon(1e-6));
  CHECK(values.at("blade2.root.moment") == approx(-2.0 * weight).epsilon(1e-6));
  for (const char* blade : {"blade1", "blade2"})
    CHECK(values.at(std::string(blade) + ".foot.y") == approx(-2.0 * weight).epsilon(1e-6));
}

TEST_CASE("behind a joint the balance of all that acts outboard is what the joint bears") {
  for (const Way& way : kWays)
    for (const double at : {1.0, 0.0}) {  // where the second body begins, and on the first
      Scenario scenario = soft_scenario(way.method, 0.02, 1e-5);
      Rotor& rotor = scenario.rotor;
      rotor.gravity = Position{1.0, -9.81};
      rotor.gravity_ramp = 0.03;
      for (Blade& blade : rotor.blades) {
        const double EA = blade.youngs_modulus * blade.area;
        const double EI = blade.youngs_modulus * blade.second_moment;
        blade.geometric_stiffening = false;
        blade.density = blade.area = blade.second_moment = blade.youngs_modulus = 0.0;
        blade.sections = {
            {0.0, 1.3, 2.0}, {0.2, 0.1, 0.05}, {EA, EA, 0.5 * EA}, {EI, EI, 0.5 * EI}};
        blade.point_masses = {{.position = 1.4, .mass = 0.05}, {.position = 2.0, .mass = 0.02}};
      }
      DistributedLoad load;
      load.from = 0.37;
      load.to = 1.81;
      load.force_per_length = Position{0.1, 0.4};
      load.moment_per_length = 0.03;
      rotor.distributed_loads = {load};
      Drag drag;
      drag.quadratic_per_length = 0.2;
      drag.linear = 0.1;
      rotor.drags = {drag, drag};
      rotor.drags[1].relative_to = DragFrame::hub;
      scenario.sensors = {
          make_sensor(Quantity::joint_reaction, "joint", SensorFrame::hub),
          // The section is beside the joint: at the joint it is the root or that of the body
          // inboard.
          make_sensor(Quantity::section_force, "section", SensorFrame::hub, at + 1e-9)};
      scenario.sensors[0].joint = JointChoice::number(at == 0.0 ? 1 : 2);
      Simulation simulation(scenario, serial(way.formulation));
      simulation.run_until(0.015);
      const Values values = values_of(simulation);
      for (const std::string blade : {"blade1.", "blade2."}) {
        const Twist joint = vector_of(values, blade + "joint", "moment");
        const Twist section = vector_of(values, blade + "section", "moment");
        CHECK(joint.norm() > 0.1);
        CHECK((joint + section).norm() < 1e-6 * joint.norm());
      }
    }
}

TEST_CASE("momentum changes as the forces on hub and blades say") {
  for (const Way& way : kWays)
    for (const bool is_free : {false, true}) {
      Scenario scenario = soft_scenario(way.method, 0.1, 1e-4);
      Rotor& rotor = scenario.rotor;
      rotor.hub.drive = SpinUp{3.0, 0.2};
      if (is_free) {
        rotor.hub.support = HubSupport::free;
        rotor.hub.drive = TorqueDrive{Curve(0.4), 2.0};
      }
      rotor.gravity = Position{1.0, -9.81};
      rotor.blades[1].length = 1.6;
      PointLoad load;
      load.blade = BladeChoice::number(2);
      load.position = 0.8;
      load.moment = 0.05;
      rotor.loads.push_back(load);
      for (const Quantity quantity :
           {Quantity::momentum, Quantity::blade_momentum, Quantity::hub_reaction})
        scenario.sensors.push_back(make_sensor(quantity, "", SensorFrame::inertial));
      scenario.sensors.push_back(
          make_sensor(Quantity::section_force, "foot", SensorFrame::inertial, 0.0));
      const Neighbours steps = run_to(0.05, scenario, way.formulation);

      const double mass[]{0.2, 0.16};
      const Position g = rotor.gravity;
      const Twist reaction = vector_of(steps.now, "hub_reaction", "moment");
      const Twist total = steps.rate("momentum", "angular");
      const Position force = Position(reaction.head<kPosition>()) + (0.36 + 0.3) * g;
      CHECK((Position(total.head<kPosition>()) - force).norm() < 1e-3 * force.norm());
      for (const int i : {0, 1}) {
        const std::string blade = "blade" + std::to_string(i + 1);
        const Twist rate = steps.rate(blade + ".blade_momentum", "angular");
        const Position foot = vector_of(steps.now, blade + ".foot", "moment").head<kPosition>();
        const Position pull = mass[i] * g - foot;
        CHECK((Position(rate.head<kPosition>()) - pull).norm() < 1e-3 * pull.norm());
      }
    }
}

TEST_CASE("angular momentum changes by the moments of drive, roots and loads") {
  for (const Way& way : kWays) {
    Scenario scenario = soft_scenario(way.method, 0.1, 1e-4);
    Rotor& rotor = scenario.rotor;
    rotor.hub.drive = SpinUp{6.0, 0.1};
    PointLoad load;
    load.blade = BladeChoice::number(2);
    load.position = 2.0;
    load.moment = 0.05;
    rotor.loads.push_back(load);
    for (const Quantity quantity : {Quantity::momentum, Quantity::blade_momentum})
      scenario.sensors.push_back(make_sensor(quantity, "", SensorFrame::inertial));
    scenario.sensors.push_back(make_sensor(Quantity::section_force, "foot", SensorFrame::hub, 0.0));
    const Neighbours steps = run_to(0.05, scenario, way.formulation);
    const double moment = steps.now.at("hub.torque") + 0.05;
    CHECK(steps.rate("momentum", "angular")[kRotation] == approx(moment).epsilon(1e-3));
    double sum = steps.now.at("hub.torque");
    for (const int i : {0, 1}) {
      const std::string blade = "blade" + std::to_string(i + 1);
      const Twist foot = vector_of(steps.now, blade + ".foot", "moment");
      const Position root{i == 0 ? 0.1 : -0.1, 0.0};
      const double about_axis = cross(root, foot.head<kPosition>()) + foot[kRotation];
      CHECK(steps.rate(blade + ".blade_momentum", "angular")[kRotation] ==
            approx(i * 0.05 - about_axis).epsilon(2e-3));
      CHECK(std::abs(about_axis) > 0.1);
      sum += about_axis;
    }
    // The torque that the blades do not take turns the hub.
    const double alpha = 60.0 * (1.0 - std::cos(2.0 * std::numbers::pi * 0.501));
    CHECK(sum == approx(rotor.hub.inertia * alpha).epsilon(1e-6));
  }
}

TEST_CASE("the torque of a spin-up is what the roots of the blades and the hub take") {
  for (const Formulation formulation : formulations()) {
    Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.005);
    scenario.rotor.hub.inertia = 2.0;
    Simulation simulation(scenario, serial(formulation));
    simulation.run_until(7.0);
    double moment = 2.0 * simulation.hub().acceleration[kRotation];
    for (const char* blade : {"blade1", "blade2", "blade3"})
      moment -= simulation.sensor(std::string(blade) + ".root.moment");
    CHECK(moment == approx(simulation.sensor("hub.torque")).epsilon(1e-9));
  }
}

TEST_CASE("velocity and acceleration are the derivatives of displacement in every frame") {
  for (const Way& way : kWays) {
    Scenario scenario = soft_scenario(way.method, 0.05, 1e-5);
    scenario.rotor.hub.support = HubSupport::free;
    scenario.rotor.hub.drive = TorqueDrive{Curve(1.0), 2.0};
    scenario.rotor.gravity = Position{1.0, -9.81};
    for (const SensorFrame frame : {SensorFrame::hub, SensorFrame::blade, SensorFrame::inertial})
      for (const std::optional<double> position :
           {std::optional<double>{}, std::optional<double>{0.6}, std::optional<double>{1.3}})
        for (const auto& [quantity, letter] :
             {std::pair{Quantity::displacement, 'd'}, std::pair{Quantity::velocity, 'v'},
              std::pair{Quantity::acceleration, 'a'}})
          scenario.sensors.push_back(make_sensor(
              quantity,
              std::string(name_of(frame)) + std::to_string(position.value_or(2.0)) + letter, frame,
              position));
    if (way.formulation == Formulation::augmented) scenario.integration.duration = 0.01;
    const Neighbours steps = run_to(0.8 * scenario.integration.duration, scenario, way.formulation);
    for (const std::string blade : {"blade1.", "blade2."})
      for (const char* frame : {"hub", "blade", "inertial"})
        for (const char* place : {"2.000000", "0.600000", "1.300000"}) {
          const std::string name = blade + frame + place;
          const Twist v = vector_of(steps.now, name + "v", "rotation");
          const Twist a = vector_of(steps.now, name + "a", "rotation");
          CHECK((steps.rate(name + "d", "rotation") - v).norm() < 1e-5 * v.norm());
          CHECK((steps.rate(name + "v", "rotation") - a).norm() < 5e-3 * a.norm());
        }
  }
}

TEST_CASE("the tip's columns are its displacement, resolved along the blade") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.2);
  scenario.rotor.blades[0].azimuth = 0.7;
  scenario.sensors = {make_sensor(Quantity::displacement, "hubs", SensorFrame::hub),
                      make_sensor(Quantity::displacement, "own", SensorFrame::blade)};
  Simulation simulation(scenario);
  simulation.run_until(0.2);
  const Values values = values_of(simulation);
  for (const std::string blade : {"blade1", "blade2"}) {
    CHECK(std::abs(values.at(blade + ".tip.across")) > 1e-3);
    CHECK(values.at(blade + ".hubs.x") == approx(values.at(blade + ".tip.x")).epsilon(1e-9));
    CHECK(values.at(blade + ".hubs.y") == approx(values.at(blade + ".tip.y")).epsilon(1e-9));
    CHECK(values.at(blade + ".own.x") == approx(values.at(blade + ".tip.along")).epsilon(1e-9));
    CHECK(values.at(blade + ".own.y") == approx(values.at(blade + ".tip.across")).epsilon(1e-9));
  }
  const double c = std::cos(0.7), s = std::sin(0.7);
  CHECK(values.at("blade1.tip.along") ==
        approx(c * values.at("blade1.tip.x") + s * values.at("blade1.tip.y")));
}

TEST_CASE("section forces are continuous where bodies meet, and turn with their frames") {
  for (const Way& way : kWays) {
    Scenario scenario = soft_scenario(way.method, 0.02, 1e-4);
    scenario.rotor.gravity = Position{1.0, -9.81};
    scenario.rotor.hub.drive = SpinUp{6.0, 0.02};
    PointLoad load;
    load.position = 1.5;
    load.force = Position{0.1, 0.2};
    load.moment = 0.03;
    for (const LoadFrame frame : {LoadFrame::section, LoadFrame::inertial}) {
      load.frame = frame;
      scenario.rotor.loads.push_back(load);
    }
    for (const SensorFrame frame :
         {SensorFrame::section, SensorFrame::blade, SensorFrame::hub, SensorFrame::inertial})
      scenario.sensors.push_back(make_sensor(
          Quantity::section_force, "s." + std::string(name_of(frame)), frame, 1.0 + 2e-8));
    Sensor joint = make_sensor(Quantity::joint_reaction, "joint", SensorFrame::blade);
    joint.joint = JointChoice::number(2);
    scenario.sensors.push_back(joint);
    scenario.sensors.push_back(
        make_sensor(Quantity::displacement, "turned", SensorFrame::blade, 1.0));
    Simulation simulation(scenario, serial(way.formulation),
                          {steady_load({0, 1, 0.8}, 0.3, 0.1, 0.02)});
    simulation.run_until(0.02);
    const Values values = values_of(simulation);
    for (const int i : {0, 1}) {
      const std::string blade = "blade" + std::to_string(i + 1);
      const Twist own = vector_of(values, blade + ".s.blade", "moment");
      const Twist reaction = vector_of(values, blade + ".joint", "moment");
      CHECK((own + reaction).norm() < 1e-5 * own.norm());
      const auto turned = [&](double angle) { return plane::Rotation::from_angle(angle) * own; };
      const double azimuth = std::numbers::pi * i, hub = values.at("hub.angle");
      const Twist in_hub = vector_of(values, blade + ".s.hub", "moment");
      const Twist inertial = vector_of(values, blade + ".s.inertial", "moment");
      const Twist section = vector_of(values, blade + ".s.section", "moment");
      CHECK((in_hub - turned(azimuth)).norm() < 1e-12 * own.norm());
      CHECK((inertial - turned(azimuth + hub)).norm() < 1e-12 * own.norm());
      CHECK((section - turned(-values.at(blade + ".turned.rotation"))).norm() < 1e-6 * own.norm());
    }
  }
}

TEST_CASE("energies of blades and hub are the total") {
  Scenario scenario = soft_scenario(IntegrationMethod::generalized_alpha, 0.1, 1e-3);
  for (const Quantity quantity : {Quantity::kinetic_energy, Quantity::strain_energy})
    scenario.sensors.push_back(make_sensor(quantity, "", SensorFrame::inertial));
  Simulation simulation(scenario);
  simulation.run_until(0.1);
  const Values values = values_of(simulation);
  const double speed = values.at("hub.speed");
  const double sum = 0.5 * scenario.rotor.hub.inertia * speed * speed +
                     values.at("blade1.kinetic_energy") + values.at("blade2.kinetic_energy");
  CHECK(sum == approx(values.at("energy.kinetic")).epsilon(1e-13));
  const double strain = values.at("blade1.strain_energy") + values.at("blade2.strain_energy");
  CHECK(values.at("blade1.strain_energy") > 0.0);
  CHECK(strain == approx(values.at("energy.strain")).epsilon(1e-13));
}
