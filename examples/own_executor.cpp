// An executor of one's own: threads that share a list of the nodes that may run. It gives the same
// bits as the executor "serial", in steps one by one and in windows of steps.

#include <spoke/spoke.h>

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

namespace graph = spoke::graph;

class SharedList final : public graph::Executor {
 public:
  SharedList(const graph::StepGraph& steps, int threads) : graph_(steps), threads_(threads) {
    for (int t = 1; t < threads; ++t) workers_.emplace_back([this, t] { work(t); });
  }
  ~SharedList() override {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& worker : workers_) worker.join();
  }
  void run() override {
    std::unique_lock lock(mutex_);
    waits_for_.clear();
    left_ = graph_.node_count();
    for (int i = 0; i < left_; ++i) {
      waits_for_.push_back(graph_.predecessors({i}).size());
      if (waits_for_.back() == 0) ready_.push_back({i});
    }
    lock.unlock();
    changed_.notify_all();
    work(0);
  }
  std::string_view name() const override { return "shared_list"; }
  graph::Threads threads() const override { return threads_; }

 private:
  // The mutex makes a node's writes visible to those that wait for it.
  void work(int thread) {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock,
                    [&] { return !ready_.empty() || (thread == 0 ? left_ == 0 : is_ending_); });
      if (ready_.empty()) return;
      const graph::NodeId node = ready_.back();
      ready_.pop_back();
      lock.unlock();
      run_on_thread(thread, graph_, {&node, 1});
      lock.lock();
      for (const graph::NodeId next : graph_.successors(node))
        if (--waits_for_[next.index] == 0) ready_.push_back(next);
      --left_;
      changed_.notify_all();
    }
  }

  const graph::StepGraph& graph_;
  int threads_, left_ = 0;
  bool is_ending_ = false;
  std::vector<std::size_t> waits_for_;  // by node, the number of predecessors that have not run
  std::vector<graph::NodeId> ready_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::thread> workers_;
};

int main() {
  const spoke::Scenario scenario = spoke::parse_scenario(R"(
[hub]
drive = { kind = "spin_up", speed = 4.0, ramp = 15.0 }
[blade]
count = 3
length = 8.0
bodies = 4
elements = 16
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.005
duration = 1.0
)",
                                                         "own_executor");
  spoke::Simulation serial(scenario, {.executor = spoke::ExecutorKind::serial});
  serial.run_until(1.0);
  bool is_equal = true;
  for (const int window : {1, 10}) {
    spoke::SimulationOptions options{.window = window};
    options.make_executor = [](const graph::StepGraph& steps) {
      return std::make_unique<SharedList>(steps, 2);
    };
    spoke::Simulation simulation(scenario, options);
    simulation.run_until(1.0);
    std::printf("%s, state %016llx\n", simulation.executor_description().c_str(),
                static_cast<unsigned long long>(simulation.state_hash()));
    is_equal &= simulation.state_hash() == serial.state_hash();
  }
  return is_equal ? 0 : 1;
}
