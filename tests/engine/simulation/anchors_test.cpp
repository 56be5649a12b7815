// Tests anchors of loops that the embedding program moves.

#include "engine/simulation/anchors.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/courses.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/loop_models.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kOneThread{Formulation::structured, ExecutorKind::serial, 1, 1};
const std::string kFixed = "drive = { kind = \"fixed\" }";
const std::string kTurning = "drive = { kind = \"constant\", speed = 5.0 }";

/// Returns the pitch at which the link of make_pitching() fits, with its foot raised by z [rad].
double pitch_at(double z) {
  double pitch = z / 0.1;
  for (int n = 0; n < 20; ++n) {
    const double y = 0.1 * std::cos(pitch) - 0.1, up = 0.1 * std::sin(pitch) + 0.3 - z;
    const double slope = -2.0 * y * 0.1 * std::sin(pitch) + 2.0 * up * 0.1 * std::cos(pitch);
    pitch -= (y * y + up * up - 0.09) / slope;
  }
  return pitch;
}

}  // namespace

TEST_CASE("the program moves a swashplate: the pitch is that at which the link fits") {
  for (const std::string& hub : {kFixed, kTurning})
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
      CAPTURE(hub);
      CAPTURE(name_of(method));
      Scenario scenario = make_pitching(hub);
      scenario.integration.method = method;
      scenario.integration.step = 1e-3;
      Simulation simulation(scenario, kOneThread);
      CHECK(simulation.sensor("bladeA.pitch") == doctest::Approx(0.0));
      while (simulation.time() < 0.4) {  // a controller raises it by 0.03 m
        AnchorMotion plate = simulation.anchor_motion("plate");
        plate.acceleration.z() = 400.0 * (0.03 - plate.translation.z()) - 40.0 * plate.velocity.z();
        simulation.set_anchor_motion("plate", plate);
        simulation.step();
        CHECK(simulation.sensor("bladeA.pitch") ==
              doctest::Approx(pitch_at(simulation.anchor_motion("plate").translation.z()))
                  .epsilon(1e-9));
      }
      CHECK(simulation.anchor_motion("plate").translation.z() ==
            doctest::Approx(0.03).epsilon(0.05));
      CHECK(std::abs(simulation.sensor("energy.residual")) < 1e-3);
    }
}

TEST_CASE("an anchor follows functions of time that the program sets as those of the scenario") {
  const Curve z({0.0, 0.1, 0.2, 0.5, 0.6}, {0.0, 0.0, 0.02, -0.03, -0.03});
  spatial::MountMotion course;
  course.translation = spatial::VectorTable{{Curve{0.0}, Curve{0.0}, z}};
  course.rotation = spatial::VectorTable{{Curve{0.0}, Curve{0.0}, Curve{0.0}}};
  Scenario scenario = make_pitching(kTurning);
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = 1e-3;
  Simulation simulation(scenario, kOneThread);
  simulation.run_until(0.06);
  simulation.set_anchor_motion("plate", course);
  simulation.run_until(0.4);
  CHECK(simulation.anchor_motion("plate").translation.z() == z.value(0.4));
  scenario.space->anchors[0].motion = course;
  Simulation expected(scenario, kOneThread);
  expected.run_until(0.4);
  CHECK(simulation.state_hash() == expected.state_hash());
}

TEST_CASE("the courses in force have the motions of anchors that the program moves") {
  Scenario scenario = make_pitching(kTurning);
  scenario.integration.step = 1e-3;
  Simulation simulation(scenario, kOneThread);
  const Courses at_start = courses(simulation);
  REQUIRE(at_start.anchors.size() == 1);
  CHECK(at_start.anchors[0].anchor == "plate");
  CHECK(!at_start.anchors[0].curves);
  const SavedState start = simulation.save();
  AnchorMotion up = simulation.anchor_motion("plate");
  up.acceleration.z() = 0.5;
  simulation.set_anchor_motion("plate", up);
  simulation.run_until(0.05);
  const SavedState rising = simulation.save();
  const Courses while_rising = courses(simulation);
  CHECK(while_rising.anchors[0].motion.acceleration.z() == 0.5);
  simulation.run_until(0.1);
  const std::uint64_t expected = simulation.state_hash();
  // It stops by a curve, from the place and the rate that it has.
  const double z = simulation.anchor_motion("plate").translation.z();
  CHECK(z == doctest::Approx(0.5 * 0.5 * 0.1 * 0.1).epsilon(1e-9));
  restore(simulation, start, at_start);
  spatial::MountMotion course;
  course.translation =
      spatial::VectorTable{{Curve{0.0}, Curve{0.0}, Curve({0.0, 0.1, 0.2}, {0.0, 0.0, 0.02})}};
  course.rotation = spatial::VectorTable{{Curve{0.0}, Curve{0.0}, Curve{0.0}}};
  simulation.set_anchor_course("plate", course);
  const Courses by_curve = courses(simulation);
  REQUIRE(by_curve.anchors[0].curves);
  simulation.run_until(0.15);
  const std::uint64_t curved = simulation.state_hash();
  restore(simulation, rising, while_rising);
  simulation.run_until(0.1);
  CHECK(simulation.state_hash() == expected);
  restore(simulation, start, by_curve);
  simulation.run_until(0.15);
  CHECK(simulation.state_hash() == curved);
  Courses lost = by_curve;
  lost.anchors[0].anchor = "plates";
  CHECK(message_of([&] { restore(simulation, start, lost); }) ==
        "no anchor is named \"plates\", did you mean \"plate\"?");
}

