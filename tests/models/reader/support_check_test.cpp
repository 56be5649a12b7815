// Supports filled in code: what check_model() refuses.

#include <doctest/doctest.h>

#include <string>

#include "models/reader/spatial/model_check.h"
#include "tests/models/reader/check_message.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/reader/support_texts.h"
#include "tests/models/space_model.h"

using namespace spoke;
using spoke::test::check_message;
using spoke::test::kFuselageText;
using spoke::test::kSupportText;
using spoke::test::kSuspensionText;
using spoke::test::message_of;

namespace {

/// Checks the message of a model that `change` spoils.
template <class Change>
void check(const std::string& text, const Change& change, const std::string& expected) {
  spatial::Model model = test::space_model(text);
  change(model);
  check_message(message_of([&] { spatial::check_model(model); }), expected);
}

spatial::Joint& suspension_of(spatial::Model& model) { return model.subsystems[0].joints[0].joint; }

}  // namespace

TEST_CASE("supports from files are as models filled in code") {
  for (const std::string* text : {&kSupportText, &kFuselageText, &kSuspensionText})
    CHECK_NOTHROW(spatial::check_model(test::space_model(*text)));
}

TEST_CASE("a support and its tree belong together") {
  check(
      kSupportText, [](spatial::Model& model) { model.support.reset(); },
      "subsystem.1.name: is \"support\", which is the name of the support's tree, the last of the "
      "subsystems; expected another one");
  check(
      kSupportText, [](spatial::Model& model) { model.subsystems.clear(); },
      "support: has no tree, expected one by the name \"support\" as the last of the subsystems");
  check(
      kSupportText, [](spatial::Model& model) { model.subsystems[0].name = "tower"; },
      "support: has no tree, expected one by the name \"support\" as the last of the subsystems");
  check(
      kSupportText,
      [](spatial::Model& model) { model.subsystems.push_back(model.subsystems.front()); },
      "subsystem.1.name: is \"support\", which is the name of the support's tree, the last of the "
      "subsystems; expected another one");
  check(
      kSupportText, [](spatial::Model& model) { model.subsystems[0].azimuth = 0.5; },
      "support.azimuth: is 0.5, but a support does not stand around the hub's axis; expected 0");
}

TEST_CASE("bodies, joints and axles of supports are checked by their keys") {
  check(
      kSupportText,
      [](spatial::Model& model) {
        std::get<spatial::RigidBody>(model.subsystems[0].bodies[1].shape).mass = -1.0;
      },
      "support.body.2.mass: is -1, expected a number greater than 0 (kg)");
  check(
      kSupportText, [](spatial::Model& model) { model.subsystems[0].joints[0].parent = "hub"; },
      "support.joint.1.parent: is \"hub\", expected \"ground\", \"nacelle\" or \"tower\"");
  check(
      kSupportText, [](spatial::Model& model) { model.support->axle.body.clear(); },
      "support.axle.body: is missing, expected the name of the body that carries the axle");
  check(
      kSupportText, [](spatial::Model& model) { model.support->fuselage.mass = 3.0; },
      "support.mass: belongs to a fuselage, expected only with from = \"free\"");
  check(
      kFuselageText, [](spatial::Model& model) { model.support->fuselage.inertia.setZero(); },
      "support.inertia: has the principal moments 0, 0 and 0 kg m^2, expected all of them greater "
      "than 0");
  check(
      kSupportText, [](spatial::Model& model) { model.hub.support = HubSupport::free; },
      "hub.drive.kind: is \"constant\", which prescribes the rotation about an axle; expected, of "
      "a free hub, \"free\", \"torque\" or \"torque_by_speed\"");
}

TEST_CASE("bushings hold what has no spring and no damper, and nothing else") {
  check(
      kSuspensionText,
      [](spatial::Model& model) { suspension_of(model).coordinates[2].motion.reset(); },
      "support.joint.1.motion.3: is none of zero, expected one that holds a direction without "
      "stiffness and damping");
  check(
      kSuspensionText,
      [](spatial::Model& model) {
        suspension_of(model).coordinates[2].motion = spatial::MotionTable{Curve(0.1)};
      },
      "support.joint.1.motion.3: is none of zero, expected one that holds a direction without "
      "stiffness and damping");
  check(
      kSuspensionText,
      [](spatial::Model& model) {
        suspension_of(model).coordinates[0].motion = spatial::MotionTable{};
      },
      "support.joint.1.motion.1: does not belong to kind \"bushing\"");
  check(
      kSuspensionText,
      [](spatial::Model& model) { suspension_of(model).coordinates[5].effort = Curve(2.0); },
      "support.joint.1.torque: does not belong to kind \"bushing\"");
  check(
      kSuspensionText,
      [](spatial::Model& model) { suspension_of(model).coordinates[0].effort = Curve(2.0); },
      "support.joint.1.force: does not belong to kind \"bushing\"");
  check(
      kSuspensionText,
      [](spatial::Model& model) { suspension_of(model).coordinates[0].stop = spatial::Stop{}; },
      "support.joint.1.stop: does not belong to kind \"bushing\"");
}
