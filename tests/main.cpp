#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <oneapi/tbb/global_control.h>

#include <cstdlib>

// oneTBB would let no more threads work than there are processors. Here as many work as tests ask
// for, so that what they do is interleaved in more ways.
int main(int argc, char** argv) {
  using oneapi::tbb::global_control;
  constexpr std::size_t most_threads = 64;
  const global_control more_threads(global_control::max_allowed_parallelism, most_threads);
  // Nothing that an earlier build has made may serve a test.
  setenv("SPOKE_CACHE", "none", 1);
  return doctest::Context(argc, argv).run();
}
