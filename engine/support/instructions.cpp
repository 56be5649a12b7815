// Asks the compiler, the environment and the processor.

#include "engine/support/instructions.h"

#include <cstdlib>
#include <utility>

namespace spoke {
namespace {

/// Whether the environment forbids fused multiply-add.
bool is_forbidden() {
  const char* tunables = std::getenv(kTunables);
  return tunables && std::string_view(tunables).find(kWithoutFusing) != std::string_view::npos;
}

/// Whether the processor, and the system that runs it, can do what kernels of wide instructions
/// need.
bool has_wide() {
#if SPOKE_WIDE_KERNELS
  __builtin_cpu_init();  // before main()
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

Kernels choose_kernels() {
  return has_wide() && !is_forbidden() ? Kernels::wide : Kernels::baseline;
}

}  // namespace

namespace detail {
Kernels kernels = choose_kernels();
}

Kernels use_kernels(Kernels kernels) noexcept {
  if (kernels == Kernels::wide && !has_wide()) kernels = Kernels::baseline;
  return std::exchange(detail::kernels, kernels);
}

std::string_view instructions_in_use() {
#ifdef SPOKE_NATIVE
  return "native";
#else
  if (kernels_in_use() == Kernels::wide) return "avx2";
#ifdef __x86_64__
  return __builtin_cpu_supports("fma") && !is_forbidden() ? "fma" : "baseline";
#else
  return "baseline";  // other architectures' baseline has fused multiply-add, or they have none
#endif
#endif
}

}  // namespace spoke
