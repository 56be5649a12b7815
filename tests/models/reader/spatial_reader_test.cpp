// Values that the reader makes of the keys of a model in space.

#include <numbers>

#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "tests/models/reader/spatial_texts.h"

using doctest::Approx;
using namespace spoke;
using spoke::test::edited;
using spoke::test::kBladeText;
using spoke::test::kTreeText;

namespace {

spatial::Model read(const std::string& text, const Overrides& overrides = {}) {
  const Scenario scenario = parse_scenario(text, "f.toml", overrides);
  REQUIRE(scenario.space.has_value());
  CHECK(scenario.rotor.blades.empty());
  return *scenario.space;
}

/// Reads kBladeText with another joint in place of the flap hinge.
spatial::Joint read_joint(const std::string& keys) {
  return read(edited(kBladeText, "kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0", keys))
      .blades.at(0)
      .joints.at(0)
      .joint;
}

}  // namespace

TEST_CASE("a scenario is of the plane unless it says otherwise") {
  const std::string text =
      "[hub.drive]\nkind = 'free'\n[blade]\ncount = 2\nlength = 1\ndensity = 1\narea = 1\n"
      "second_moment = 1\nyoungs_modulus = 1\n[integration]\nduration = 1\n";
  CHECK_FALSE(parse_scenario(text, "f").space.has_value());
  const Scenario said = parse_scenario("world = 'plane'\n" + text, "f");
  CHECK_FALSE(said.space.has_value());
  CHECK(said.to_json() == parse_scenario(text, "f").to_json());
}

TEST_CASE("blades in space have the documented defaults") {
  const spatial::Model model = read(kBladeText);
  CHECK(model.hub.axis == spatial::Vector(0, 0, 1));
  CHECK(model.hub.inertia == spatial::Tensor::Identity());
  CHECK(model.gravity == spatial::Vector(0, 0, -9.81));
  REQUIRE(model.blades.size() == 3);
  for (int i = 0; i < 3; ++i)
    CHECK(model.blades[static_cast<std::size_t>(i)].azimuth ==
          Approx(2.0 * std::numbers::pi * i / 3));
  const spatial::Blade& blade = model.blades[1];
  CHECK(blade.precone == 0.0);
  CHECK(blade.beam.bodies == 4);
  CHECK(blade.beam.elements == 4);
  CHECK(blade.beam.geometric_stiffening);
  CHECK(blade.beam.reference_frame == ReferenceFrame::clamped);
  CHECK(blade.beam.sections.flap_stiffness == std::vector<double>{3e3, 2e3, 1e3});
  CHECK(blade.beam.sections.flap_inertia.empty());
  CHECK(blade.beam.sections.lag_shear_stiffness.empty());
  REQUIRE(blade.joints.size() == 2);
  CHECK(blade.joints[0].joint.name == "flap");
  CHECK(blade.joints[0].joint.coordinates[0].damping == 10.0);
  const auto& motion = blade.joints[1].joint.coordinates[0].motion;
  REQUIRE(motion.has_value());
  CHECK(std::get<spatial::AzimuthMotion>(*motion).mean == 0.1);
}

TEST_CASE("overrides reach into sections, joints and bodies") {
  const spatial::Model blades =
      read(kBladeText, {"blade.sections.twist.1=0.3", "blade.joint.1.station=0.2",
                        "blade.joint.2.motion={by='program', initial=0.05}"});
  CHECK(blades.blades[2].beam.sections.twist[0] == 0.3);
  CHECK(blades.blades[2].joints[0].station == 0.2);
  CHECK(std::get<spatial::ProgramMotion>(*blades.blades[0].joints[1].joint.coordinates[0].motion)
            .initial == 0.05);
  const spatial::Model tree =
      read(kTreeText, {"subsystem.1.body.2.inertia.3=2.5", "subsystem.1.joint.2.node=4"});
  CHECK(std::get<spatial::RigidBody>(tree.subsystems[0].bodies[1].shape).inertia(2, 2) == 2.5);
  CHECK(tree.subsystems[0].joints[1].station == 1.0);
  CHECK(
      test::message_of([] { read(kTreeText, {"subsystem.1.joint.2.parent=bom"}); }) ==
      "--set subsystem.1.joint.2.parent=bom: subsystem.1.joint.2.parent: is \"bom\", did you mean "
      "\"boom\"?");
}

