// Starts threads that take runs and bring results.

#include "program/study/runner.h"

#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace spoke::study {

JournalExchange::JournalExchange(Journal& journal, std::int64_t runs, Progress progress)
    : journal_(journal), runs_(runs), progress_(std::move(progress)) {}

std::optional<std::int64_t> JournalExchange::take() {
  const std::lock_guard lock(mutex_);
  while (next_ < runs_ && journal_.has(next_)) ++next_;
  if (is_stopped_ || next_ >= runs_) return {};
  return next_++;
}

void JournalExchange::put(const RunResult& result) {
  const std::lock_guard lock(mutex_);
  journal_.append(result);
  if (!progress_(journal_.count())) is_stopped_ = true;
}

void JournalExchange::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
}

void make_runs(const Study& study, const Sampling& sampling, int threads, RunExchange& exchange) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      RunMaker maker(study, sampling);
      while (const std::optional<std::int64_t> run = exchange.take())
        exchange.put(maker.make(*run));
    } catch (...) {
      exchange.stop();
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace spoke::study
