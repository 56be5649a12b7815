#pragma once

// Makes the runs of a study, many at once.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "engine/study/journal.h"
#include "engine/study/sampling.h"
#include "engine/study/single_run.h"
#include "engine/study/study.h"

namespace spoke::study {

/// Where threads get runs from, and bring them to. Its functions may be called by several threads
/// at once.
class RunExchange {
 public:
  virtual ~RunExchange() = default;
  RunExchange() = default;
  RunExchange(const RunExchange&) = delete;
  RunExchange& operator=(const RunExchange&) = delete;

  /// The next run to make; nothing if there is none left, or the study is to end.
  virtual std::optional<std::int64_t> take() = 0;
  /// Takes a finished run.
  virtual void put(const RunResult& result) = 0;
  /// Ends the study: no more runs are handed out.
  virtual void stop() = 0;
};

/// Hands out the runs that a journal has not, in order, and writes them to it.
class JournalExchange : public RunExchange {
 public:
  /// progress: told after each run, by one thread at a time, how many the journal has; returns
  /// whether to go on.
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
/// results do not depend on their number. What a thread throws ends the others after their runs,
/// and is thrown.
void make_runs(const Study& study, const Sampling& sampling, int threads, RunExchange& exchange);

}  // namespace spoke::study
