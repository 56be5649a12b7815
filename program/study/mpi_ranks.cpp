// Sends runs and results as messages between the first rank and the others.

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "program/study/ranks.h"

namespace spoke::study {
namespace {

// Tags of messages to the first rank: a thread asks for a run; a result; a rank has ended.
constexpr int kAsk = 1, kResult = 2, kEnd = 3;
// Tag of messages from the first rank: a run, or kNoRun.
constexpr int kRun = 4;
constexpr std::int64_t kNoRun = -1;

/// Asks the first rank for runs. Threads take turns, since it answers at once.
class RemoteExchange : public RunExchange {
 public:
  std::optional<std::int64_t> take() override {
    const std::lock_guard lock(mutex_);
    std::int64_t run = kNoRun;
    MPI_Send(nullptr, 0, MPI_BYTE, 0, kAsk, MPI_COMM_WORLD);
    MPI_Recv(&run, 1, MPI_INT64_T, 0, kRun, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (run == kNoRun) return {};
    return run;
  }
  void put(const RunResult& result) override {
    const std::string bytes = pack(result);
    const std::lock_guard lock(mutex_);
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, kResult, MPI_COMM_WORLD);
  }
  /// Does nothing: an exception ends this process, and through MPI all.
  void stop() override {}

 private:
  std::mutex mutex_;
};

/// Answers the other ranks until all have ended. An exception of the exchange is kept until then,
/// so that they end in order, too.
class Server {
 public:
  Server(int others, JournalExchange& exchange) : others_(others), exchange_(exchange) {}

  void serve() {
    while (others_ > 0) {
      int has_message = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &has_message, &status);
      if (has_message != 0) {
        ++messages_;
        answer(status);
      } else {
        std::this_thread::sleep_for(pause());
      }
    }
  }
  std::exception_ptr failure() const { return failure_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Returns how long to leave the processor to this rank's own runs: a small part of the mean time
  /// between messages. A rank that asks waits that long; each look costs some microseconds.
  Clock::duration pause() const {
    constexpr Clock::duration kLeast = std::chrono::microseconds(50);
    constexpr Clock::duration kMost = std::chrono::milliseconds(2);
    constexpr std::int64_t kLooksPerMessage = 32;
    if (messages_ == 0) return kLeast;
    return std::clamp((Clock::now() - start_) / (messages_ * kLooksPerMessage), kLeast, kMost);
  }

  void answer(const MPI_Status& status) {
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    bytes_.resize(static_cast<std::size_t>(size));
    MPI_Recv(bytes_.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    if (status.MPI_TAG == kEnd) --others_;
    if (status.MPI_TAG == kAsk) {
      const std::int64_t run = exchange_.take().value_or(kNoRun);
      MPI_Send(&run, 1, MPI_INT64_T, status.MPI_SOURCE, kRun, MPI_COMM_WORLD);
    }
    if (status.MPI_TAG == kResult)
      keep_failure([this] { exchange_.put(unpack(bytes_, "a message")); });
  }
  template <class Work>
  void keep_failure(const Work& work) {
    try {
      if (!failure_) work();
    } catch (...) {
      failure_ = std::current_exception();
      exchange_.stop();
    }
  }

  int others_;
  JournalExchange& exchange_;
  Clock::time_point start_ = Clock::now();
  std::int64_t messages_ = 0;
  std::string bytes_;
  std::exception_ptr failure_;
};

}  // namespace

void Ranks::make_runs_together(const Study& study, const Sampling& sampling, int threads,
                               JournalExchange& exchange) {
  std::exception_ptr failure;
  std::thread own([&] {
    try {
      make_runs(study, sampling, threads, exchange);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  Server server(count() - 1, exchange);
  server.serve();
  own.join();
  launch_.release();
  if (!failure) failure = server.failure();
  if (failure) std::rethrow_exception(failure);
}

void Ranks::make_runs_for_first(const Study& study, const Sampling& sampling, int threads) {
  RemoteExchange exchange;
  make_runs(study, sampling, threads, exchange);
  MPI_Send(nullptr, 0, MPI_BYTE, 0, kEnd, MPI_COMM_WORLD);
}

}  // namespace spoke::study
