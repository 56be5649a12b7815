// Values that the reader makes of supports, suspensions and bushings, and the files that it makes
// of these again.

#include <doctest/doctest.h>

#include <string>
#include <variant>

#include "models/reader/angle_hints.h"
#include "models/scenario.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/reader/support_texts.h"

using namespace spoke;
using spoke::test::document_of;
using spoke::test::edited;
using spoke::test::kBladeText;
using spoke::test::kFuselageText;
using spoke::test::kSupportText;
using spoke::test::kSuspensionText;
using spoke::test::kTreeText;

namespace {

Scenario read(const std::string& text, const Overrides& overrides = {}) {
  Scenario scenario = parse_scenario(text, "f.toml", overrides);
  REQUIRE(scenario.space.has_value());
  return scenario;
}

/// Returns the model of a text, after a check that what is written of it is read as the same.
spatial::Model parsed_model(const std::string& text, const Overrides& overrides = {}) {
  const Scenario scenario = read(text, overrides);
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(document_of(json), "f").to_json() == json);
  return *scenario.space;
}

}  // namespace

TEST_CASE("a support is the last subsystem, and carries the axle") {
  const spatial::Model model = parsed_model(kSupportText);
  REQUIRE(model.support.has_value());
  CHECK(model.support->from == spatial::SupportBase::ground);
  CHECK(model.support->axle.body == "nacelle");
  CHECK(model.support->axle.offset == spatial::Vector(0, 0, 2));
  CHECK(model.support->axle.orientation.isZero(0.0));
  REQUIRE(model.subsystems.size() == 1);
  const spatial::Subsystem& tree = model.subsystems[0];
  CHECK(tree.name == "support");
  REQUIRE(tree.bodies.size() == 2);
  CHECK(std::get<spatial::Beam>(tree.bodies[0].shape).length == 20.0);
  CHECK(std::get<spatial::RigidBody>(tree.bodies[1].shape).mass == 50.0);
  REQUIRE(tree.joints.size() == 2);
  CHECK(tree.joints[0].parent == "ground");
  CHECK(tree.joints[1].parent == "tower");
  CHECK(is_support(model, tree));
  CHECK(key_of_subsystem(model, 0) == "support");
}

TEST_CASE("subsystems on the hub stand before the support, wherever the file has them") {
  const auto arm = kTreeText.find("[[subsystem]]");
  const std::string arms = kTreeText.substr(arm, kTreeText.find("[integration]") - arm);
  const spatial::Model model =
      parsed_model(edited(kSupportText, "[integration]", arms + "[integration]"));
  REQUIRE(model.subsystems.size() == 2);
  CHECK(model.subsystems[0].name == "arm");
  CHECK(model.subsystems[1].name == "support");
  CHECK(key_of_subsystem(model, 0) == "subsystem.1");
  const spatial::Model suspended =
      parsed_model(edited(kSuspensionText, "[integration]", arms + "[integration]"));
  REQUIRE(suspended.subsystems.size() == 2);
  CHECK(suspended.subsystems[1].name == "support");
}

TEST_CASE("a fuselage has its own motion, and carries the axle alone") {
  const spatial::Model model = parsed_model(kFuselageText);
  REQUIRE(model.support.has_value());
  CHECK(model.support->from == spatial::SupportBase::free);
  const spatial::Fuselage& fuselage = model.support->fuselage;
  CHECK(fuselage.mass == 500.0);
  CHECK(fuselage.inertia(1, 1) == 900.0);
  CHECK(fuselage.position.z() == 100.0);
  CHECK(fuselage.attitude == spatial::Vector(0, 0.1, 0));
  CHECK(fuselage.velocity.x() == 30.0);
  CHECK(fuselage.angular_velocity.isZero(0.0));
  CHECK(model.support->axle.body.empty());
  REQUIRE(model.subsystems.size() == 1);
  CHECK(model.subsystems[0].bodies.empty());
}

TEST_CASE("bodies on a fuselage have the parent fuselage, which may carry the axle beside them") {
  const std::string boom =
      "[[support.body]]\nname = \"boom\"\nkind = \"rigid\"\nmass = 5\ninertia = 1\n"
      "[[support.joint]]\nchild = \"boom\"\nkind = \"fixed\"\n[support.axle]\n";
  const spatial::Model on_boom =
      parsed_model(edited(kFuselageText, "[support.axle]\n", boom + "body = \"boom\"\n"));
  CHECK(on_boom.subsystems[0].joints[0].parent == "fuselage");
  CHECK(on_boom.support->axle.body == "boom");
  const spatial::Model beside =
      parsed_model(edited(kFuselageText, "[support.axle]\n", boom + "body = \"fuselage\"\n"));
  CHECK(beside.support->axle.body.empty());
}