TEST_CASE("empty braces are the motion of an anchor at rest, not its course") {
  Simulation simulation(make_pitching(kFixed), kOneThread);
  simulation.set_anchor_motion("plate", {});
  CHECK(simulation.anchor_motion("plate").acceleration.isZero(0.0));
}

TEST_CASE("a motion of an anchor that is not the program's, or jumps, is refused") {
  Scenario scenario = make_pitching(kFixed);
  Anchor mast;
  mast.name = "mast";
  mast.motion = spatial::MountMotion{spatial::VectorHarmonic{}, spatial::VectorHarmonic{}};
  scenario.space->anchors.push_back(mast);
  Simulation simulation(scenario, kOneThread);
  simulation.run_until(0.01);
  const std::uint64_t before = simulation.state_hash();
  const auto refusal = [&](const char* name, const AnchorMotion& motion) {
    return message_of([&] { simulation.set_anchor_motion(name, motion); });
  };
  AnchorMotion jump;
  jump.translation.z() = 0.01;
  CHECK(refusal("plate", jump) ==
        "the motion of the anchor \"plate\" does not go on from where it is at t = 0.01 s: it "
        "begins at [0, 0, 0.01] m and [0, 0, 0] rad with the rates [0, 0, 0] m/s and [0, 0, 0] "
        "rad/s and accelerations [0, 0, 0] m/s^2 and [0, 0, 0] rad/s^2, expected [0, 0, 0] m and "
        "[0, 0, 0] rad with [0, 0, 0] m/s and [0, 0, 0] rad/s");
  AnchorMotion broken;
  broken.rotation_acceleration.x() = std::nan("");
  CHECK(refusal("plate", broken).find("does not go on") != std::string::npos);
  CHECK(refusal("mast", {}) ==
        "the anchor \"mast\" follows the scenario, expected motion = { by = \"program\" }");
  CHECK(refusal("plat", {}) == "no anchor is named \"plat\", did you mean \"plate\"?");
  CHECK(message_of([&] { simulation.anchor_motion("mas"); }) ==
        "no anchor is named \"mas\", did you mean \"mast\"?");
  CHECK(simulation.state_hash() == before);
}

TEST_CASE("an anchor that jumps is warned of until the program thinks better of it") {
  const auto warnings = [](const Simulation& simulation) {
    std::string text;
    for (const Warning& warning : simulation.warnings()) text += warning.text;
    return text;
  };
  const auto raised = [](double end) {
    spatial::MountMotion course;
    course.translation = spatial::VectorTable{
        {Curve{0.0}, Curve{0.0}, Curve({0.0, 0.1, end, 1.0}, {0.0, 0.0, 0.02, 0.02})}};
    course.rotation = spatial::VectorHarmonic{};
    return course;
  };
  Scenario scenario = make_pitching(kFixed);
  Simulation simulation(scenario, kOneThread);
  CHECK(warnings(simulation).empty());
  simulation.set_anchor_motion("plate", raised(0.1 + 1e-9));
  CHECK(warnings(simulation)
            .find("the translation of the anchor \"plate\" along z moves by 0.02 m "
                  "within 1e-09 s") != std::string::npos);
  simulation.set_anchor_motion("plate", raised(0.3));
  CHECK(warnings(simulation).empty());
  scenario.space->anchors[0].motion = raised(0.1 + 1e-9);
  CHECK(warnings(Simulation(scenario, kOneThread)).find("the anchor \"plate\"") !=
        std::string::npos);
}
