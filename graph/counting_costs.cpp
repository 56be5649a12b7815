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
#include "graph/time_stamp.h"
#include "graph/timed_runs.h"

namespace spoke::graph {
namespace {

constexpr int kLinks = 100;

/// Two chains of nodes that share nothing but the flow graph that counts them.
class TwoChains {
 public:
  /// Of nodes that are busy for that long [s].
  explicit TwoChains(double busy) : graph_(make(busy)) {}
  TwoChains(const TwoChains&) = delete;  // nodes know where to tell
  TwoChains& operator=(const TwoChains&) = delete;

  /// What a link takes one thread that runs both chains [s].
  double link_alone() const {
    const auto executor = make_flow_graph_executor(graph_, plan_of_single_nodes(graph_), 1);
    return seconds_per_run(*executor, 60) / (2 * kLinks);
  }

  /// What a link takes each of two threads [s]. How far away a processor finds the place of
  /// counting depends on where in memory that lies, by some 10 %: the lower quartile of several.
  /// Nothing if another thread never comes, which on a busy machine may happen.
  std::optional<double> link_together(int places, double run_and_handover) {
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
    return (lower_quartile(std::move(seconds)) - run_and_handover) / kLinks;
  }

 private:
  StepGraph make(double busy) {
    StepGraphBuilder builder;
    for (std::thread::id& thread : threads_) {
      const PartId chain = builder.add_part("chain", {});
      for (int link = 0; link < kLinks; ++link)
        builder.add_node({"link"}, reads(chain), writes(chain), [&thread, link, busy]() noexcept {
          if (busy > 0.0) be_busy(busy);
          if (link == kLinks / 2) thread = std::this_thread::get_id();
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

  std::array<std::thread::id, 2> threads_;
  StepGraph graph_;
};

}  // namespace

CountingCosts measure_counting(int places, double run_and_handover) {
  if (available_threads() <= 1) return {};
  constexpr double long_busy = 0.3e-6;  // s, against what counting takes
  TwoChains long_links(long_busy);
  TwoChains empty_links(0.0);
  const std::optional<double> together = long_links.link_together(places, run_and_handover);
  if (!together) return {};
  const double wait = *together - long_links.link_alone();
  const double service = 0.5 * empty_links.link_together(places, run_and_handover).value_or(0.0);
  return {std::clamp(wait, 0.0, 1e-6), std::clamp(service, 1e-9, 1e-6)};
}

}  // namespace spoke::graph
