// Turns and rounds: the sizes of each alternative's batches, and the statistics of their times.

#include "bench/compare/interleaved.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "bench/compare/statistics.h"

namespace spoke::bench {
namespace {

double time_batch(const Alternative& alternative, int batch) {
  assert(alternative.run && batch > 0);
  using Clock = std::chrono::steady_clock;
  if (alternative.prepare) alternative.prepare();
  const auto begin = Clock::now();
  for (int k = 0; k < batch; ++k) alternative.run();
  return std::chrono::duration<double>(Clock::now() - begin).count() / batch;
}

/// Numbers of runs of an alternative.
struct Repetitions {
  int batch = 1;
  int rounds = 1;
};

Repetitions choose_repetitions(const Alternative& alternative, const Effort& effort) {
  Repetitions plan;
  double seconds = time_batch(alternative, 1);  // a warm-up, too
  if (!alternative.prepare)
    while (seconds * plan.batch < 0.5 * effort.batch_seconds) {
      plan.batch *= 2;
      seconds = time_batch(alternative, plan.batch);
    }
  const double affordable = effort.most_seconds / (seconds * plan.batch);
  plan.rounds = static_cast<int>(std::clamp(affordable, 1.0, 1.0 * effort.rounds));
  return plan;
}

Timing summarise(const Alternative& alternative, const std::vector<double>& times,
                 const std::vector<double>& reference) {
  const compare::Quartiles ratio = compare::quartiles_of(compare::ratios(times, reference));
  return {alternative.name,
          static_cast<int>(times.size()),
          *std::min_element(times.begin(), times.end()),
          compare::median(times),
          ratio.median,
          ratio.low,
          ratio.high};
}

}  // namespace

void take_turns(std::size_t contenders, int rounds,
                const std::function<void(std::size_t, int)>& take_turn) {
  for (int round = 0; round < rounds; ++round)
    for (std::size_t turn = 0; turn < contenders; ++turn)
      take_turn((turn + static_cast<std::size_t>(round)) % contenders, round);
}

std::string describe_turn(int round, int rounds, const std::string& name) {
  return "round " + std::to_string(round + 1) + " of " + std::to_string(rounds) + ": " + name;
}

std::vector<Timing> measure(const std::vector<Alternative>& alternatives, const Effort& effort,
                            const Progress& progress) {
  assert(effort.rounds > 0 && effort.batch_seconds > 0.0);
  const std::size_t count = alternatives.size();
  std::vector<Repetitions> plans;
  for (const Alternative& alternative : alternatives) {
    progress("warming up " + alternative.name);
    plans.push_back(choose_repetitions(alternative, effort));
  }
  int rounds = 0;
  for (const Repetitions& plan : plans) rounds = std::max(rounds, plan.rounds);

  std::vector<std::vector<double>> times(count);
  take_turns(count, rounds, [&](std::size_t k, int round) {
    if (round >= plans[k].rounds) return;
    progress(describe_turn(round, rounds, alternatives[k].name));
    times[k].push_back(time_batch(alternatives[k], plans[k].batch) * alternatives[k].scale);
  });
  std::vector<Timing> timings;
  for (std::size_t k = 0; k < count; ++k) {
    const auto reference = static_cast<std::size_t>(alternatives[k].reference);
    assert(reference < count);
    timings.push_back(summarise(alternatives[k], times[k], times[reference]));
  }
  return timings;
}

}  // namespace spoke::bench
