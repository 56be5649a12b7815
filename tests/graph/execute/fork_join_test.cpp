#include "graph/execute/fork_join.h"

#include <doctest/doctest.h>

#include <numeric>
#include <thread>
#include <vector>

using namespace spoke::graph;

namespace {

// Counts, without atomics, how often each thread of a team worked: the fork publishes the first
// thread's writes, the join those of the others.
std::vector<int> works_done(int threads, int forks) {
  ForkJoin<int> team;
  team.set_workers(threads - 1);
  std::vector<int> done(static_cast<std::size_t>(threads), 0);
  std::vector<std::thread> workers;
  for (std::size_t i = 1; i < done.size(); ++i)
    workers.emplace_back([&team, &mine = done[i]] { team.serve([&](int work) { mine += work; }); });
  int work = 0;
  for (int fork = 0; fork < forks; ++fork) {
    work = std::accumulate(done.begin() + 1, done.end(), 0) == fork * (threads - 1) ? 1 : 1000;
    team.fork(&work);
    ++done[0];
    team.join();
  }
  team.fork(nullptr);
  for (std::thread& worker : workers) worker.join();
  return done;
}

}  // namespace

TEST_CASE("every fork is worked on once by every other thread, and joined") {
  for (const int threads : {1, 2, 3, 7}) {
    CAPTURE(threads);
    constexpr int forks = 500;
    CHECK(works_done(threads, forks) == std::vector<int>(static_cast<std::size_t>(threads), forks));
  }
}