TEST_CASE("one number in place of an array holds at every station") {
  const auto sections =
      std::get<spatial::Beam>(read(kTreeText).subsystems.at(0).bodies.at(0).shape).sections;
  CHECK(sections.station == std::vector<double>{0.0, 4.0});
  CHECK(sections.torsion_stiffness == std::vector<double>{1e3, 1e3});
}

TEST_CASE("blades one by one take what they lack from the table of all") {
  std::string text = edited(kBladeText, "count = 3\n", "azimuth = 0.5\n");
  text +=
      "[[blades]]\n[[blades]]\nprecone = 0.1\nazimuth = 1.0\nsections = { mass_per_length = 1, "
      "axial_stiffness = 1, flap_stiffness = 1, lag_stiffness = 1, torsion_stiffness = 1 }\n";
  const spatial::Model model = read(text);
  REQUIRE(model.blades.size() == 2);
  CHECK(model.blades[0].azimuth == 0.5);
  CHECK(model.blades[0].beam.sections.station.size() == 3);
  CHECK(model.blades[1].azimuth == 1.0);
  CHECK(model.blades[1].precone == 0.1);
  CHECK(model.blades[1].beam.sections.station == std::vector<double>{0.0, 8.0});
  CHECK(model.blades[1].joints.size() == 2);
}

TEST_CASE("joints of several coordinates take a value for each") {
  const spatial::Joint joint = read_joint(
      "kind = 'cylindrical'\naxis = [2, 0, 0]\nstiffness = [1, 2]\nrest = [0.1, 0.2]\n"
      "torque = { time = [0, 1], value = [0, 5] }\nforce = 7\n"
      "stop = [{}, { lower = -1, upper = 1, stiffness = 9, width = 0.1 }]\n"
      "friction = [{}, { force = 3, speed = 0.01, static = 4, stribeck = 0.1 }]");
  CHECK_FALSE(joint.coordinates[0].friction.has_value());
  CHECK(joint.coordinates[1].friction.value().static_force == 4.0);
  CHECK(joint.coordinates[0].stiffness == 1.0);
  CHECK(joint.coordinates[1].rest == 0.2);
  CHECK(joint.coordinates[0].effort.value(1.0) == 5.0);
  CHECK(joint.coordinates[1].effort.value(3.0) == 7.0);
  CHECK_FALSE(joint.coordinates[0].stop.has_value());
  CHECK(joint.coordinates[1].stop.value().stiffness == 9.0);
  const spatial::Joint universal = read_joint(
      "kind = 'universal'\naxes = [[0, 1, 0], [0, 0, 1]]\ninitial = [0, 0.2]\n"
      "torque = { time = [0, 2], value = [[0, 1], [0, 3]] }\nmotion = [{ constant = 0.3 }, {}]\n"
      "orientation = [0.1, 0, 0]");
  CHECK(universal.coordinates[1].initial == 0.2);
  CHECK(universal.coordinates[1].effort.value(2.0) == 3.0);
  CHECK(universal.orientation.x() == 0.1);
}

TEST_CASE("what is prescribed has no torque, whether in a file or in code") {
  const std::string expected =
      "given along with motion, expected only one of them: what is prescribed needs no spring, "
      "damper, stop, effort or start";
  const auto error = test::message_of([] {
    read_joint(
        "kind = 'universal'\naxes = [[0, 1, 0], [0, 0, 1]]\ntorque = [1, 0]\n"
        "motion = [{ constant = 0.3 }, {}]");
  });
  CHECK(error == "f.toml:26:10: blade.joint.1.torque: " + expected);
  Scenario scenario = parse_scenario(kBladeText, "f");
  scenario.space->blades[1].joints[1].joint.coordinates[0].stiffness = 1.0;
  CHECK(test::message_of([&] { check_scenario(scenario); }) ==
        "blades.2.joint.2.stiffness: " + expected);
}

