// Reads the paper's rotor and changes its size.

#include "bench/paper_rotor.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <vector>

namespace spoke::bench {

std::string RotorSize::name() const { return fmt::format("({},{},{})", blades, bodies, elements); }

Scenario sized_rotor(const std::string& file, const RotorSize& size, bool stiffening) {
  const std::vector<std::string> assignments{
      fmt::format("blade.count={}", size.blades), fmt::format("blade.bodies={}", size.bodies),
      fmt::format("blade.elements={}", size.elements),
      fmt::format("blade.geometric_stiffening={}", stiffening)};
  return read_scenario(std::filesystem::path(SPOKE_MODELS_DIR) / file, assignments);
}

Scenario paper_rotor(const RotorSize& size, bool stiffening) {
  return sized_rotor("paper_rotor.toml", size, stiffening);
}

}  // namespace spoke::bench
