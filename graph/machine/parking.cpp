// Sleeping by Linux's futex, or by std::atomic on other systems.

#include "graph/machine/parking.h"

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <limits>
#endif

namespace spoke::graph {

#ifdef __linux__

static_assert(sizeof(std::atomic<std::uint32_t>) == sizeof(std::uint32_t));

void park(const std::atomic<std::uint32_t>& value, std::uint32_t seen) {
  syscall(SYS_futex, &value, FUTEX_WAIT_PRIVATE, seen, nullptr, nullptr, 0);
}

void unpark_all(std::atomic<std::uint32_t>& value) {
  syscall(SYS_futex, &value, FUTEX_WAKE_PRIVATE, std::numeric_limits<int>::max(), nullptr, nullptr,
          0);
}

#else

void park(const std::atomic<std::uint32_t>& value, std::uint32_t seen) { value.wait(seen); }
void unpark_all(std::atomic<std::uint32_t>& value) { value.notify_all(); }

#endif

}  // namespace spoke::graph