TEST_CASE("matrices of BeamDyn are turned into the axes of Spoke") {
  // A slice of mass 2 with its centre 0.3 m towards the trailing edge and 0.1 m downwind.
  const std::string theirs =
      "mass_6x6 = [2, 0, 0, 0, 0, -0.6,  0, 2, 0, 0, 0, 0.2,  0, 0, 2, 0.6, -0.2, 0, "
      "0, 0, 0.6, 0.5, -0.06, 0,  0, 0, -0.2, -0.06, 0.1, 0,  -0.6, 0.2, 0, 0, 0, 0.6]";
  std::string text =
      edited(kBladeText, "mass_per_length = [3.0, 2.0, 1.0]\n", "matrix_convention = 'beamdyn'\n");
  const std::string rows = theirs.substr(theirs.find('['));
  text = edited(text, "twist = [0.2, 0.1, 0.0]\n",
                "mass_6x6 = [" + rows + ", " + rows + ", " + rows + "]\n");
  const spatial::SectionMatrix mass = read(text).blades[0].beam.sections.mass_6x6.at(1);
  CHECK(mass(0, 0) == 2.0);
  CHECK(mass(2, 3) == Approx(2.0 * -0.3));  // y: the leading edge is ahead
  CHECK(mass(0, 4) == Approx(2.0 * 0.1));   // z: downwind
  CHECK(mass(3, 3) == Approx(0.6));
  CHECK(mass(4, 4) == Approx(0.1));  // int z^2
  CHECK(mass(5, 5) == Approx(0.5));  // int y^2
  CHECK(mass(4, 5) == Approx(-0.06 * -1.0));
  CHECK(mass.isApprox(mass.transpose()));
}

TEST_CASE("the upper triangle of a matrix is enough") {
  const std::string triangle =
      "[9, 0, 0, 0, 1, 0,  8, 0, 0, 0, 0,  7, 0, 0, 0,  6, 0, 0,  5, 0,  4]";
  std::string text = kTreeText;
  for (const char* key : {"axial", "flap", "lag"})
    text = edited(text, key + std::string("_stiffness = 1e") + (key[0] == 'a' ? "7" : "3") + '\n',
                  key[0] == 'a' ? "" : key + std::string("_inertia = 0.1\n"));
  text = edited(text, "torsion_stiffness = 1e3",
                "stiffness_6x6 = [" + triangle + ", " + triangle + "]");
  const auto model = read(text);
  const auto& sections = std::get<spatial::Beam>(model.subsystems[0].bodies[0].shape).sections;
  CHECK(sections.stiffness_6x6[1](4, 0) == 1.0);
  CHECK(sections.stiffness_6x6[1](5, 5) == 4.0);
}

TEST_CASE("the mount's motion and a free hub's start are read") {
  const spatial::Model ship =
      read(edited(kBladeText, "[gravity]",
                  "[hub.mount]\ntranslation = { time = [0, 1, 2], z = [0, 1, 1] }\n"
                  "rotation = { amplitude = [0.1, 0, 0], frequency = 0.5, phase = 1 }\n[gravity]"));
  REQUIRE(ship.hub.mount.has_value());
  const auto& table = std::get<spatial::VectorTable>(ship.hub.mount->translation);
  CHECK(table.components[2].value(1.0) == 1.0);
  CHECK(table.components[0].value(1.0) == 0.0);
  const auto& harmonic = std::get<spatial::VectorHarmonic>(ship.hub.mount->rotation);
  CHECK(harmonic.frequency == 0.5);
  CHECK(harmonic.phase == 1.0);
  const spatial::Model flight =
      read(edited(kTreeText, "mass = 100.0",
                  "mass = 100.0\nvelocity = [1, 2, 3]\nangular_velocity = [0, 0.1, 0]"));
  CHECK(flight.hub.velocity == spatial::Vector(1, 2, 3));
  CHECK(flight.hub.angular_velocity.y() == 0.1);
  CHECK(std::holds_alternative<FreeDrive>(flight.hub.drive));
}

TEST_CASE("loads in space are read with their places") {
  const spatial::Model model = read(edited(
      kTreeText, "[integration]",
      "[[load]]\nsubsystem = 'arm'\nbody = 'mirror'\npoint = [0, 1, 0]\nframe = 'body'\n"
      "moment = [1, 2, 3]\n[[distributed_load]]\nsubsystem = 'arm'\nbody = 'boom'\nfrom = 1\n"
      "to = 3\nforce_per_length = [0, 0, 2]\nramp = 4\n[[hub_load]]\ntorque = [1, 0, 0]\n"
      "time = [0, 1]\nfactor = [0, 2]\n[integration]"));
  REQUIRE(model.loads.size() == 1);
  CHECK(model.loads[0].place.body == "mirror");
  CHECK(model.loads[0].point.y() == 1.0);
  CHECK(model.loads[0].frame == spatial::LoadFrame::body);
  CHECK(model.loads[0].moment.z() == 3.0);
  REQUIRE(model.distributed_loads.size() == 1);
  CHECK(model.distributed_loads[0].to == 3.0);
  CHECK(model.distributed_loads[0].ramp == 4.0);
  REQUIRE(model.hub_loads.size() == 1);
  CHECK(model.hub_loads[0].factor.value(1.0) == 2.0);
}

