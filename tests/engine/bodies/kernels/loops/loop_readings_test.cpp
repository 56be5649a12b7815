// Tests what sensors and queries show of closed loops, by forces and motions that are known.

#include "engine/bodies/kernels/loops/loop_readings.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/loop_models.h"
#include "tests/engine/serial.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr Formulation kFormulations[] = {Formulation::structured, Formulation::subsystem,
                                         Formulation::augmented};

}  // namespace

TEST_CASE("a rod that holds a slider on a turning hub has the centrifugal force as tension") {
  Scenario scenario = make_slider();
  for (const SensorFrame frame : {SensorFrame::loop, SensorFrame::hub, SensorFrame::inertial})
    scenario.sensors.push_back(loop_sensor(SensorQuantity::loop_reaction,
                                           std::string(name_of(frame)), "rail", "rod", frame));
  scenario.sensors.push_back(loop_sensor(SensorQuantity::loop_opening, "opening", "rail", "rod"));
  const double tension = 2.0 * 0.5 * 3.0 * 3.0;  // m r w^2
  for (const Formulation formulation : kFormulations)
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
      CAPTURE(name_of(formulation));
      CAPTURE(name_of(method));
      scenario.integration.method = method;
      Simulation simulation(scenario, serial(formulation));
      const auto close = [&](const std::string& sensor, double value) {
        CAPTURE(sensor);
        CHECK(simulation.sensor("rail." + sensor) ==
              doctest::Approx(value).scale(20.0).epsilon(1e-9));
      };
      for (const double t : {0.0, 0.4}) {
        simulation.run_until(t);
        close("loop.force.x", tension);
        close("loop.force.y", 0.0);
        close("hub.force.x", -tension);
        close("inertial.force.x", -tension * std::cos(3.0 * t));
        close("inertial.force.y", -tension * std::sin(3.0 * t));
        close("inertial.moment.z", 0.0);
        close("opening.x", 0.0);
        const Wrench wrench = simulation.loop_reaction(0, "rod");
        CHECK(wrench.force.x() == doctest::Approx(-tension * std::cos(3.0 * t)));
        CHECK(wrench.force.y() == doctest::Approx(-tension * std::sin(3.0 * t)).scale(20.0));
      }
    }
}

TEST_CASE("the elongation of a sprung rod is that of its places, and its tension the spring's") {
  Scenario scenario = make_slider();
  Loop& rod = scenario.space->subsystems[0].loops[0];
  rod.stiffness = {400.0};
  for (const SensorQuantity quantity :
       {SensorQuantity::loop_reaction, SensorQuantity::loop_opening})
    scenario.sensors.push_back(loop_sensor(quantity, "", "rail", "rod"));
  Sensor place;
  place.subsystem = "rail";
  place.body = "slider";
  scenario.sensors.push_back(place);
  Simulation simulation(scenario, serial(Formulation::structured));
  for (const double t : {0.05, 0.17, 0.5}) {
    simulation.run_until(t);
    const double elongation = simulation.sensor("rail.loop_opening.x");
    CHECK(elongation > 1e-3);
    CHECK(elongation == doctest::Approx(simulation.sensor("rail.displacement.x")).epsilon(1e-9));
    CHECK(simulation.sensor("rail.loop_reaction.force.x") ==
          doctest::Approx(400.0 * elongation).epsilon(1e-8));
  }
}

TEST_CASE("a pitch link at rest carries the weight by its arm, in compression below the horn") {
  Scenario scenario = make_pitching("drive = { kind = \"fixed\" }");
  scenario.sensors.push_back(loop_sensor(SensorQuantity::loop_reaction, "link", "bladeA", "link"));
  Simulation simulation(scenario, serial(Formulation::structured));
  const double force = 2.0 * 9.81 * 0.05 / 0.1;
  for (const double t : {0.0, 0.1}) {
    simulation.run_until(t);
    CHECK(simulation.sensor("bladeA.link.force.x") == doctest::Approx(-force).epsilon(1e-9));
    CHECK(simulation.loop_reaction(0, "link").force.z() == doctest::Approx(force).epsilon(1e-9));
  }
  CHECK(message_of([&] { simulation.loop_reaction(0, "lnk"); }) ==
        "no loop of bladeA is named \"lnk\", did you mean \"link\"?");
  CHECK(message_of([&] {
          simulation.loop_reaction(3, "link");
        }).find("the index of the blade or subsystem is 3") != std::string::npos);
}
