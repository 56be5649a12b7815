#include "bench/compare/rounds.h"

#include <doctest/doctest.h>

#include <numeric>

#include "models/error.h"

using namespace spoke;
using namespace spoke::compare;

namespace {

constexpr const char* kObedient =
    "echo ready; h=0; while read w; do h=$((h+1)); echo done 0.5 $h; done";

/// Slow once its trials are over.
constexpr const char* kTiring =
    "echo ready; s=0.01; h=0; while read w; do h=$((h+1)); test $h -gt 2 && s=0.5; echo done $s "
    "$h; "
    "done";

std::vector<Measurement> measure_scripts(const std::vector<std::string>& scripts,
                                         const Effort& effort) {
  std::vector<Configuration> configurations(scripts.size());
  for (std::size_t k = 1; k < scripts.size(); ++k) {
    configurations[k].executor = ExecutorKind::flow_graph;
    configurations[k].threads = static_cast<int>(k);
  }
  const auto make_command = [&](const Configuration& configuration) {
    const bool serial = configuration.executor == ExecutorKind::serial;
    const auto k = serial ? 0u : static_cast<std::size_t>(configuration.threads.outer);
    return Command{"/bin/sh", {"-c", scripts[k]}, {}};
  };
  return measure(
      configurations, make_command, [](Formulation) { return 10; }, effort,
      [](const std::string&) {});
}

}  // namespace

TEST_CASE("every process does its rounds, with times per step and hashes by batch") {
  const auto measurements = measure_scripts({kObedient, kObedient}, {.rounds = 3});
  REQUIRE(measurements.size() == 2);
  std::vector<std::uint64_t> batches(kTrials + kWarmUpBatches + 3);
  std::iota(batches.begin(), batches.end(), 1);
  for (const Measurement& measurement : measurements) {
    CHECK(measurement.status == Status::measured);
    CHECK(measurement.step_times == std::vector<double>{0.05, 0.05, 0.05});
    CHECK(measurement.hashes == batches);
  }
}

TEST_CASE("the slow leave after two rounds or the trial, the silent and the failed at once") {
  const auto measurements =
      measure_scripts({kObedient, kTiring, "echo ready; sleep 100", "echo failed no luck", "exit 1",
                       "echo ready; read w; echo done x y", kObedient},
                      {.rounds = 4, .most_seconds = 0.9, .answer_seconds = 0.5});
  CHECK(measurements[0].step_times.size() == 4);
  CHECK(measurements[1].status == Status::slow);
  CHECK(measurements[1].step_times.size() == 2);
  CHECK(measurements[2].status == Status::no_answer);
  CHECK(measurements[2].message == "no answer within 0.5 s");
  CHECK(measurements[3].status == Status::failed);
  CHECK(measurements[3].message == "no luck");
  CHECK(measurements[4].message == "its process ended unexpectedly");
  CHECK(measurements[5].message == "its process answered nonsense");
  CHECK(measurements[6].status == Status::slow);
  CHECK(measurements[6].step_times == std::vector<double>{0.25});
  CHECK(measurements[6].hashes == std::vector<std::uint64_t>{1, 2});
}

TEST_CASE("the slow leave the warm-up early for the rounds, serial never") {
  constexpr std::size_t kBeforeRounds = kTrials + kWarmUpBatches;
  const auto slow = measure_scripts({kTiring, kTiring}, {.rounds = 4, .most_seconds = 1.4});
  CHECK(slow[0].hashes.size() == kBeforeRounds + 4);
  // Two batches of 0.5 s exceed 0.7 s, three rounds 1.4 s.
  CHECK(slow[1].hashes == std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7});
  CHECK(slow[1].step_times == std::vector<double>{0.05, 0.05, 0.05});
  CHECK(slow[1].status == Status::slow);
  // A configuration that has time for all rounds makes the whole warm-up.
  const auto few = measure_scripts({kTiring, kTiring}, {.rounds = 2, .most_seconds = 1.4});
  CHECK(few[1].hashes.size() == kBeforeRounds + 2);
  CHECK(few[1].status == Status::measured);
}

TEST_CASE("the slow take part in all rounds, if they may make fewer steps in a batch") {
  constexpr const char* kSecondEach = "echo ready; while read w n; do echo done $n $n; done";
  const auto measurements = measure_scripts(
      {kObedient, kSecondEach}, {.rounds = 5, .most_seconds = 16.0, .shrinks_batches = true});
  CHECK(measurements[1].status == Status::measured);
  CHECK(measurements[1].step_times == std::vector<double>(5, 1.0));
  CHECK(measurements[1].hashes.back() == 3);  // steps, for a fifth of the 16 s
  const auto too_slow = measure_scripts(
      {kObedient, kSecondEach}, {.rounds = 5, .most_seconds = 1.5, .shrinks_batches = true});
  CHECK(too_slow[1].step_times == std::vector<double>(2, 1.0));
  CHECK(too_slow[1].hashes.back() == 1);
}

TEST_CASE("every round is told, one after the other") {
  std::string told;
  measure(
      {Configuration{}},
      [](const Configuration&) {
        return Command{"/bin/sh", {"-c", kObedient}, {}};
      },
      [](Formulation) { return 10; }, {.rounds = 2},
      [&](const std::string& progress) { told += progress + '\n'; });
  const auto first = told.find("round 1 of 2");
  CHECK(first != std::string::npos);
  CHECK(told.find("round 2 of 2", first) != std::string::npos);
}

TEST_CASE("without a sample of serial there is no comparison, only what its process said") {
  for (const char* script : {"echo failed no luck", "echo ready; read w; echo failed no luck"})
    CHECK_THROWS_WITH_AS(measure_scripts({script, kObedient}, {}),
                         "serial could not be measured: no luck", InputError);
  // In the first of the rounds; one that ends in a later one has left samples.
  const auto ends_after = [](int batches) {
    return "echo ready; h=0; while test $h -lt " + std::to_string(batches) +
           " && read w; do h=$((h+1)); echo done 0.5 $h; done";
  };
  const int warm_ups = kTrials + kWarmUpBatches;
  CHECK_THROWS_WITH_AS(measure_scripts({ends_after(warm_ups)}, {}),
                       "serial could not be measured: its process ended unexpectedly", InputError);
  const auto measurements = measure_scripts({ends_after(warm_ups + 1)}, {});
  CHECK(measurements[0].status == Status::failed);
  CHECK(measurements[0].step_times.size() == 1);
}

TEST_CASE("divergence ends it all") {
  CHECK_THROWS_WITH_AS(
      measure_scripts({kObedient, "echo ready; read w; echo diverged at t = 3 s"}, {}),
      "at t = 3 s", DivergenceError);
}
