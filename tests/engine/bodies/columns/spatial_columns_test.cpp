// Tests sensors of scenarios in space: forces by statics and reactions, motions by their
// derivatives.

#include "engine/bodies/columns/spatial_columns.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/bodies/kernels/space/joint_values.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/system/spatial_system.h"
#include "tests/approx.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

std::string sensor(const std::string& keys) { return "[[sensor]]\n" + keys + "\n"; }

/// A stiff blade of 2 m, whose mass per length falls from 2 to 1 kg/m, with a mass of 0.5 kg at
/// 1.3 m, 2 cm off the axis.
std::string make_blade(const std::string& hub, const std::string& more) {
  return "world = \"space\"\n" + hub + R"(
[blade]
count = 1
length = 2.0
bodies = 2
elements = 3
[blade.sections]
mass_per_length = [2.0, 1.0]
axial_stiffness = 1e9
lag_stiffness = 1e8
flap_stiffness = 1e8
torsion_stiffness = 1e8
twist = [0.4, 0.0]
[[blade.point_mass]]
position = 1.3
mass = 0.5
offset = [0.0, 0.02, 0.0]
)" + more +
         "[integration]\nduration = 1.0\n";
}

/// Mass outboard of x, and its first moment about x, without the point mass.
double mass_beyond(double x) { return 2.0 * (2.0 - x) - 0.25 * (4.0 - x * x); }
double moment_beyond(double x) {
  return (4.0 - x * x) - (8.0 - x * x * x) / 6.0 - x * mass_beyond(x);
}

constexpr std::array kPlaces{0.0, 0.2, 0.5, 1.0, 1.3, 1.31, 1.9};
std::string section_sensors(const std::string& frame) {
  std::string text;
  for (std::size_t k = 0; k < kPlaces.size(); ++k)
    text += sensor("name = \"f" + std::to_string(k) +
                   "\"\nquantity = \"section_force\"\nposition = " + std::to_string(kPlaces[k]) +
                   "\nframe = \"" + frame + "\"");
  return text;
}

const std::string kAllSensors = sensor("quantity = \"acceleration\"\nframe = \"inertial\"") +
                                sensor("quantity = \"section_force\"\nposition = 1.3") +
                                sensor("quantity = \"joint_reaction\"\njoint = 2") +
                                sensor("quantity = \"momentum\"");

const std::string kHubAtRest = "[hub]\nradius = 0.5\ndrive = { kind = \"fixed\" }\n";

}  // namespace

TEST_CASE("section forces of a blade at rest carry weight and loads outboard, by statics") {
  const std::string loads = R"([gravity]
acceleration = [0.0, 0.0, -10.0]
[damping]
stiffness_factor = 1e-3
[[load]]
position = 1.6
frame = "inertial"
force = [3.0, 4.0, 5.0]
moment = [0.1, 0.2, 0.3]
[[distributed_load]]
from = 0.4
to = 1.7
frame = "inertial"
force_per_length = [0.0, 2.0, 0.0]
)";
  Simulation simulation(make_scenario(make_blade(kHubAtRest, loads + section_sensors("inertial")),
                                      1e-2, 1.0, IntegrationMethod::generalized_alpha),
                        kSerial);
  simulation.run_until(1.0);
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    const double x = kPlaces[k];
    CAPTURE(x);
    Eigen::Vector3d force(0.0, 0.0, -10.0 * mass_beyond(x));
    Eigen::Vector3d moment(0.0, 10.0 * moment_beyond(x), 0.0);
    const auto add = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& f) {
      force += f;
      moment += (at - Eigen::Vector3d(x, 0.0, 0.0)).cross(f);
    };
    if (x <= 1.3) add({1.3, 0.02, 0.0}, {0.0, 0.0, -5.0});
    if (x <= 1.6) add({1.6, 0.0, 0.0}, {3.0, 4.0, 5.0});
    if (x <= 1.6) moment += Eigen::Vector3d(0.1, 0.2, 0.3);
    const double from = std::max(x, 0.4);
    if (from < 1.7) add({0.5 * (from + 1.7), 0.0, 0.0}, {0.0, 2.0 * (1.7 - from), 0.0});
    const std::string name = "blade1.f" + std::to_string(k);
    CHECK((vector_of(simulation, name + ".force") - force).norm() < 1e-4);
    CHECK((vector_of(simulation, name + ".moment") - moment).norm() < 1e-4);
  }
  // Forces in the axes of the section, turned by the twist: 0.3 rad at 0.5 m.
  Simulation in_axes(make_scenario(make_blade(kHubAtRest, loads + section_sensors("section")), 1e-2,
                                   1.0, IntegrationMethod::generalized_alpha),
                     kSerial);
  in_axes.run_until(1.0);
  const Eigen::Vector3d f = vector_of(simulation, "blade1.f2.force");
  const Eigen::Vector3d turned(f.x(), std::cos(0.3) * f.y() + std::sin(0.3) * f.z(),
                               -std::sin(0.3) * f.y() + std::cos(0.3) * f.z());
  CHECK((vector_of(in_axes, "blade1.f2.force") - turned).norm() < 1e-4);
}