TEST_CASE("an axle is at a station or a node of a beam, or at its tip") {
  const auto axle_at = [](const std::string& keys) {
    return parsed_model(edited(kSupportText, "body = \"nacelle\"\n", "body = \"tower\"\n" + keys))
        .support->axle.station;
  };
  CHECK_FALSE(axle_at("").has_value());
  CHECK(axle_at("station = 15.0\n") == 15.0);
  CHECK(axle_at("node = 8\n") == 10.0);
}

TEST_CASE("a suspension is a support with a carrier on a bushing") {
  const spatial::Model model = parsed_model(kSuspensionText);
  REQUIRE(model.support.has_value());
  CHECK(model.support->axle.body == "carrier");
  REQUIRE(model.subsystems.size() == 1);
  const auto& carrier = std::get<spatial::RigidBody>(model.subsystems[0].bodies[0].shape);
  CHECK(carrier.mass == 40.0);
  CHECK(carrier.inertia == 3.0 * spatial::Tensor::Identity());
  const spatial::SubsystemJoint& joint = model.subsystems[0].joints[0];
  CHECK(joint.parent == "ground");
  CHECK(joint.joint.kind == spatial::JointKind::bushing);
  CHECK(joint.joint.coordinates[0].stiffness == 2e4);
  CHECK(joint.joint.coordinates[1].damping == 10.0);
  CHECK_FALSE(joint.joint.coordinates[1].motion.has_value());
  CHECK(joint.joint.coordinates[2].motion.has_value());
  CHECK_FALSE(joint.joint.coordinates[5].motion.has_value());  // a damper alone moves, too
}

TEST_CASE("the long form of a suspension is the same model") {
  const std::string long_form =
      "[support]\n[[support.body]]\nname = \"carrier\"\nkind = \"rigid\"\nmass = 40.0\n"
      "inertia = 3.0\n[[support.joint]]\nname = \"suspension\"\nchild = \"carrier\"\n"
      "kind = \"bushing\"\nstiffness = [2e4, 1e4, 0, 0, 0, 0]\n"
      "damping = [20.0, 10.0, 0, 0, 0, 5.0]\n[support.axle]\nbody = \"carrier\"\n[integration]\n";
  const auto at = kSuspensionText.find("[hub.suspension]");
  const std::string text = kSuspensionText.substr(0, at) + long_form + "duration = 2.0\n";
  CHECK(read(text).to_json() == read(kSuspensionText).to_json());
}

TEST_CASE("bushings have six coordinates, of blades and of subsystems, too") {
  const std::string keys =
      "kind = \"bushing\"\nstiffness = [0, 3e4, 4e4, 0, 5, 0]\ndamping = [0, 0, 7, 0, 0, 2]\n"
      "rest = [0, 0.01, 0, 0, 0, 0]\ninitial = [0, 0, 0.02, 0, 0.1, 0]\n"
      "initial_speed = [0, 0, 0, 0, 0, 1]\n";
  const spatial::Model blades = parsed_model(
      edited(kBladeText, "kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0\n", keys));
  const spatial::Joint& joint = blades.blades.at(2).joints.at(0).joint;
  CHECK(joint.coordinates[0].motion.has_value());
  CHECK(joint.coordinates[1].rest == 0.01);
  CHECK(joint.coordinates[2].damping == 7.0);
  CHECK(joint.coordinates[3].motion.has_value());
  CHECK(joint.coordinates[4].initial == 0.1);
  CHECK(joint.coordinates[5].initial_speed == 1.0);
  const spatial::Model tree =
      parsed_model(edited(kTreeText, "kind = \"spherical\"\nstiffness = 4.0\n", keys));
  CHECK(tree.subsystems[0].joints[1].joint.coordinates[2].stiffness == 4e4);
}

TEST_CASE("directions of a bushing that are free move without springs, and are written again") {
  const std::string keys =
      "kind = \"bushing\"\nstiffness = [0, 3e4, 0, 0, 0, 0]\nfree = [\"x\", \"about z\"]\n";
  const Scenario scenario =
      parse_scenario(edited(kTreeText, "kind = \"spherical\"\nstiffness = 4.0\n", keys), "f.toml");
  const spatial::Joint& joint = scenario.space->subsystems[0].joints[1].joint;
  for (const std::size_t c : {0, 1, 5}) CHECK(!joint.coordinates[c].motion.has_value());
  for (const std::size_t c : {2, 3, 4}) CHECK(joint.coordinates[c].motion.has_value());
  const std::string json = scenario.to_json();
  CHECK(json.find("about z") != std::string::npos);
  CHECK(parse_scenario(document_of(json), "f.toml").to_json() == json);
}

