#include "bench/compare/comparison.h"

#include <doctest/doctest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/compare/files.h"
#include "tests/approx.h"
#include "tests/bench/compare/samples.h"

using namespace spoke;
using namespace spoke::compare;
using spoke::testing::approx;

namespace {

Comparison sample() {
  Measurement failed = measurement_of(kFlow, 3, {});
  failed.hashes.clear();
  failed.status = Status::failed;
  failed.message = "no luck";
  return comparison_of({measurement_of(kSerial, 1, {8e-6, 8e-6, 10e-6, 8e-6}),
                        measurement_of(kFlow, 2, {5e-6, 4e-6, 5e-6, 4e-6}),
                        measurement_of(kFlow, 8, {80e-6, 80e-6}), failed});
}

}  // namespace

TEST_CASE("figures follow from the rounds") {
  const Comparison comparison = sample();
  CHECK(comparison.models[0].serial_step == 8e-6);
  CHECK(comparison.models[0].span_step == approx(2e-6));
  REQUIRE(comparison.results.size() == 4);
  const Figures& two = *comparison.results[1].figures;
  CHECK(two.mean == approx(4.5e-6));
  CHECK(two.median == approx(4.5e-6));
  CHECK(two.speedup == approx(2.0));
  CHECK(two.speedup_low == approx(1.9));
  CHECK(two.bound == approx(4e-6));
  CHECK(two.ratio_to_bound == approx(1.125));
  CHECK(*two.bound_at_capacity == approx(5e-6));
  CHECK(*comparison.results[0].figures->bound_at_capacity == approx(8e-6));  // one thread
  CHECK_FALSE(comparison.results[1].oversubscribed);
  CHECK(comparison.results[2].oversubscribed);
  CHECK(comparison.results[2].figures->bound == approx(4e-6));  // 2 processors
  CHECK(comparison.results[2].figures->speedup == approx(0.1));
  CHECK_FALSE(comparison.results[3].figures);
  const Verdict verdict = judge(comparison, Formulation::structured);
  CHECK(verdict.kind == Verdict::Kind::rival_wins);
  CHECK(verdict.is_winner(comparison.results[1]));
  CHECK_FALSE(verdict.is_winner(comparison.results[0]));
}

TEST_CASE("bits are equal only if every hash is, and of what was run") {
  Measurement other = measurement_of(kFlow, 2, {1e-6});
  other.hashes.back() = 99;
  Measurement none = measurement_of(kFlow, 1, {});
  none.hashes.clear();
  const Comparison comparison = comparison_of(
      {measurement_of(kSerial, 1, {2e-6, 2e-6}), other, none, measurement_of(kFlow, 3, {3e-6})});
  CHECK(comparison.results[0].hash_equal);
  CHECK_FALSE(comparison.results[1].hash_equal);
  CHECK_FALSE(comparison.results[2].hash_equal);
  CHECK(comparison.results[3].hash_equal);
  const Verdict verdict = judge(comparison, Formulation::structured);
  CHECK(verdict.kind == Verdict::Kind::serial_wins);
  CHECK(verdict.rival == &comparison.results[3]);
  CHECK(verdict.is_winner(comparison.results[0]));
}

TEST_CASE("the files hold what was found") {
  const Comparison comparison = sample();
  const auto json = nlohmann::json::parse(make_json(comparison));
  REQUIRE(json["configurations"].size() == 4);
  CHECK(json["configurations"][1]["figures"]["speedup"].get<double>() == approx(2.0));
  CHECK(json["configurations"][1]["figures"]["bound_at_capacity_s"].get<double>() == approx(5e-6));
  CHECK(json["capacity"]["before"] == 1.6);
  CHECK(json["configurations"][1]["step_times_s"].size() == 4);
  CHECK(json["configurations"][3]["figures"].is_null());
  CHECK(json["configurations"][3]["message"] == "no luck");
  CHECK(json["models"][0]["serial_step_s"] == 8e-6);
  CHECK(json["load_average"]["before"] == 0.1);

  std::istringstream lines(make_csv(comparison));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    CHECK(std::count(line.begin(), line.end(), ',') == 18);
  CHECK(count == 5);

  const std::string html = make_html(comparison);
  CHECK(html.find("Rotor &lt;1&gt;") != std::string::npos);
  CHECK(html.find("flow_graph 8") != std::string::npos);
  CHECK(html.find("no luck, oversubscribed") != std::string::npos);
}

TEST_CASE("the page says of pale bars and of all formulations only where there are some") {
  const auto counts = [](const Comparison& comparison) {
    const std::string html = make_html(comparison);
    const auto has = [&](const char* text) { return html.find(text) != std::string::npos; };
    return std::array{has("Pale bars"), has("class=\"bar faint\""), has("All formulations"),
                      has(">Time per step<")};
  };
  const auto serial = measurement_of(kSerial, 1, {10e-6, 10e-6});
  const Comparison few = comparison_of({serial, measurement_of(kFlow, 2, {6e-6, 6e-6})});
  CHECK(counts(few) == std::array{false, false, false, false});
  // On a machine of two processors.
  const Comparison many = comparison_of({serial, measurement_of(kFlow, 3, {6e-6, 6e-6})});
  CHECK(counts(many) == std::array{true, true, false, false});
  Measurement failed = measurement_of(kFlow, 3, {});
  CHECK(counts(comparison_of({serial, failed})) == std::array{false, false, false, false});
  Comparison two = few;
  two.models.push_back({.formulation = Formulation::subsystem, .pass = {8.0, 2.0}});
  CHECK(counts(two) == std::array{false, false, true, true});
}
