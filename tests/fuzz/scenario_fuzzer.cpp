// libFuzzer: any text is a valid scenario or refused by InputError with one line. What follows
// "#set " in lines of the text are overrides of keys.

#include <cmath>
#include <sstream>
#include <string>

#include "models/error.h"
#include "models/scenario.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

namespace {

Overrides find_overrides(const std::string& text) {
  Overrides overrides;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#set ")) overrides.push_back(line.substr(5));
  return overrides;
}

/// Requires everything that the engine relies on.
void check(const Scenario& scenario) {
  require(!scenario.rotor.blades.empty(), "there is a blade");
  for (const Blade& blade : scenario.rotor.blades) {
    require(blade.bodies >= 1 && blade.elements >= 1, "a blade has elements");
    require(std::isfinite(blade.length) && blade.length > 0.0, "a blade is long");
    require(std::isfinite(blade.azimuth), "a blade has a direction");
  }
  for (const PointLoad& load : scenario.rotor.loads) {
    require(load.blade.number() <= static_cast<int>(scenario.rotor.blades.size()),
            "a loaded blade exists");
    require(load.position.value_or(0.0) >= 0.0, "a load is on its blade");
    for (const double t : {-1.0, 0.0, 0.3, 1e30})
      require(!std::isnan(load.factor.value(t)), "a curve has values");
  }
  for (const DistributedLoad& load : scenario.rotor.distributed_loads)
    require(load.from < load.to.value_or(1e31), "a load per length has a length");
  require(scenario.integration.step <= scenario.integration.duration, "there is a step");
  const Drive& drive = scenario.rotor.hub.drive;
  require(!prescribes_motion(drive) || !std::isnan(calc_motion(drive, 0.1).speed),
          "a drive has a speed");
  if (scenario.rotor.blades.size() < 100) require(!scenario.to_json().empty(), "there is JSON");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    check(parse_scenario(text, "fuzz.toml", find_overrides(text)));
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
