// Trials, warm-up and rounds of the child processes, and the reasons for which one leaves early.

#include "bench/compare/rounds.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <sstream>

#include "models/error.h"

namespace spoke::compare {
namespace {

/// One configuration and its process while it is measured.
struct Contender {
  Measurement measurement;
  std::unique_ptr<Child> child;  ///< null once it has left
  std::int64_t batch = 1;
  double spent = 0.0;  ///< time spent in timed batches [s]

  bool takes_part() const { return child != nullptr; }
};

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

void leave(Contender& contender, Status status, std::string message) {
  contender.child.reset();
  contender.measurement.status = status;
  contender.measurement.message = std::move(message);
}

/// Receives the next answer. Returns whether it begins with `expected`; `rest` is then the text
/// behind that. Otherwise the contender has left.
bool expect(Contender& contender, const std::string& expected, double seconds, std::string& rest) {
  const Answer answer = contender.child->receive(seconds);
  if (answer.kind == Answer::Kind::late) {
    leave(contender, Status::no_answer, "no answer within " + seconds_text(seconds));
    return false;
  }
  if (answer.kind == Answer::Kind::ended) {
    leave(contender, Status::failed, "its process ended unexpectedly");
    return false;
  }
  const auto space = std::min(answer.text.find(' '), answer.text.size());
  const std::string word = answer.text.substr(0, space);
  rest = answer.text.substr(std::min(space + 1, answer.text.size()));
  if (word == "diverged") throw DivergenceError(rest);
  if (word == expected) return true;
  leave(contender, Status::failed, word == "failed" ? rest : "its process answered nonsense");
  return false;
}

std::int64_t trial_of(std::int64_t batch) { return std::max<std::int64_t>(1, batch / 4); }

/// Runs steps. Returns the time per step [s]; negative if the contender has left.
double run_steps(Contender& contender, std::int64_t steps, double seconds_allowed) {
  contender.child->go_on();
  contender.child->send("run " + std::to_string(steps));
  std::string rest;
  if (!expect(contender, "done", seconds_allowed, rest)) return -1.0;
  contender.child->halt();
  std::istringstream words(rest);
  double seconds = -1.0;
  std::uint64_t hash = 0;
  if (!(words >> seconds >> hash) || !(seconds > 0.0)) {
    leave(contender, Status::failed, "its process answered nonsense");
    return -1.0;
  }
  contender.measurement.hashes.push_back(hash);
  return seconds / static_cast<double>(steps);
}

bool is_serial(const Contender& contender) {
  return contender.measurement.configuration.executor == ExecutorKind::serial;
}

/// Runs the warm-up. A contender that will leave the rounds early, at the pace of its last batch,
/// spends at most half of its time on it.
void warm_up(Contender& contender, const Effort& effort) {
  double last = 0.0, spent = 0.0;
  for (int k = 0; k < kWarmUpBatches && contender.takes_part(); ++k) {
    const bool slow = last * effort.rounds > effort.most_seconds;
    if (!is_serial(contender) && slow && spent > 0.5 * effort.most_seconds) return;
    last = run_steps(contender, contender.batch, effort.answer_seconds) *
           static_cast<double>(contender.batch);
    spent += last;
  }
}

/// Returns the size of a batch with which all rounds together take no longer than allowed, at this
/// pace; at least one step.
std::int64_t batch_in_time(std::int64_t batch, double step, const Effort& effort) {
  const double most = effort.most_seconds / (step * effort.rounds);
  return std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::min(most, static_cast<double>(batch))));
}

void start(Contender& contender, const Command& command, const Effort& effort) {
  contender.child = std::make_unique<Child>(command);
  std::string rest;
  if (!expect(contender, "ready", effort.start_seconds, rest)) return;
  double step = 0.0;
  for (int k = 0; k < kTrials && contender.takes_part(); ++k)
    step = run_steps(contender, trial_of(contender.batch), effort.answer_seconds);
  const double batch_seconds = step * static_cast<double>(contender.batch);
  if (effort.shrinks_batches && !is_serial(contender) && contender.takes_part()) {
    contender.batch = batch_in_time(contender.batch, step, effort);
  } else if (!is_serial(contender) && batch_seconds > 0.5 * effort.most_seconds) {
    contender.measurement.step_times.push_back(step);
    leave(contender, Status::slow, "");
  }
  warm_up(contender, effort);
}

void take_turn(Contender& contender, int round, const Effort& effort) {
  constexpr int kLeastRounds = 2;
  if (!is_serial(contender) && round >= kLeastRounds && contender.spent > effort.most_seconds) {
    leave(contender, Status::slow, "");
    return;
  }
  const double step = run_steps(contender, contender.batch, effort.answer_seconds);
  if (step < 0.0) return;
  contender.spent += step * static_cast<double>(contender.batch);
  contender.measurement.step_times.push_back(step);
}

/// Throws InputError if a serial contender has left without a sample: it is the reference.
void require_reference(const Contender& contender) {
  if (!is_serial(contender) || contender.takes_part()) return;
  if (!contender.measurement.step_times.empty()) return;
  throw InputError("serial could not be measured: " + contender.measurement.message);
}

std::string full_name(const Configuration& configuration) {
  return std::string(name_of(configuration.formulation)) + ", " + name_of(configuration);
}

std::vector<Contender> start_all(const std::vector<Configuration>& configurations,
                                 const MakeCommand& make_command, const BatchSize& batch_size,
                                 const Effort& effort, const Progress& progress) {
  std::vector<Contender> contenders;
  for (const Configuration& configuration : configurations) {
    progress("warming up: " + full_name(configuration));
    Contender& contender = contenders.emplace_back();
    contender.measurement.configuration = configuration;
    contender.batch = batch_size(configuration.formulation);
    start(contender, make_command(configuration), effort);
    require_reference(contender);
  }
  return contenders;
}

}  // namespace

std::string_view name_of(Status status) {
  switch (status) {
    case Status::measured:
      return "measured";
    case Status::slow:
      return "slow";
    case Status::no_answer:
      return "no_answer";
    case Status::failed:
      break;
  }
  return "failed";
}

std::int64_t steps_of(std::int64_t batch, int rounds) {
  return kTrials * trial_of(batch) + (kWarmUpBatches + rounds) * batch;
}

std::vector<Measurement> measure(const std::vector<Configuration>& configurations,
                                 const MakeCommand& make_command, const BatchSize& batch_size,
                                 const Effort& effort, const Progress& progress) {
  assert(!configurations.empty());
  std::vector<Contender> contenders =
      start_all(configurations, make_command, batch_size, effort, progress);
  bench::take_turns(contenders.size(), effort.rounds, [&](std::size_t k, int round) {
    Contender& contender = contenders[k];
    if (!contender.takes_part()) return;
    progress(
        bench::describe_turn(round, effort.rounds, full_name(contender.measurement.configuration)));
    take_turn(contender, round, effort);
    require_reference(contender);
  });
  progress("");
  std::vector<Measurement> measurements;
  for (Contender& contender : contenders) measurements.push_back(std::move(contender.measurement));
  return measurements;
}

}  // namespace spoke::compare