TEST_CASE("the tension of a blade that turns is the centrifugal force of what is outboard") {
  const std::string hub = "[hub]\nradius = 0.5\ndrive = { kind = \"constant\", speed = 10.0 }\n";
  Simulation simulation(make_scenario(make_blade(hub, "[damping]\nstiffness_factor = 1e-3\n" +
                                                          section_sensors("blade")),
                                      1e-2, 1.0, IntegrationMethod::generalized_alpha),
                        kSerial);
  simulation.run_until(1.0);
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    const double x = kPlaces[k];
    CAPTURE(x);
    const double tension = 100.0 * (moment_beyond(x) + (0.5 + x) * mass_beyond(x)) +
                           (x <= 1.3 ? 100.0 * 0.5 * 1.8 : 0.0);
    CHECK(simulation.sensor("blade1.f" + std::to_string(k) + ".force.x") ==
          doctest::Approx(tension).epsilon(1e-5));
  }
}

TEST_CASE("in any motion a body's section at its root bears what its joint does") {
  // Springs, a stop, prescribed pitch, curved sections, loads of all kinds: by the balance of all
  // of the second body, against the force that the elimination of joints has found.
  const std::string curved =
      "twist = [0.5, -0.3]\nprebend = [0.0, 0.2]\n"
      "mass_center = [[0.02, 0.01], [0.0, 0.01]]\n";
  const std::string loads = R"([[distributed_load]]
from = 0.7
to = 1.8
frame = "section"
force_per_length = [0.3, 0.2, 1.0]
moment_per_length = [0.05, 0.0, 0.1]
[[load]]
blade = 1
frame = "hub"
force = [0.5, 0.6, 0.7]
)";
  const std::string sensors =
      sensor("name = \"r\"\nquantity = \"joint_reaction\"\njoint = 2\nframe = \"inertial\"") +
      sensor(
          "name = \"f\"\nquantity = \"section_force\"\nposition = 1.00000001\n"
          "frame = \"inertial\"");
  const auto user = make_load("user", {{0, 1, 0.4}},
                              [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                                out[0].force = -0.2 * in[0].velocity;
                                out[0].moment = {0.01, 0.02, 0.03};
                              });
  for (const std::string& hub : {kDrivenHub, kTurnedHub, kFlyingHub})
    for (const std::string& joints : {std::string(), kHinges + (hub == kDrivenHub ? kPitch : "")}) {
      const std::string text = make_text(hub, kBooms + curved + joints, kGravity + loads + sensors);
      Simulation simulation(make_scenario(text, 5e-4, 0.1), kSerial, {user});
      simulation.run_until(0.1);
      for (const std::string blade : {"blade1", "blade2"}) {
        const Eigen::Vector3d force = vector_of(simulation, blade + ".r.force");
        const Eigen::Vector3d moment = vector_of(simulation, blade + ".r.moment");
        CHECK(force.norm() > 1.0);
        CHECK((vector_of(simulation, blade + ".f.force") + force).norm() < 1e-6 * force.norm());
        CHECK((vector_of(simulation, blade + ".f.moment") + moment).norm() < 1e-5 * force.norm());
      }
    }
}

