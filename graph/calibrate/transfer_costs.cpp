// Measures how much longer a node takes whose data another thread has changed.

#include "graph/calibrate/transfer_costs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "graph/calibrate/quantiles.h"
#include "graph/calibrate/timed_runs.h"
#include "graph/execute/executor_kinds.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

// A node that changes so many doubles of its own, and how long it took where.
struct Toucher {
  alignas(128) std::array<double, 512> data{};  // 128: processors fetch cache lines in pairs
  alignas(128) double seconds = 0.0;
  std::thread::id thread;

  void touch(std::size_t doubles) noexcept {
    const std::uint64_t begin = time_stamp();
    for (std::size_t k = 0; k < doubles; ++k) data[k] += 1.0;
    std::atomic_thread_fence(std::memory_order_seq_cst);  // what is under way arrives
    seconds = seconds_since(begin);
    thread = std::this_thread::get_id();
  }
  // Long enough that another thread comes for one of two.
  void touch_and_wait(std::size_t doubles) noexcept {
    const std::uint64_t begin = time_stamp();
    touch(doubles);
    while (seconds_since(begin) < 10e-6) {
    }
  }
};

// A node changes the data of two, which then run, one on its thread and one on another.
class TwoTouchers {
 public:
  explicit TwoTouchers(std::size_t doubles)
      : graph_(make(doubles)),
        executor_(make_flow_graph_executor(graph_, plan_of_single_nodes(graph_), 2)) {}
  TwoTouchers(const TwoTouchers&) = delete;  // nodes know what to touch
  TwoTouchers& operator=(const TwoTouchers&) = delete;

  // The median of so many seconds [s]; nothing if the other thread never came.
  std::optional<double> extra_seconds(double time) {
    std::vector<double> extra;
    for (const std::uint64_t begin = time_stamp(); seconds_since(begin) < time;) {
      executor_->run();
      if (a_.thread == b_.thread) continue;
      extra.push_back(a_.thread == maker_ ? b_.seconds - a_.seconds : a_.seconds - b_.seconds);
    }
    if (extra.empty()) return {};
    return median(std::move(extra));
  }

 private:
  StepGraph make(std::size_t doubles) {
    StepGraphBuilder builder;
    const PartId data = builder.add_part("data", {});
    builder.add_node({"both"}, {}, writes(data), [this, doubles]() noexcept {
      a_.touch(doubles);
      b_.touch(doubles);
      maker_ = a_.thread;
    });
    for (Toucher* toucher : {&a_, &b_})
      builder.add_node({"one"}, reads(data), {},
                       [toucher, doubles]() noexcept { toucher->touch_and_wait(doubles); });
    return builder.build();
  }

  Toucher a_, b_;
  std::thread::id maker_;
  StepGraph graph_;
  std::unique_ptr<Executor> executor_;
};

// How much longer it takes on the other thread [s]. How far away a processor finds data depends on
// where in memory they lie, by some 40 %: the mean of several places, as those of a step are.
double measure_moved(int places, double time, std::size_t doubles) {
  std::vector<std::unique_ptr<TwoTouchers>> touchers;  // all live, so that each has its own place
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < places; ++k) {
    touchers.push_back(std::make_unique<TwoTouchers>(doubles));
    const std::optional<double> seconds = touchers.back()->extra_seconds(time / places);
    sum += seconds.value_or(0.0);
    count += seconds ? 1 : 0;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

// Processors fetch the lines of a range one right after the other.
Transfer measure_transfer(int places, double time) {
  constexpr std::size_t line = 8, many_lines = 512;  // doubles
  constexpr auto bytes = static_cast<double>(sizeof(double));
  const double one = measure_moved(places, time, line);
  const double many = measure_moved(places, time, many_lines);
  const double per_double = std::max(0.0, (many - one) / (many_lines - line));
  return {std::clamp(one - line * per_double, 0.0, 1e-6), std::min(per_double / bytes, 2e-9)};
}

}  // namespace spoke::graph