TEST_CASE("a model filled in code is held to the rules of files") {
  Scenario scenario = parse_scenario(kTreeText, "f");
  CHECK_NOTHROW(check_scenario(scenario));
  const auto error_after = [&](auto change) {
    Scenario changed = scenario;
    change(changed, *changed.space);
    return test::message_of([&] { check_scenario(changed); });
  };
  using Model = spatial::Model;
  CHECK(error_after([](Scenario&, Model& m) { m.hub.mass = -1.0; }) ==
        "hub.mass: is -1, expected a number greater than 0 (kg)");
  CHECK(error_after([](Scenario&, Model& m) { m.gravity.y() = 1e31; }) ==
        "gravity.acceleration.2: is 1e+31, expected 0 or a magnitude from 1e-40 to 1e+30 (m/s^2)");
  CHECK(error_after([](Scenario&, Model& m) { m.subsystems.clear(); }) == "no error");  // it flies
  CHECK(error_after([](Scenario&, Model& m) {
          m.subsystems.clear();
          m.hub.support = HubSupport::axle;
          m.hub.drive = ConstantSpeed{1.0};
        }) == "blades: there are none, and no subsystem; expected one or more");
  CHECK(error_after([](Scenario&, Model& m) { m.subsystems[0].joints[1].child = "boom"; }) ==
        "subsystem.1.joint.2.child: is \"boom\", the parent; expected another body");
  CHECK(error_after([](Scenario&, Model& m) {
          std::get<spatial::RigidBody>(m.subsystems[0].bodies[1].shape).inertia(0, 1) = 1.0;
        }) == "subsystem.1.body.2.inertia: is not symmetric, expected an inertia tensor (kg m^2)");
  CHECK(error_after([](Scenario&, Model& m) {
          m.subsystems[0].joints[1].joint.coordinates[2].stiffness = 1.0;
        }) ==
        "subsystem.1.joint.2.stiffness: differs between the coordinates, expected one for all "
        "three");
  CHECK(error_after([](Scenario&, Model& m) {
          m.subsystems[0].joints[1].joint.coordinates[2].effort = Curve({0.0, 1.0}, {0.0, 1.0});
        }) ==
        "subsystem.1.joint.2.torque: has other times for one coordinate than for another, "
        "expected equal ones");
  CHECK(error_after([](Scenario&, Model& m) { m.subsystems.push_back(m.subsystems[0]); }) ==
        "subsystem.2.name: is \"arm\" as another subsystem's, expected its own");
  CHECK(error_after([](Scenario&, Model& m) { m.loads.push_back({}); }) ==
        "load.1: is on blades, of which there are none; expected subsystem and body");
  CHECK(error_after([](Scenario& s, Model&) { s.rotor.blades.resize(1); }) ==
        "blades: there are some of the plane in a model in space, expected none");
  CHECK(error_after([](Scenario& s, Model&) { s.integration.step = 0.0; }) ==
        "integration.step: is 0, expected a number greater than 0 (s)");
}

TEST_CASE("one number is an inertia about every axis, of all bodies that have one") {
  const spatial::Tensor three = 3.0 * spatial::Tensor::Identity();
  const spatial::Model tree =
      read(edited(edited(kTreeText, "inertia = [20.0, 20.0, 30.0]", "inertia = 3"),
                  "inertia = [1.0, 2.0, 3.0]", "inertia = 3.0"));
  CHECK(tree.hub.inertia == three);
  CHECK(std::get<spatial::RigidBody>(tree.subsystems.at(0).bodies.at(1).shape).inertia == three);
  CHECK(read(edited(kBladeText, "radius = 0.1", "inertia = 3")).hub.inertia == three);
  const auto with_point = [](const std::string& inertia) {
    return read(edited(kBladeText, "[[blade.joint]]",
                       "[[blade.point_mass]]\nposition = 8.0\nmass = 1.0\ninertia = " + inertia +
                           "\n[[blade.joint]]"))
        .blades.at(0)
        .beam.point_masses.at(0)
        .inertia;
  };
  CHECK(with_point("3") == three);
  CHECK(with_point("0") == spatial::Tensor(spatial::Tensor::Zero()));
}
