// Turns and rounds: how long each alternative's batches are, and what their times come to.

#include "bench/interleaved.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/progress.h"

namespace spoke::bench {
namespace {

double time_batch(const Alternative& alternative, int batch) {
  using Clock = std::chrono::steady_clock;
  if (alternative.prepare) alternative.prepare();
  const auto begin = Clock::now();
  for (int k = 0; k < batch; ++k) alternative.run();
  return std::chrono::duration<double>(Clock::now() - begin).count() / batch;
}

/// How often an alternative is run.
struct Plan {
  int batch = 1;
  int rounds = 1;
};

Plan make_plan(const Alternative& alternative, const Effort& effort) {
  Plan plan;
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

/// The value below which `share` of the values lie.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

Timing summarise(const Alternative& alternative, const std::vector<double>& times,
                 const std::vector<double>& reference) {
  std::vector<double> ratios;
  const std::size_t common = std::min(times.size(), reference.size());
  for (std::size_t k = 0; k < common; ++k) ratios.push_back(times[k] / reference[k]);
  return {alternative.name,
          static_cast<int>(times.size()),
          *std::min_element(times.begin(), times.end()),
          quantile(times, 0.5),
          quantile(ratios, 0.5),
          quantile(ratios, 0.25),
          quantile(ratios, 0.75)};
}

}  // namespace

std::vector<Timing> measure(const std::vector<Alternative>& alternatives, const Effort& effort) {
  const std::size_t count = alternatives.size();
  std::vector<Plan> plans;
  for (const Alternative& alternative : alternatives) {
    show_progress("warming up " + alternative.name);
    plans.push_back(make_plan(alternative, effort));
  }
  int rounds = 0;
  for (const Plan& plan : plans) rounds = std::max(rounds, plan.rounds);

  std::vector<std::vector<double>> times(count);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t turn = 0; turn < count; ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(round)) % count;
      if (round >= plans[k].rounds) continue;
      show_progress("round " + std::to_string(round + 1) + " of " + std::to_string(rounds) + ": " +
                    alternatives[k].name);
      times[k].push_back(time_batch(alternatives[k], plans[k].batch) * alternatives[k].scale);
    }
  std::vector<Timing> timings;
  for (std::size_t k = 0; k < count; ++k)
    timings.push_back(summarise(alternatives[k], times[k], times[alternatives[k].reference]));
  return timings;
}

}  // namespace spoke::bench
