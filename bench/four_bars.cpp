// Repeats the bodies, joints and closures of a linkage.

#include "bench/four_bars.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

namespace spoke::bench {

Scenario row_of_four_bars(int count) {
  Scenario scenario = read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / "four_bar.toml");
  scenario.sensors.clear();
  spatial::Subsystem& row = scenario.space->subsystems.front();
  const spatial::Body bar = row.bodies[0], coupler = row.bodies[3];
  const spatial::SubsystemJoint on_hub = row.joints[0], on_bar = row.joints[3];
  const Loop closure = row.loops[0];
  const auto name = [](const char* of, int k) { return fmt::format("{}_{}", of, k); };
  row.bodies.clear();
  row.joints.clear();
  row.loops.clear();
  for (int k = 0; k <= count; ++k) {
    row.bodies.push_back(bar);
    row.bodies.back().name = name("bar", k);
    row.joints.push_back(on_hub);
    row.joints.back().child = name("bar", k);
    row.joints.back().joint.name = name("A", k);
    row.joints.back().joint.offset.x() = k;
  }
  for (int k = 1; k <= count; ++k) {
    row.bodies.push_back(coupler);
    row.bodies.back().name = name("coupler", k);
    row.joints.push_back(on_bar);
    row.joints.back().parent = name("bar", k - 1);
    row.joints.back().child = name("coupler", k);
    row.joints.back().joint.name = name("B", k - 1);
    row.loops.push_back(closure);
    row.loops.back().name = name("close", k);
    row.loops.back().from.name = name("coupler", k);
    row.loops.back().to.name = name("bar", k);
  }
  return scenario;
}

}  // namespace spoke::bench
