#include "graph/machine/thread_trial.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace spoke::graph;

namespace {

int threads_of_this_process() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("Threads:")) return std::stoi(line.substr(8));
  return 0;
}

}  // namespace

TEST_CASE("threads that are tried out are gone afterwards") {
  try_threads(2);  // with the first thread the thread sanitizer adds one of its own
  const int before = threads_of_this_process();
  for (const int threads : {0, 1, 2, 20}) CHECK_NOTHROW(try_threads(threads));
  CHECK(threads_of_this_process() <= before);
}
