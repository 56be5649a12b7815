#pragma once

// Makes the runs of a study, many at once.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "program/study/journal.h"
#include "program/study/sampling.h"
#include "program/study/single_run.h"
#include "program/study/study.h"

namespace spoke::study {

/// Hands runs out to threads and collects them. Several threads may call its functions at once.
class RunExchange {
 public:
  virtual ~RunExchange() = default;
  RunExchange() = default;
  RunExchange(const RunExchange&) = delete;
  RunExchange& operator=(const RunExchange&) = delete;

  /// Returns the next run to make; none if no run is left, or the study is to end.
  virtual std::optional<std::int64_t> take() = 0;
  /// Takes a finished run.
  virtual void put(const RunResult& result) = 0;
  /// Ends the study: no more runs are handed out.
  virtual void stop() = 0;
};

/// Hands out the runs that a journal lacks, in order, and writes them to it.
class JournalExchange : public RunExchange {
 public:
  /// A function that is called after each run, by one thread at a time, with the number of runs
  /// that the journal has; it returns whether to go on.
  using Progress = std::function<bool(std::int64_t done)>;

  JournalExchange(Journal& journal, std::int64_t runs, Progress progress);

  std::optional<std::int64_t> take() override;
  void put(const RunResult& result) override;
  void stop() override;

 private:
  std::mutex mutex_;
  Journal& journal_;
  std::int64_t runs_;
  std::int64_t next_ = 0;
  bool is_stopped_ = false;
  Progress progress_;
};

/// Makes runs on so many threads until there are none. Each run is made by one thread, so that
/// results do not depend on their number. An exception in one thread ends the others after their
/// runs, and is thrown again.
void make_runs(const Study& study, const Sampling& sampling, int threads, RunExchange& exchange);

}  // namespace spoke::study
