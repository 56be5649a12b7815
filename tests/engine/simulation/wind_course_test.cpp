// Wind that the program gives at the hub: against the same wind as a function of place and time,
// and as a scenario describes it.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::Vector3d;

namespace {

const SimulationOptions kSerialWind{Formulation::structured, ExecutorKind::serial, 1, 1};

/// A rotor in air, 10 m over the ground; `wind`: further keys of it.
std::string blown(const std::string& wind) {
  return "world = \"space\"\n" + kTurnedHub + kBooms + kAir +
         "shear_exponent = 0.3\nreference_height = 10.0\nground = -10.0\n" + wind +
         "[integration]\nstep = 0.00390625\nduration = 1.0\n";
}

/// A rotor without air.
const std::string kStillAir =
    "world = \"space\"\n" + kTurnedHub + kBooms + "[integration]\nduration = 1.0\n";

Scenario parse_blown(const std::string& wind = "") {
  return parse_scenario(blown(wind), "wind_course.toml");
}

/// The courses that follow one another: straight lines from the scenario's wind on, and back.
std::vector<WindCourse> make_courses() {
  const std::vector<Vector3d> places{
      {0.5, 3.0, 1.0}, {0.5, 3.0, 1.0}, {2.5, 5.0, 0.0}, {-1.5, 5.0, 1.0}, {0.5, 3.0, 1.0}};
  std::vector<WindCourse> courses;
  for (std::size_t k = 1; k < places.size(); ++k)
    courses.push_back({0.125 * static_cast<double>(k - 1), 0.125 * static_cast<double>(k),
                       places[k - 1], places[k]});
  return courses;
}

}  // namespace

TEST_CASE("a wind that is set step by step is the same wind as a function, bit for bit") {
  const std::vector<WindCourse> courses = make_courses();
  Scenario scenario = parse_blown();
  Simulation simulation(scenario, kSerialWind);
  scenario.space->air->wind = Wind{};
  scenario.space->air->wind.field = make_wind_field([&](const Vector3d& place, double t) {
    std::size_t k = 0;
    while (k + 1 < courses.size() && t > courses[k].end) ++k;
    return Vector3d(courses[k].at(t) * std::pow((place.z() + 10.0) / 10.0, 0.3));
  });
  Simulation expected(scenario, kSerialWind);
  for (const WindCourse& course : courses) {
    CHECK(wind_at_hub(simulation) == course.velocity);
    set_wind(simulation, course);
    CHECK(wind_at_hub(simulation) == course.velocity);
    for (Simulation* each : {&simulation, &expected}) each->run_until(course.end);
    // A wind along none of the axes has its length and direction rounded by the description.
    const std::vector<double> got = values_of(simulation), wanted = values_of(expected);
    for (std::size_t k = 0; k < got.size(); ++k) {
      CAPTURE(simulation.sensor_names()[k]);
      CHECK(got[k] == doctest::Approx(wanted[k]).epsilon(1e-9));
    }
  }
}

TEST_CASE("a wind that jumps is that of a scenario that blows so, once the air has followed") {
  // No states of the air: it follows at once.
  const std::string rest = "[aerodynamics]\ninflow = \"quasi_steady\"\nstall = \"static\"\n";
  Scenario scenario = parse_blown(rest), other = scenario;
  scenario.integration.method = other.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = other.integration.step = 2e-4;
  other.space->air->wind.velocity = {0.0, 5.0, 0.0};
  other.space->air->wind.kept.reset();
  Simulation simulation(scenario, kSerialWind), expected(other, kSerialWind);
  set_wind(simulation, {0.0, 0.0, {}, {0.0, 5.0, 0.0}});
  for (Simulation* each : {&simulation, &expected}) each->run_until(0.1);
  for (const std::string name : {"hub.speed", "blade1.tip.z", "air.thrust", "air.wind"}) {
    CAPTURE(name);
    CHECK(simulation.sensor(name) == doctest::Approx(expected.sensor(name)).epsilon(1e-9));
  }
}

TEST_CASE("a simulation goes back to a state with the wind that blew there") {
  Simulation simulation(parse_blown("turbulence = { intensity = 0.1, width = 8.0, points = 4, "
                                    "duration = 4.0 }\n"),
                        kSerialWind);
  simulation.run_until(0.25);
  const SavedState early = simulation.save();
  const Courses none = courses(simulation);
  CHECK(!none.wind);
  const Vector3d turbulent = wind_at_hub(simulation);
  const WindCourse course{0.25, 0.5, turbulent, {1.0, 4.0, 0.0}};
  set_wind(simulation, course);
  CHECK(wind_at_hub(simulation) == turbulent);
  simulation.run_until(0.375);
  const SavedState late = simulation.save();
  const Courses blowing = courses(simulation);
  REQUIRE(blowing.wind);
  CHECK(blowing.wind->end == course.end);
  CHECK(blowing.wind->target == course.target);
  simulation.run_until(0.75);
  CHECK(wind_at_hub(simulation) == course.target);
  const std::uint64_t expected = simulation.state_hash();
  restore(simulation, early, none);
  CHECK(wind_at_hub(simulation) == turbulent);
  simulation.run_until(0.5);
  restore(simulation, late, blowing);
  simulation.run_until(0.75);
  CHECK(simulation.state_hash() == expected);
}

TEST_CASE("a restored state has the sensors of the air that were saved") {
  const std::string outer =
      "[[sensor]]\nname = \"outer\"\nquantity = \"air_load\"\nblade = 1\nposition = 1.2\n";
  Simulation simulation(parse_blown(outer), kSerialWind), other(parse_blown(outer), kSerialWind);
  simulation.run_until(0.25);
  const std::vector<double> expected = values_of(simulation);
  const SavedState state = simulation.save();
  other.run_until(0.1);
  other.restore(state);
  CHECK(values_of(other) == expected);
  simulation.run_until(0.5);
  simulation.restore(state);
  CHECK(values_of(simulation) == expected);
}

TEST_CASE("the mean wind of a scenario is that at its hub, without gusts and turbulence") {
  CHECK(find_mean_wind(parse_blown("gust = { amplitude = 3.0 }\n"))
            .value()
            .isApprox(Vector3d(0.5, 3.0, 1.0), 1e-12));
  Scenario low = parse_blown();
  low.space->air->wind.ground = 1.0;
  CHECK(!find_mean_wind(low));
  CHECK(!find_mean_wind(parse_scenario(kStillAir, "f.toml")));
}

TEST_CASE("winds are refused where no air acts, and where they are none") {
  Simulation calm(parse_scenario(kStillAir, "f.toml"), kSerialWind);
  CHECK(contains(message_of([&] { set_wind(calm, {}); }), "no air acts on the model"));
  CHECK(contains(message_of([&] { wind_at_hub(calm); }), "no air acts on the model"));
  const SavedState state = calm.save();
  CHECK(contains(message_of([&] {
                   restore(calm, state, {calm.drive(), {}, {}, WindCourse{}});
                 }),
                 "no air acts on the model"));
  Simulation simulation(parse_blown(), kSerialWind);
  const Vector3d before = wind_at_hub(simulation);
  WindCourse endless;
  endless.target.x() = std::numeric_limits<double>::infinity();
  CHECK(contains(message_of([&] { set_wind(simulation, endless); }), "not finite"));
  CHECK(wind_at_hub(simulation) == before);
}
