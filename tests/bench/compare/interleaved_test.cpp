#include "bench/compare/interleaved.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace bench = spoke::bench;

namespace {

void sleep_for(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

TEST_CASE("in every round all take a turn, and the first to do so moves on") {
  std::string turns;
  int last = -1;
  bench::take_turns(3, 4, [&](std::size_t contender, int round) {
    if (round != last) turns += '|';
    last = round;
    turns += static_cast<char>('a' + contender);
  });
  CHECK(turns == "|abc|bca|cab|abc");
  CHECK(bench::describe_turn(1, 15, "serial") == "round 2 of 15: serial");
}

TEST_CASE("alternatives are timed against the one that they refer to, round by round") {
  int prepared = 0;
  const auto prepare = [&prepared] { ++prepared; };
  const std::vector<bench::Alternative> alternatives{
      {"short", [] { sleep_for(2); }, prepare},
      {"long", [] { sleep_for(6); }, prepare},
      {"half", [] { sleep_for(2); }, prepare, 0.5, 1}};
  std::vector<std::string> told;
  const auto timings = bench::measure(alternatives, {5, 1e-3, 10.0},
                                      [&told](const std::string& text) { told.push_back(text); });
  REQUIRE(timings.size() == 3);
  CHECK(prepared == 3 * (1 + 5));  // a warm-up, and before each turn
  for (const bench::Timing& timing : timings) CHECK(timing.rounds == 5);
  CHECK(timings[0].ratio == 1.0);
  CHECK(timings[0].least >= 2e-3);
  CHECK(timings[1].ratio > 1.0);
  CHECK(timings[2].ratio < 1.0);  // half of the time of the short one, by the long one's
  CHECK(told.front() == "warming up short");
  CHECK(told.back().starts_with("round 5 of 5: "));
}

TEST_CASE("an alternative that takes too long is in the first rounds only") {
  const std::vector<bench::Alternative> alternatives{{"quick", [] {}, {}},
                                                     {"slow", [] { sleep_for(20); }, {}}};
  const auto timings = bench::measure(alternatives, {7, 1e-4, 0.05}, [](const std::string&) {});
  CHECK(timings[0].rounds == 7);
  CHECK(timings[1].rounds >= 1);
  CHECK(timings[1].rounds <= 2);
}
