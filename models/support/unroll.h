#pragma once

// Unrolled loops over a few places, so that places are constants: entries that are zero or equal at
// some of them then cost nothing.

#include <type_traits>
#include <utility>

namespace spoke {

/// Calls visit(std::integral_constant<int, i>) for i = 0 ... n - 1.
template <int n, class Visit>
[[gnu::always_inline]] inline void unroll(Visit&& visit) {
  const auto visit_all = [&]<int... i>(std::integer_sequence<int, i...>)
      __attribute__((always_inline)) {
    (visit(std::integral_constant<int, i>{}), ...);
  };
  visit_all(std::make_integer_sequence<int, n>{});
}

}  // namespace spoke
