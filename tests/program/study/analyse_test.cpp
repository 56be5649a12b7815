#include "program/study/analyse.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/program/study/studies.h"

using namespace spoke::study;
using spoke::test::analyse_function;
using spoke::test::make_study;

namespace {

// T. Ishigami and T. Homma, "An importance quantification technique in uncertainty analysis for
// computer models", ISUMA 1990, with a = 7 and b = 0.1; the indices in closed form.
constexpr double kA = 7.0, kB = 0.1;
const double kPi4 = std::pow(std::numbers::pi, 4);
const double kVariance = kA * kA / 8.0 + kB * kPi4 / 5.0 + kB * kB * kPi4 * kPi4 / 18.0 + 0.5;
const double kFirst1 = 0.5 * std::pow(1.0 + kB * kPi4 / 5.0, 2) / kVariance;
const double kFirst2 = kA * kA / 8.0 / kVariance;
const double kTotal3 = 8.0 * kB * kB * kPi4 * kPi4 / 225.0 / kVariance;

double ishigami(const std::vector<double>& x) {
  const double s = std::sin(x[1]);
  return std::sin(x[0]) + kA * s * s + kB * std::pow(x[2], 4) * std::sin(x[0]);
}

}  // namespace

TEST_CASE("Sobol indices of the Ishigami function at 4096 points are within 1 %") {
  Study study = make_study(DesignKind::saltelli, 3, -std::numbers::pi, std::numbers::pi, 4096);
  for (const std::uint64_t seed : {0U, 1U, 2U, 3U}) {
    study.design.seed = seed;
    const Analysis analysis = analyse_function(study, ishigami);
    const std::vector<SobolIndex>& found = analysis.responses[0].indices;
    REQUIRE(found.size() == 3);
    CHECK(analysis.responses[0].index_points == 4096);
    CAPTURE(seed);
    CHECK(std::abs(found[0].first / kFirst1 - 1.0) < 0.01);
    CHECK(std::abs(found[1].first / kFirst2 - 1.0) < 0.01);
    CHECK(std::abs(found[2].first) < 0.01);
    CHECK(std::abs(found[0].total / (kFirst1 + kTotal3) - 1.0) < 0.01);
    CHECK(std::abs(found[1].total / kFirst2 - 1.0) < 0.01);
    CHECK(std::abs(found[2].total / kTotal3 - 1.0) < 0.01);
  }
}

TEST_CASE("points with a run that has no response are left out of the indices") {
  const Study study = make_study(DesignKind::saltelli, 2, 0.0, 1.0, 1024);
  const Analysis analysis = analyse_function(
      study, [](const std::vector<double>& x) { return x[0] > 0.99 ? NAN : x[0] + 2.0 * x[1]; });
  const ResponseAnalysis& found = analysis.responses[0];
  CHECK(found.index_points < 1024);
  CHECK(found.index_points > 980);
  CHECK(std::abs(found.indices[1].first - 0.8) < 0.02);
}

TEST_CASE("main effects of a sum are the shares of its terms, and their means its slopes") {
  for (const DesignKind kind : {DesignKind::latin_hypercube, DesignKind::sobol}) {
    const Study study = make_study(kind, 3, -1.0, 1.0, 4000);
    const Analysis analysis = analyse_function(
        study, [](const std::vector<double>& x) { return 2.0 * x[0] + x[1] + 5.0; });
    const ResponseAnalysis& found = analysis.responses[0];
    CHECK(std::abs(found.summary.mean - 5.0) < 0.01);
    CHECK(std::abs(found.summary.deviation - std::sqrt(5.0 / 3.0)) < 0.01);
    REQUIRE(found.effects.size() == 3);
    CHECK(std::abs(found.effects[0].share - 0.8) < 0.02);
    CHECK(std::abs(found.effects[1].share - 0.2) < 0.02);
    CHECK(found.effects[2].share < 0.01);
    for (const EffectLevel& level : found.effects[0].levels)
      CHECK(std::abs(level.mean - 5.0 - (level.low + level.high)) < 0.15);
  }
}

TEST_CASE("the variance of a grid is that of its factors, and of what they do together") {
  Study study = make_study(DesignKind::grid, 2, 0.0, 0.0, 9);
  study.parameters[0].levels = {{-1.0, {}}, {0.0, {}}, {1.0, {}}};
  study.parameters[1].levels = {{-1.0, {}}, {0.0, {}}, {1.0, {}}};
  const Analysis analysis = analyse_function(
      study, [](const std::vector<double>& x) { return 3.0 * x[0] + x[0] * x[1]; });
  // Variances over the nine levels: of 3 a 9 * 2/3, of a b 4/9.
  const double total = 6.0 + 4.0 / 9.0;
  const ResponseAnalysis& found = analysis.responses[0];
  CHECK(std::abs(found.effects[0].share - 6.0 / total) < 1e-12);
  CHECK(std::abs(found.effects[1].share) < 1e-12);
  CHECK(found.effects[0].levels[2].mean == doctest::Approx(3.0));
  CHECK(found.summary.run_of_max == 8);
}

TEST_CASE("runs that ended badly are counted and listed") {
  const Study study = make_study(DesignKind::sobol, 1, 0.0, 1.0, 4);
  const Sampling sampling(study);
  const Analysis analysis = analyse(study, sampling, [](const Visitor& visit) {
    for (std::int64_t run = 0; run < 4; ++run) {
      RunResult result;
      result.run = run;
      result.status = static_cast<RunStatus>(run);
      result.responses = {result.has_responses() ? 1.0 : NAN};
      visit(result);
    }
  });
  CHECK(analysis.counts.done == 1);
  CHECK(analysis.counts.doubtful == 1);
  CHECK(analysis.counts.without_responses() == 2);
  REQUIRE(analysis.failed.size() == 2);
  CHECK(analysis.failed[1].run == 3);
  CHECK(analysis.failed[1].status == RunStatus::refused);
  CHECK(analysis.responses[0].summary.count == 2);
}
