#include "graph/plan/static_share.h"

#include <doctest/doctest.h>

using namespace spoke::graph;

TEST_CASE("shares follow each other, cover all items, and differ by one, the larger ones first") {
  for (std::size_t items = 0; items < 20; ++items) {
    for (int threads = 1; threads < 14; ++threads) {
      CAPTURE(items);
      CAPTURE(threads);
      const auto count = static_cast<std::size_t>(threads);
      std::size_t end = 0;
      for (int thread = 0; thread < threads; ++thread) {
        const StaticShare share = static_share(items, thread, threads);
        CHECK(share.begin == end);
        end = share.end;
        const std::size_t size = share.end - share.begin;
        CHECK(size >= items / count);
        CHECK(size <= (items + count - 1) / count);
      }
      CHECK(end == items);
      CHECK(static_share(items, 0, threads).end == (items + count - 1) / count);
    }
  }
}
