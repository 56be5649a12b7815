#include "bench/predict/conclusion.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/bench/predict/samples.h"

using namespace spoke;
using namespace spoke::predict;

namespace {

const auto kAuto = ExecutorKind::automatic;
const auto kLevels = ExecutorKind::openmp_levels;

void check_says(const Prediction& prediction, const std::vector<std::string>& parts) {
  const std::string text = make_conclusion(prediction);
  CAPTURE(text);
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
  CHECK(text.find('\n') == std::string::npos);
}

Prediction prediction_of(std::vector<Series> series) {
  Prediction prediction = sample_prediction();
  prediction.series = std::move(series);
  return prediction;
}

}  // namespace

TEST_CASE("the bound is that of a graph, and auto's window has its own") {
  Prediction prediction = sample_prediction();
  check_says(
      prediction,
      {"In runs of one pass, which all but auto make, a step is 10 us of work, 2 us of it on "
       "the costliest path, and whatever the number of threads no executor is then more "
       "than 5.0 times as fast as one thread.",
       "In windows of 50 steps, which auto makes, a step is 10 us of work, 1 us of it",
       "more than 10.0 times"});
  prediction.auto_run.reset();
  check_says(prediction, {"In runs of one pass, a step is 10 us of work"});
  CHECK(make_conclusion(prediction).find("10.0 times") == std::string::npos);
  prediction.run.window = 8;
  check_says(prediction, {"In windows of 8 steps, a step is 10 us of work"});
}

TEST_CASE("a long step's run of auto is of some passes") {
  Prediction prediction = sample_prediction();
  prediction.auto_run->window = 1;
  check_says(prediction, {"In runs of some passes, which auto makes, a step is"});
}

TEST_CASE("where more threads stop paying, or do not pay at all") {
  check_says(prediction_of({series_of(kAuto, {{1, 10e-6}, {2, 5.2e-6}, {4, 5.1e-6}, {8, 5e-6}})}),
             {"More threads stop paying at 2: auto, in windows of 50 steps, 1.92 times serial's "
              "speed on 2 threads (1.75 to 2.14); 8 give 2.00."});
  check_says(prediction_of({series_of(kAuto, {{1, 10e-6}, {2, 5e-6}, {4, 3e-6}})}),
             {"More threads pay up to the 4 looked at: auto, in windows of 50 steps, 3.33 times"});
  check_says(prediction_of({series_of(kAuto, {{1, 10e-6}, {2, 9.8e-6}, {16, 10e-6}})}),
             {"More threads do not pay: auto runs serially, or gains less than a twentieth, on up "
              "to 16 threads."});
  Prediction plain = prediction_of({series_of(kAuto, {{1, 10e-6}, {2, 5e-6}})});
  plain.auto_run.reset();
  check_says(plain, {"auto, in runs of one pass, 2.00 times serial's speed"});
}

TEST_CASE("where level by level is as good as the graph, and where it is not") {
  const Series graph = series_of(kAuto, {{1, 10e-6}, {2, 6e-6}, {4, 4e-6}});
  check_says(prediction_of({graph, series_of(kLevels, {{1, 10e-6}, {2, 6.1e-6}, {4, 3e-6}})}),
             {"Level by level (openmp_levels) is as good as the graph or better on 2, 4 threads."});
  check_says(prediction_of({graph, series_of(kLevels, {{1, 10e-6}, {2, 6.1e-6}, {4, 8e-6}})}),
             {"as good as the graph or better on 2 threads; elsewhere auto is up to 2.00 times as "
              "fast (on 4 threads)."});
  check_says(prediction_of({graph, series_of(kLevels, {{1, 10e-6}, {2, 9e-6}, {4, 5e-6}})}),
             {"Against openmp_levels, auto is up to 1.50 times as fast (on 2 threads)."});
  // On one thread there is nothing to compare.
  const Prediction alone =
      prediction_of({series_of(kAuto, {{1, 10e-6}}), series_of(kLevels, {{1, 20e-6}})});
  CHECK(make_conclusion(alone).find("auto is up to") == std::string::npos);
}

TEST_CASE("the worst of the predictions that were checked is told with its sign") {
  Prediction prediction = prediction_of({series_of(kAuto, {{1, 10e-6}, {2, 6e-6}})});
  check_says(prediction, {"Nothing was measured to check the predictions."});
  measure_as(10.5e-6, 1.0, prediction.serial);
  measure_as(7.5e-6, 1.4, prediction.series[0].points[1]);
  check_says(prediction, {"Of 2 predictions checked on this machine the worst is -20.0 % "
                          "off",
                          "more threads than it has processors (2) are extrapolations"});
  measure_as(300e-6, 1.4, prediction.series[0].points[1]);
  check_says(prediction, {"the worst is too low by a factor of 50;"});
}

TEST_CASE("more load than half the processors makes all of it doubtful, first of all") {
  Prediction prediction = sample_prediction();
  prediction.load_before = 1.1;
  CHECK(make_conclusion(prediction).starts_with("Other work was running (load average 1.10"));
  for (const double load : {0.9, -1.0}) {
    prediction.load_before = load;
    CHECK(make_conclusion(prediction).starts_with("In runs of one pass"));
  }
}

TEST_CASE("executors without a prediction are named with the reason") {
  const bool has_openmp = graph::has_executor(ExecutorKind::openmp_scheme1);
  CHECK(left_out_executors().size() == (has_openmp ? 3 : 0));
  const std::string text = make_conclusion(sample_prediction());
  const auto place =
      text.find("Not predicted: openmp_scheme1, openmp_scheme2, openmp_tasks, since ");
  CHECK((place != std::string::npos) == has_openmp);
}
