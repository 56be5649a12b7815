// Reads the paper's rotor and changes its size.

#include "bench/paper_rotor.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

namespace spoke::bench {

std::string RotorSize::name() const { return fmt::format("({},{},{})", blades, bodies, elements); }

Scenario paper_rotor(const RotorSize& size, bool stiffening) {
  return read_scenario(
      std::filesystem::path(SPOKE_MODELS_DIR) / "paper_rotor.toml",
      {fmt::format("blade.count={}", size.blades), fmt::format("blade.bodies={}", size.bodies),
       fmt::format("blade.elements={}", size.elements),
       fmt::format("blade.geometric_stiffening={}", stiffening)});
}

}  // namespace spoke::bench
