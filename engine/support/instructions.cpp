// Asks the compiler, the environment and the processor.

#include "engine/support/instructions.h"

#include <cstdlib>

namespace spoke {

std::string_view instructions_in_use() {
#ifdef SPOKE_NATIVE
  return "native";
#else
  const char* tunables = std::getenv(kTunables);
  if (tunables && std::string_view(tunables).find(kWithoutFusing) != std::string_view::npos)
    return "baseline";
#ifdef __x86_64__
  return __builtin_cpu_supports("fma") ? "fma" : "baseline";
#else
  return "baseline";  // other architectures' baseline has fused multiply-add, or they have none
#endif
#endif
}

}  // namespace spoke
