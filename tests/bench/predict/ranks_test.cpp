#include "bench/predict/ranks.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "bench/predict/conclusion.h"
#include "bench/predict/table.h"
#include "tests/approx.h"
#include "tests/bench/predict/samples.h"

using namespace spoke;
using namespace spoke::predict;
using spoke::testing::approx;

namespace {

constexpr Network kNetwork{1e-6, true};

/// Nodes of two subsystems, and those that wait for both.
graph::StepGraph make_graph(bool is_coupled) {
  graph::StepGraphBuilder builder;
  const auto add = [&builder](const char* stage, int subsystem) {
    builder.add_node({stage, subsystem}, {}, {}, []() noexcept {});
  };
  add("mass", 0);
  add("mass", 1);
  add("hub solve", -1);
  add("finish", is_coupled ? -1 : 1);
  return builder.build();
}

/// Subsystems of equal cost, one after the other.
std::vector<int> in_halves(int count) {
  std::vector<int> first{0};
  for (int r = 1; r <= count; ++r) first.push_back(r * 8 / count);
  return first;
}

}  // namespace

TEST_CASE("a step is shared out by the subsystems of its nodes") {
  const NodeMeasurement nodes{
      .costs = {1.0, 2.0, 4.0, 8.0}, .run_times = {}, .between_runs = 0.5, .runs_per_step = 2.0};
  const StepShares coupled = find_shares(make_graph(true), nodes, 64);
  CHECK(coupled.subsystems == std::vector<double>{2.0, 4.0});
  CHECK(coupled.common == 25.0);
  CHECK(coupled.exchanges == 4.0 + 1.0 / 64.0);
  const StepShares driven = find_shares(make_graph(false), nodes, 8);
  CHECK(driven.subsystems == std::vector<double>{2.0, 20.0});
  CHECK(driven.common == 9.0);
  CHECK(driven.exchanges == 0.125);
}

TEST_CASE("processes take the largest share, what all do, and messages by halving") {
  const StepShares shares{std::vector<double>(8, 1e-6), 2e-6, 4.0};
  const std::vector<int> counts{1, 2, 3, 8};
  const auto points = predict_ranks(shares, kNetwork, counts, in_halves);
  REQUIRE(points.size() == 4);
  CHECK(points[0].step() == approx(10e-6));
  CHECK(points[0].telling == 0.0);
  CHECK(points[1].computing == approx(6e-6));
  CHECK(points[1].telling == approx(4e-6));
  CHECK(points[2].computing == approx(5e-6));
  CHECK(points[2].telling == approx(8e-6));
  CHECK(points[3].computing == approx(3e-6));
  CHECK(points[3].telling == approx(12e-6));
}

TEST_CASE("the conclusion says how many processes pay, or that none do") {
  Prediction prediction = sample_prediction();
  CHECK(make_conclusion(prediction).find("rocesses") == std::string::npos);
  prediction.ranks = {{1, 8e-6, 0.0}};  // alone
  CHECK(make_conclusion(prediction).find("rocesses") == std::string::npos);
  prediction.ranks = {{2, 4e-6, 1e-6}, {4, 2e-6, 2e-6}, {8, 1e-6, 3e-6}};
  CHECK(make_conclusion(prediction)
            .find("Processes of one thread each pay up to 4 of those looked at: 2.50 times "
                  "serial's speed, 50 % of the time on the network.") != std::string::npos);
  CHECK(make_rank_table(prediction).rows.size() == 3);
  prediction.ranks = {{1, 8e-6, 0.0}, {2, 6e-6, 50e-6}, {4, 4e-6, 100e-6}};
  CHECK(make_conclusion(prediction)
            .find("Several processes do not pay: 2 give 0.18 times serial's speed.") !=
        std::string::npos);
}
