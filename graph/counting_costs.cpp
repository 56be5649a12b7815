#include "graph/counting_costs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "graph/executor_kinds.h"
#include "graph/quantiles.h"
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

/// Two chains of nodes that share nothing but the flow graph that counts them.
class TwoChains {
 public:
  /// Of so many nodes each that are busy for that long [s].
  TwoChains(int links, double busy) : links_(links), graph_(make(busy)) {}
  TwoChains(const TwoChains&) = delete;  // nodes know where to tell
  TwoChains& operator=(const TwoChains&) = delete;

  /// What a run takes one thread [s].
  double run_alone() const {
    const auto executor = make_flow_graph_executor(graph_, plan_of_single_nodes(graph_), 1);
    return seconds_per_run(*executor, 60);
  }

  /// What a run takes two threads, a chain each [s]. How far away a processor finds the place of
  /// counting depends on where in memory it lies, by some 10 %: the lower quartile of several.
  /// Nothing if another thread never comes, which on a busy machine may happen.
  std::optional<double> run_together(int places) {
    std::vector<std::unique_ptr<Executor>> executors;  // all live, so that each has its own place
    std::vector<double> seconds;
    for (int k = 0; k < places; ++k) {
      Plan plan = plan_of_single_nodes(graph_);
      std::vector<int> one_place(static_cast<std::size_t>(plan.cluster_count()), 0);
      executors.push_back(
          make_flow_graph_executor(graph_, std::move(plan), 2, std::move(one_place)));
      const std::vector<double> runs = runs_together(*executors.back());
      if (!runs.empty()) seconds.push_back(lower_quartile(runs));
    }
    if (seconds.empty()) return {};
    return lower_quartile(std::move(seconds));
  }

 private:
  StepGraph make(double busy) {
    StepGraphBuilder builder;
    for (std::thread::id& thread : threads_) {
      const PartId chain = builder.add_part("chain", {});
      for (int link = 0; link < links_; ++link)
        builder.add_node({"link"}, reads(chain), writes(chain),
                         [this, &thread, link, busy]() noexcept {
                           if (busy > 0.0) be_busy(busy);
                           if (link == links_ / 2) thread = std::this_thread::get_id();
                         });
    }
    return builder.build();
  }

  // Runs in which each thread had a chain. A sleeping thread takes milliseconds to join, on a
  // virtual machine tens of them.
  std::vector<double> runs_together(Executor& executor) {
    constexpr std::size_t runs = 60;
    constexpr double patience = 0.1;  // s
    std::vector<double> seconds;
    for (const std::uint64_t begin = time_stamp();
         seconds.size() < runs && seconds_since(begin) < patience;) {
      const std::uint64_t run = time_stamp();
      executor.run();
      const double taken = seconds_since(run);
      if (threads_[0] != threads_[1]) seconds.push_back(taken);
    }
    return seconds;
  }

  int links_;
  std::array<std::thread::id, 2> threads_;
  StepGraph graph_;
};

/// What a link takes: so much longer are runs of more of them.
class Links {
 public:
  explicit Links(double busy) : few_(kFew, busy), many_(kMany, busy) {}

  /// One thread that runs both chains [s].
  double alone() const { return (many_.run_alone() - few_.run_alone()) / (2 * (kMany - kFew)); }
  /// Each of two threads [s]; nothing if there are not two.
  std::optional<double> together(int places) {
    const std::optional<double> few = few_.run_together(places);
    const std::optional<double> many = many_.run_together(places);
    if (!few || !many) return {};
    return (*many - *few) / (kMany - kFew);
  }

 private:
  static constexpr int kFew = 40, kMany = 120;
  TwoChains few_, many_;
};

}  // namespace

CountingCosts measure_counting(int places) {
  if (available_threads() <= 1) return {};
  constexpr double long_busy = 0.3e-6;  // s, against what counting takes
  Links long_links(long_busy);
  Links empty_links(0.0);
  const auto together = long_links.together(places);
  const auto at_most = empty_links.together(places);
  if (!together || !at_most) return {};
  return {std::clamp(*together - long_links.alone(), 0.0, 1e-6),
          std::clamp(0.5 * *at_most, 1e-9, 1e-6)};
}

}  // namespace spoke::graph