TEST_CASE("velocities and accelerations are the derivatives of the displacement in space") {
  const std::string text =
      make_text(kTurnedHub, kBooms + "twist = [0.5, -0.3]\n" + kHinges, kGravity);
  std::string sensors;
  for (const std::string frame : {"hub", "blade", "inertial"})
    for (const std::string quantity : {"displacement", "velocity", "acceleration"})
      sensors += sensor("name = \"" + frame + "_" + quantity + "\"\nquantity = \"" + quantity +
                        "\"\nposition = 1.7\nframe = \"" + frame + "\"");
  Simulation simulation(make_scenario(text + sensors, 1e-4, 0.1), kSerial);
  simulation.run_until(0.05);
  const auto read = [&](const std::string& name) {
    return vector_of(simulation, "blade1." + name);
  };
  for (const std::string frame : {"hub", "blade", "inertial"}) {
    CAPTURE(frame);
    std::array<Eigen::Vector3d, 3> displacement, velocity, rotation, spin;
    Eigen::Vector3d now_a, now_alpha;
    for (std::size_t k = 0; k < 3; ++k) {
      displacement[k] = read(frame + "_displacement");
      rotation[k] = read(frame + "_displacement.rotation");
      velocity[k] = read(frame + "_velocity");
      spin[k] = read(frame + "_velocity.rotation");
      if (k == 1) now_a = read(frame + "_acceleration");
      if (k == 1) now_alpha = read(frame + "_acceleration.rotation");
      simulation.step();
    }
    const double h2 = 2.0 * simulation.step_size();
    CHECK((Eigen::Vector3d((displacement[2] - displacement[0]) / h2) - velocity[1]).norm() <
          1e-4 * velocity[1].norm());
    CHECK((Eigen::Vector3d((velocity[2] - velocity[0]) / h2) - now_a).norm() < 1e-3 * now_a.norm());
    CHECK((Eigen::Vector3d((spin[2] - spin[0]) / h2) - now_alpha).norm() < 1e-3 * now_alpha.norm());
    const auto turn = [](const Eigen::Vector3d& vector) {
      return Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
    };
    const Eigen::AngleAxisd turned(turn(rotation[2]) * turn(rotation[0]).transpose());
    CHECK((turned.axis() * turned.angle() / h2 - spin[1]).norm() < 1e-3 * spin[1].norm());
  }
}

TEST_CASE("sensors show what the views of a simulation show") {
  const std::string sensors =
      sensor("name = \"end\"\nquantity = \"displacement\"") +
      sensor("quantity = \"joint_reaction\"\njoint = 2\nframe = \"inertial\"") +
      sensor("quantity = \"hub_reaction\"") + sensor("quantity = \"kinetic_energy\"") +
      sensor("quantity = \"kinetic_energy\"\nsubsystem = \"arm\"") +
      sensor("quantity = \"strain_energy\"") +
      sensor("quantity = \"strain_energy\"\nsubsystem = \"arm\"") +
      sensor(
          "name = \"root\"\nquantity = \"velocity\"\nsubsystem = \"arm\"\nbody = \"boom\"\n"
          "position = 0.0\n"
          "frame = \"inertial\"");
  Simulation simulation(
      make_scenario(make_text(kDrivenHub, kBooms + kTree, kGravity + sensors), 5e-4, 0.1), kSerial);
  simulation.run_until(0.1);
  CHECK((vector_of(simulation, "blade2.end") - vector_of(simulation, "blade2.tip")).norm() < 1e-12);
  CHECK(simulation.sensor("blade1.kinetic_energy") + simulation.sensor("arm.kinetic_energy") <
        simulation.sensor("energy.kinetic"));
  double strain = simulation.sensor("arm.strain_energy");
  for (const char* blade : {"blade1", "blade2"})
    strain += simulation.sensor(std::string(blade) + ".strain_energy");
  CHECK(strain > 0.0);
  CHECK(strain == testing::approx(simulation.sensor("energy.strain")).epsilon(1e-12));
  const Eigen::Vector3d velocity = simulation.marker({2, 0, 0.0}).velocity;
  CHECK((vector_of(simulation, "arm.root") - velocity).norm() < 1e-9);
  const Wrench joint = simulation.joint_reaction(0, 1), hub = simulation.hub_reaction();
  const std::string name = "blade1.joint_reaction";
  CHECK((vector_of(simulation, name + ".force") - joint.force).norm() < 1e-6 * joint.force.norm());
  CHECK((vector_of(simulation, "hub_reaction.force") - hub.force).norm() < 1e-6 * hub.force.norm());
  CHECK((vector_of(simulation, "hub_reaction.moment") - hub.moment).norm() <
        1e-6 * hub.moment.norm());
}

