#pragma once

#include <cstdio>
#include <cstdlib>

namespace spoke::test {

/// Ends the fuzzer with a message unless `holds`.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace spoke::test