TEST_CASE("overrides reach into supports") {
  const spatial::Model model =
      parsed_model(kSupportText, {"support.body.1.length=25.0", "support.joint.2.damping=10",
                                  "support.axle.offset.3=3.0", "support.body.2.mass=60"});
  const spatial::Subsystem& tree = model.subsystems[0];
  CHECK(std::get<spatial::Beam>(tree.bodies[0].shape).length == 25.0);
  CHECK(std::get<spatial::RigidBody>(tree.bodies[1].shape).mass == 60.0);
  CHECK(tree.joints[1].joint.coordinates[0].damping == 10.0);
  CHECK(model.support->axle.offset.z() == 3.0);
  CHECK(parsed_model(kSuspensionText, {"hub.suspension.stiffness.3=5e3"})
            .subsystems[0]
            .joints[0]
            .joint.coordinates[2]
            .stiffness == 5e3);
}

TEST_CASE("loops of a support close on the ground, the fuselage and anchors of the mount") {
  const std::string loop =
      "[[anchor]]\nname = \"shaker\"\n[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\n"
      "from = { body = \"tower\", station = 10.0 }\nto = { body = \"ground\", point = [5, 0, 0] }\n"
      "stiffness = 1e5\n[[support.loop]]\nname = \"leg\"\nkind = \"distance\"\n"
      "from = { body = \"nacelle\" }\nto = { anchor = \"shaker\", point = [9, 0, 0] }\n"
      "stiffness = 1e5\n[integration]";
  const spatial::Model model = parsed_model(edited(kSupportText, "[integration]", loop));
  const auto& loops = model.subsystems[0].loops;
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].from.name == "tower");
  CHECK(loops[0].to.carrier == LoopPlace::Carrier::hub);
  CHECK(loops[0].to.point.x() == 5.0);
  CHECK(loops[1].to.carrier == LoopPlace::Carrier::anchor);
  const std::string strut =
      "[[support.body]]\nname = \"boom\"\nkind = \"rigid\"\nmass = 5\ninertia = 1\n"
      "[[support.joint]]\nchild = \"boom\"\nkind = \"spherical\"\n[[support.loop]]\n"
      "name = \"strut\"\nkind = \"distance\"\nfrom = { body = \"boom\", point = [1, 0, 0] }\n"
      "to = \"fuselage\"\nstiffness = 1e5\n[support.axle]\nbody = \"boom\"\n";
  const spatial::Model flying = parsed_model(edited(kFuselageText, "[support.axle]\n", strut));
  CHECK(flying.subsystems[0].loops[0].to.carrier == LoopPlace::Carrier::hub);
}

TEST_CASE("the mount moves the ground end of a support") {
  const spatial::Model model =
      parsed_model(kSupportText, {"hub.mount={translation={amplitude=[0.1,0,0], frequency=3.0}}"});
  CHECK(model.hub.mount.has_value());
}

TEST_CASE("loads and sensors are on bodies of the support, sensors on the hub, too") {
  const std::string at = "subsystem = \"support\"\nbody = ";
  const Scenario scenario =
      read(edited(kSupportText, "[integration]",
                  "[[load]]\n" + at +
                      "\"nacelle\"\nforce = [1, 0, 0]\nframe = \"inertial\"\n"
                      "[[distributed_load]]\n" +
                      at +
                      "\"tower\"\nfrom = 5\nforce_per_length = [1, 0, 0]\n"
                      "[[sensor]]\nname = \"top\"\nquantity = \"displacement\"\n" +
                      at +
                      "\"tower\"\n"
                      "[[sensor]]\nname = \"bend\"\nquantity = \"section_force\"\n" +
                      at +
                      "\"tower\"\nposition = 0\n"
                      "[[sensor]]\nname = \"axle_wrench\"\nquantity = \"joint_reaction\"\n" +
                      at +
                      "\"hub\"\n"
                      "[integration]"));
  CHECK(scenario.space->loads[0].place.body == "nacelle");
  CHECK(scenario.space->distributed_loads[0].from == 5.0);
  REQUIRE(scenario.sensors.size() == 3);
  CHECK(scenario.sensors[2].body == "hub");
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(document_of(json), "f").to_json() == json);
}

TEST_CASE("angles of supports that look like degrees are asked about") {
  using Hints = std::vector<std::string>;
  const auto hints_of = [](const std::string& text, const Overrides& overrides) {
    return find_angle_hints(parse_scenario(text, "f.toml", overrides));
  };
  CHECK(hints_of(kSupportText, {}).empty());
  CHECK(hints_of(kSupportText, {"support.axle.orientation=[0,90,0]"}) ==
        Hints{"the orientation of the support's axle is 90 rad, beyond a turn of 2 pi: degrees?"});
  CHECK(hints_of(kFuselageText, {"support.attitude=[0,10,0]"}) ==
        Hints{"the attitude of the support is 10 rad, beyond a turn of 2 pi: degrees?"});
  CHECK(hints_of(kSupportText, {"support.joint.2.rest=45"}) ==
        Hints{"the rest of joint \"yaw\" of subsystem \"support\" is 45 rad, beyond a turn of 2 "
              "pi: degrees?"});
}

TEST_CASE("models without a support are written as they were") {
  CHECK(read(kBladeText).to_json().find("support\": {") == std::string::npos);
}