TEST_CASE("the momentum of a free flight in space stays, and gravity adds to it") {
  const std::string sensors = sensor("quantity = \"momentum\"");
  for (const std::string& bodies : {kBooms, kTree, kForest}) {
    Simulation simulation(make_scenario(make_text(kFlyingHub, bodies, sensors), 5e-4, 0.1),
                          kSerial);
    const Eigen::Vector3d linear = vector_of(simulation, "momentum");
    const Eigen::Vector3d angular = vector_of(simulation, "momentum.angular");
    CHECK(linear.norm() > 0.5);
    CHECK(angular.norm() > 0.5);
    simulation.run_until(0.1);
    CHECK((vector_of(simulation, "momentum") - linear).norm() < 1e-7);
    CHECK((vector_of(simulation, "momentum.angular") - angular).norm() < 1e-7);
  }
  // Hub of 3 kg and two booms of 2 kg.
  Simulation falling(make_scenario(make_text(kFlyingHub, kBooms, kGravity + sensors), 5e-4, 0.1),
                     kSerial);
  const Eigen::Vector3d before = vector_of(falling, "momentum");
  falling.run_until(0.1);
  const Eigen::Vector3d gained = 7.0 * 0.1 * Eigen::Vector3d(0.5, 1.0, -9.81);
  CHECK((vector_of(falling, "momentum") - before - gained).norm() < 1e-6);
}

TEST_CASE("nodes that measure sensors in space declare what they read and write") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub})
    for (const Method& method : {Method{Rk4{1e-5}}, Method{make_generalized_alpha(0.8, 0.005)}})
      for (const int stage : {0, 1}) {
        const Scenario scenario =
            parse_scenario(make_text(hub, kBooms + kHinges, kGravity + kAllSensors), "test.toml");
        const std::vector<spatial::Tree> trees = build_trees(*scenario.space);
        SystemContext<Space> context;
        context.system = make_system(*scenario.space, trees);
        context.integrator = {method, {1e9, 0, 50}};  // the iteration converges at once
        allocate(context);
        for (std::size_t i = 0; i < trees.size(); ++i)
          context.data.subsystems[i].reading_count =
              static_cast<std::size_t>(count_joint_values(context.system.subsystems[i]));
        place_sensors(scenario.sensors, 2, trees, context.system, context.data);
        for (SubsystemData<Space>& data : context.data.subsystems) place_reading_ring(data);
        const graph::StepGraph graph = build_step_graph(context);
        for (StepProgress& progress : context.data.progress) {
          progress.control = {0.1, stage, std::holds_alternative<GeneralizedAlpha>(method)};
          progress.step = 20;
          progress.passes = 1;
        }
        context.data.window = {20, 20, true};
        for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
          FAIL_CHECK(fault.message);
        CHECK(graph::conflicts_are_ordered(graph));
      }
}

TEST_CASE("a restored state in space shows what the sensors showed") {
  for (const std::string& hub : {kDrivenHub, kTurnedHub})
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
      const Scenario scenario = make_scenario(
          make_text(hub, kBooms + kHinges, kGravity + kAllSensors), 1e-3, 0.04, method);
      Simulation whole(scenario, kSerial), other(scenario, kSerial);
      whole.run_until(0.02);
      const std::vector<double> shown(whole.sensor_values().begin(), whole.sensor_values().end());
      other.restore(whole.save());
      const std::vector<double> restored(other.sensor_values().begin(),
                                         other.sensor_values().end());
      CHECK(shown == restored);
    }
}
