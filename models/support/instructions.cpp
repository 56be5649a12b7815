// Asks the compiler, the environment and the processor.

#include "models/support/instructions.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace spoke {
namespace {

/// Whether the environment forbids fused multiply-add.
bool is_forbidden() {
  const char* tunables = std::getenv(kTunables);
  return tunables && std::string_view(tunables).find(kWithoutFusing) != std::string_view::npos;
}

/// Returns the last kernels that the processor, and the system that runs it, can run.
Kernels last_possible() {
#if SPOKE_WIDE_KERNELS
  __builtin_cpu_init();  // before main()
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return Kernels::baseline;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                 __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw")
             ? Kernels::avx512
             : Kernels::avx2;
#else
  return Kernels::baseline;
#endif
}

Kernels choose_kernels() { return is_forbidden() ? Kernels::baseline : last_possible(); }

}  // namespace

namespace detail {
Kernels kernels = choose_kernels();
}

Kernels use_kernels(Kernels kernels) noexcept {
  // The prohibition by the environment stands: the C library keeps to it, too.
  return std::exchange(detail::kernels, std::min(kernels, choose_kernels()));
}

std::string_view name_of(Kernels kernels) {
  switch (kernels) {
    case Kernels::baseline:
      return "baseline";
    case Kernels::avx2:
      return "avx2";
    case Kernels::avx512:
      break;
  }
  return "avx512";
}

std::string_view instructions_in_use() {
#ifdef SPOKE_NATIVE
  return "native";
#else
  if (kernels_in_use() != Kernels::baseline) return name_of(kernels_in_use());
#ifdef __x86_64__
  return __builtin_cpu_supports("fma") && !is_forbidden() ? "fma" : "baseline";
#else
  return "baseline";  // other architectures' baseline has fused multiply-add, or they have none
#endif
#endif
}

}  // namespace spoke
