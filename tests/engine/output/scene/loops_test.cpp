// Closed loops in scenes: where they are on what carries them, and that frames show them closed.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/output/scene/deformed.h"
#include "engine/output/scene/make_scene.h"
#include "tests/shipped.h"

using doctest::Approx;
using namespace spoke;
using namespace spoke::scene;
using namespace spoke::test;

namespace {

const SimulationOptions kOneThread{Formulation::structured, ExecutorKind::serial, 1};

const Solid* find_solid(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.solids.begin(), scene.solids.end(),
                                  [&](const Solid& solid) { return solid.name == name; });
  return found == scene.solids.end() ? nullptr : &*found;
}

/// Returns how far the ends of a loop are apart [m].
double span_of(const LoopMark& loop, const Deformed& deformed) {
  return (deformed.at(loop.from).position - deformed.at(loop.to).position).norm();
}

}  // namespace

TEST_CASE("a pitch link goes from the horn of its blade to the swashplate") {
  const Scene scene = make_scene(read_shipped("helicopter_rotor"), 2000);
  REQUIRE(scene.loops.size() == 4);
  REQUIRE(scene.carriers.size() == 2);
  CHECK(scene.carriers[0].anchor == -1);
  CHECK(scene.carriers[1].anchor == 0);
  const LoopMark& link = scene.loops[1];  // of the blade along y
  CHECK(link.name == "blade 2 / pitch_link");
  CHECK(link.kind == "distance");
  CHECK_FALSE(link.is_sprung);
  CHECK(link.from.node >= 0);
  CHECK((link.from.p - Vector(-0.2, 0.3, 0.0)).norm() < 1e-9);
  CHECK(link.to.node == -1);
  CHECK(link.to.group == scene.carriers[1].group);
  CHECK((link.to.p - Vector(-0.2, 0.3, -0.3)).norm() < 1e-9);
  // The plate goes through the four places.
  const Solid* plate = find_solid(scene, "swashplate");
  REQUIRE(plate != nullptr);
  CHECK(plate->group == scene.carriers[1].group);
  for (const Vector& vertex : plate->vertices) {
    CHECK(std::hypot(vertex.x(), vertex.y()) == Approx(std::hypot(0.3, 0.2)));
    CHECK(std::abs(vertex.z() + 0.3) < 0.1);
  }
}

TEST_CASE("frames show loops closed and rods as long as they are") {
  for (const char* name :
       {"andrews_squeezer", "four_bar", "bricard", "helicopter_rotor", "vehicle"}) {
    CAPTURE(name);
    Scenario scenario = read_shipped(name);
    for (Anchor& anchor : scenario.space->anchors)  // at once
      anchor.motion = spatial::MountMotion{
          spatial::VectorHarmonic{Vector(0.0, 0.0, 0.01), Vector(0.0, 0.0, 0.05), Vector::Zero(),
                                  0.0, 0.0},
          spatial::VectorHarmonic{Vector(0.02, 0.0, 0.0), Vector::Zero(), Vector(0.0, 0.05, 0.0),
                                  3.0, 0.0}};
    const Scene scene = make_scene(scenario, 2000);
    Simulation simulation(scenario, kOneThread);
    Frame frame;
    FrameReader reader(scene);
    reader.read(simulation, frame);
    std::vector<double> spans;
    for (const LoopMark& loop : scene.loops) spans.push_back(span_of(loop, Deformed(scene, frame)));
    simulation.run_until(50.0 * simulation.step_size());
    reader.read(simulation, frame);
    const Deformed deformed(scene, frame);
    for (std::size_t k = 0; k < scene.loops.size(); ++k) {
      const LoopMark& loop = scene.loops[k];
      CAPTURE(loop.name);
      if (loop.kind != "distance") {
        CHECK(spans[k] < 1e-9);
        CHECK(span_of(loop, deformed) < 1e-9);
      } else if (!loop.is_sprung) {
        CHECK(span_of(loop, deformed) == Approx(spans[k]).epsilon(1e-6));
      }
      if (loop.name.ends_with("pitch_link")) CHECK(spans[k] == Approx(0.3).epsilon(1e-6));
    }
  }
}

TEST_CASE("the first frame has anchors where they begin") {
  Scenario scenario = read_shipped("helicopter_rotor");
  scenario.space->anchors[0].motion =
      ProgramAnchorMotion{Vector(0.0, 0.0, 0.02), Vector(0.1, 0.0, 0.0)};
  const Scene scene = make_scene(scenario, 2000);
  Frame simulated;
  FrameReader(scene).read(Simulation(scenario, kOneThread), simulated);
  const Frame drawn = make_first_frame(scenario, scene);
  for (const Carrier& carrier : scene.carriers) {
    const auto g = static_cast<std::size_t>(carrier.group);
    CHECK((drawn.groups[g].position - simulated.groups[g].position).norm() < 1e-12);
    CHECK((drawn.groups[g].rotation - simulated.groups[g].rotation).norm() < 1e-12);
  }
  CHECK(drawn.groups[2].position.z() == 0.02);
  CHECK(drawn.groups[2].rotation(2, 1) == Approx(std::sin(0.1)));
}
